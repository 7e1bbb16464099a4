// Options that change a scene's own settings: one for each field that names an option, and the
// picture's size.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "engine/scene/text_settings.h"

namespace glint {

class Command;

struct SceneOverrides {
    struct Given {
        const TextSetting* setting;
        std::string text = {};                  ///< empty: not given
        std::vector<std::string> numbers = {};  ///< of a vector, in its place
    };
    std::string size;
    bool asOriginal = false;
    std::vector<Given> settings;
};

/// Adds `--size` and the options whose names `wanted` takes; all of them without one. `overrides` must
/// outlive the parsing.
void addSceneOverrides(const Command& command, SceneOverrides* overrides,
                       const std::function<bool(std::string_view option)>& wanted = {});

/// Those of them that the user gave, but for one integrator's: " --size 64x64 --fov 30".
std::string sceneOptionsAsWritten(const Command& command);

/// Error: a value that makes no sense, or settings of another integrator.
Status applyTo(const SceneOverrides& overrides, SceneDescription* scene);

}  // namespace glint
