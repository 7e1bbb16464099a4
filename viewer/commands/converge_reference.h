// Where `glint converge` gets its reference: given, left by an earlier run, or made now.
//
// Rendering and files are engine/report's; what is said about it to the user is here.
#pragma once

#include <optional>

#include "engine/report/convergence_reference.h"
#include "engine/report/convergence_run.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/converge_options.h"
#include "viewer/commands/converge_output.h"
#include "viewer/commands/converge_print.h"

namespace glint {

/// Unlike makeBackend(), refuses what would run on something else.
Result<std::unique_ptr<Backend>> exactBackend(const VariantSettings& settings);

class ConvergeReference {
  public:
    using Found = Result<std::optional<ReferenceImage>>;

    ConvergeReference(const ConvergeOptions& options, const ConvergeFolder& folder,
                      const SceneDescription& scene, const ConvergencePlan& plan, const ConvergenceHost& host,
                      PartLine* line)
        : options_(options), folder_(folder), scene_(scene), plan_(plan), host_(host), line_(*line) {}

    /// Nothing: interrupted before there was one. It lies in the folder, which is made.
    Found find();

    /// Of a failed find(): until something is rendered, the input is at fault.
    ExitCode failureCode() const { return failureCode_; }

  private:
    bool findPrecision(ReferencePlan* wanted) const;
    Found takeGiven();
    Found takeCached(ReferencePlan* wanted);
    Found makeNew(ReferencePlan wanted);
    void announce(const ReferencePlan& wanted, const ReferenceImage& made) const;

    const ConvergeOptions& options_;
    const ConvergeFolder& folder_;
    const SceneDescription& scene_;
    const ConvergencePlan& plan_;
    const ConvergenceHost& host_;
    PartLine& line_;
    ExitCode failureCode_ = kExitBadInput;
};

}  // namespace glint
