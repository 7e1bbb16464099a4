// The settings that text can change: options of the command line, and variants of `glint converge`. They are
// the fields that name an option or a variant, and the photons' first radius, which is two fields.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/camera.h"
#include "engine/scene/render_options.h"

namespace glint {

/// Where settings are written; what is null cannot be set.
struct SettingTargets {
    Camera* camera = nullptr;
    RenderOptions* options = nullptr;
    SppmOptions* sppm = nullptr;
    RayCastOptions* rayCast = nullptr;
};

struct TextSetting {
    std::string_view option;                   ///< "--depth", or empty
    std::string_view variant;                  ///< "sampler", or empty
    std::string help;                          ///< "most scattering events along a path"
    std::string expected;                      ///< "sobol or independent"
    std::vector<std::string_view> words = {};  ///< those that are expected; none: numbers or a yes and no
    bool isNumber = false;                     ///< `expected` is only a range
    bool isVector = false;                     ///< "x,y,z"
    std::optional<IntegratorKind> only = {};   ///< the integrator whose setting it is; nothing: of all
    /// False, and nothing set, where the text is not what is expected.
    std::function<bool(std::string_view text, const SettingTargets& targets)> set;
};

/// In the order of the fields.
std::span<const TextSetting> textSettings();

}  // namespace glint
