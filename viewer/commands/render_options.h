// What `glint render` was asked for: the options as written, and how they change a scene.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/render/render_session.h"
#include "engine/render/tonemap.h"
#include "viewer/commands/scene_opening.h"
#include "viewer/commands/scene_overrides.h"

namespace glint {

class Command;

struct RenderCommandOptions {
    std::string scene;
    std::string output;
    StopLimits limits;
    SceneOverrides overrides;
    int threads = 0;
    std::vector<std::string> aovs;
    bool exrFloat = false;
    std::optional<float> exposure;  ///< nothing: chosen by the picture
    bool noAutoExposure = false;
    uint32_t turntable = 0;  ///< frames of a turn around the target; 0: one picture
    uint32_t flight = 0;     ///< frames from bookmark to bookmark; 0: one picture
    bool denoise = false;
    WhiteBalance white{};
    bool dither = false;
    std::string tone;                        ///< empty: sRGB, or the original's
    std::string ocio;                        ///< empty: the tone map
    std::shared_ptr<const OcioView> view{};  ///< of `ocio`, once it is loaded
    std::string checkpoint;
    std::string checkpointEvery;
    std::string resume;
    bool overwrite = false;
    LoadOptions load;
    std::string pixel;
    std::optional<uint32_t> replayPass;  ///< 0 without one
    std::string json;
    std::string backend = "cpu";
    std::string sceneOptions;  ///< all that change the scene, as written, quoted for a shell
};

void addRenderOptions(const Command& command, RenderCommandOptions* options);

/// Of PNGs; nothing: the picture decides.
std::optional<float> statedExposure(const RenderCommandOptions& options);
ToneMap toneMapOf(const RenderCommandOptions& options);

/// The limits that were given, or kDefaultPasses where none was.
StopLimits finalLimits(const RenderCommandOptions& options);

/// A word that a POSIX shell reads back as it is.
std::string quotedForShell(const std::string& word);

/// Passes that are rendered when no limit is given.
constexpr uint32_t kDefaultPasses = 128;

/// Bits of Aov, and whether the standard error and the maps of bias and bound are among the names. Error: an
/// unknown name, naming the nearest.
struct AovChoice {
    uint32_t aovs = 0;
    bool standardError = false;
    bool errorMaps = false;  ///< of "bias" and "error-bound" both, since one needs the other
};
Result<AovChoice> chooseAovs(const std::vector<std::string>& names);

/// How often a render saves what it has: by passes, by seconds, or (both 0) only at the end.
struct SaveInterval {
    uint32_t passes = 0;
    double seconds = 0.0;
};
/// "50" (passes), "60s" (seconds) or nothing. Error: anything else, or not above zero.
Result<SaveInterval> parseSaveInterval(const std::string& text);

/// "WxH" or "x,y" with the given separator. Error: anything else.
Result<Vec2i> parsePair(const std::string& text, char separator, const char* what);

}  // namespace glint
