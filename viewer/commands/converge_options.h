// What `glint converge` was asked for.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/report/convergence_run.h"
#include "engine/scene/scene.h"
#include "viewer/commands/scene_opening.h"
#include "viewer/commands/scene_overrides.h"

namespace glint {

class Command;

struct ConvergeOptions {
    std::string scene;
    std::string out;
    std::string reference;
    double makeReference = 0.0;  ///< seconds; 0: not asked for
    std::string referenceVariant;
    bool anyReference = false;
    bool subtractReference = false;
    std::string integrators = "pt,sppm";
    double seconds = 0.0;
    uint32_t passes = 0;
    int seeds = 4;
    int points = 16;
    int images = 3;
    std::vector<double> imageTimes;  ///< empty: as `images` says
    SceneOverrides overrides;
    float exposure = 0.0f;
    int threads = 0;
    std::string backend = "cpu";
    bool overwrite = false;
    LoadOptions load;
    std::string json;
    std::string command;  ///< as written, quoted for a shell
};

void addConvergeOptions(const Command& command, ConvergeOptions* options);

/// "glint converge scenes/cornell.json --time 10 ...": every option that was given.
std::string commandAsWritten(const Command& command);

/// Seconds when neither --time nor --passes is given.
constexpr double kDefaultConvergeSeconds = 10.0;

/// What can be said without reading the scene. Error: options that contradict each other or lack something.
Status checkConvergeOptions(const ConvergeOptions& options);

/// All but the seeds, which depend on the reference's. Error: a variant that makes no sense.
Result<ConvergencePlan> planOf(const ConvergeOptions& options, const SceneDescription& scene);

}  // namespace glint
