// A render session that runs from limit to limit and rests in between, so that looking at its picture costs
// no render time.
//
// What convergence_run and convergence_reference render with. Waiting, interrupts and progress are here, and
// nothing about errors.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "engine/base/result.h"
#include "engine/render/render_session.h"
#include "engine/report/convergence_variant.h"

namespace glint {

/// What a convergence run needs of the program around it. Functions may be empty except makeBackend.
struct ConvergenceHost {
    /// Error: unknown, or not there: a back end that stands in for another would falsify a comparison.
    std::function<Result<std::unique_ptr<Backend>>(const VariantSettings& settings)> makeBackend;
    std::function<bool()> stopWanted;                    ///< polled a few times a second
    std::function<void(const std::string&)> onPart;      ///< a new part begins, such as "path, seed 1 of 4"
    std::function<void(const std::string&)> onProgress;  ///< a few times a second

    bool mustStop() const { return stopWanted && stopWanted(); }
};

class MeasuredSession {
  public:
    enum class Outcome { Reached, Interrupted, Failed };

    /// Starts cold: a back end, threads and a film of its own. `scene` carries all settings but those of
    /// `settings`, which replace its own. It must stay alive.
    static Result<std::unique_ptr<MeasuredSession>> start(const SceneDescription& scene,
                                                          const VariantSettings& settings,
                                                          const ConvergenceHost& host);

    /// Renders until one of the limits is reached. Reached at once when one has been already.
    Outcome runTo(const StopLimits& limits, const std::string& progressPrefix = {});

    /// Throws the film away and begins with another seed, without building anything anew; at rest only.
    void restartWithSeed(uint32_t seed);

    /// The film as it is; after runTo() has Reached. Nothing: there is none.
    std::optional<SessionCapture> capture() { return session_->capture(); }
    SessionStatus status() const { return session_->status(); }

  private:
    MeasuredSession(std::shared_ptr<SceneDescription> scene, const ConvergenceHost& host,
                    std::unique_ptr<Backend> backend, int threads);

    std::shared_ptr<const SceneDescription> scene_;
    const ConvergenceHost& host_;
    std::unique_ptr<RenderSession> session_;
    uint32_t aovs_ = 0;      ///< that captures carry
    EditTicket posted_ = 0;  ///< of the newest edit
};

}  // namespace glint
