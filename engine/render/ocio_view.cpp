#include "engine/render/ocio_view.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "engine/io/file_path.h"
#if GLINT_HAS_OCIO
#include <OpenColorIO/OpenColorIO.h>

#include "engine/base/log.h"
#include "engine/base/nearest_name.h"
#endif

namespace glint {

OcioChoice parseOcioChoice(const std::string& text) {
    if (fileExists(text)) { return {text, "", ""}; }
    size_t colon = text.find(':');
    for (size_t next = colon; next != std::string::npos; next = text.find(':', next + 1)) {
        if (fileExists(text.substr(0, next))) { colon = next; }
    }
    if (colon == std::string::npos) { return {text, "", ""}; }
    const std::string names = text.substr(colon + 1);
    const size_t end = names.find_first_of("/:");
    return {text.substr(0, colon), names.substr(0, end),
            end == std::string::npos ? "" : names.substr(end + 1)};
}

#if GLINT_HAS_OCIO

namespace {

namespace ocio = OCIO_NAMESPACE;

class LibraryView final : public OcioView {
  public:
    LibraryView(OcioChoice chosen, std::vector<OcioDisplay> offered,
                const ocio::ConstProcessorRcPtr& processor)
        : OcioView(std::move(chosen), std::move(offered)), processor_(processor->getDefaultCPUProcessor()) {}
    Vec3 operator()(const Vec3& linear) const override {
        Vec3 shown = linear;
        processor_->applyRGB(&shown.x);
        return shown;
    }

  private:
    ocio::ConstCPUProcessorRcPtr processor_;
};

/// What configurations call linear Rec.709 or sRGB: OpenColorIO's own, ACES's, Blender's.
constexpr std::array kLinearRec709{"lin_rec709",  "lin_rec709_srgb",         "lin_rec709_scene",
                                   "lin_srgb",    "Linear Rec.709 (sRGB)",   "Linear Rec.709",
                                   "Linear sRGB", "Utility - Linear - sRGB", "Utility - Linear - Rec.709",
                                   "linear_srgb"};

/// Rec.709's linear values to CIE XYZ under D65 (IEC 61966-2-1).
constexpr std::array kRec709ToXyz{0.4124, 0.3576, 0.1805, 0.0, 0.2126, 0.7152, 0.0722, 0.0,
                                  0.0193, 0.1192, 0.9505, 0.0, 0.0,    0.0,    0.0,    1.0};

/// From Glint's colours to the space that is returned by its name.
std::string appendSource(const ocio::ConstConfigRcPtr& config, const std::string& file,
                         const ocio::GroupTransformRcPtr& group) {
    for (const char* name : kLinearRec709) {
        if (config->getColorSpace(name)) { return name; }
    }
    if (!config->hasRole(ocio::ROLE_INTERCHANGE_SCENE)) {
        logWarning("{}: names no linear Rec.709 and no aces_interchange; scene_linear is taken for it", file);
        return ocio::ROLE_SCENE_LINEAR;
    }
    const auto matrix = ocio::MatrixTransform::Create();
    matrix->setMatrix(kRec709ToXyz.data());
    group->appendTransform(matrix);
    const auto toAces = ocio::BuiltinTransform::Create();
    toAces->setStyle("UTILITY - ACES-AP0_to_CIE-XYZ-D65_BFD");
    toAces->setDirection(ocio::TRANSFORM_DIR_INVERSE);
    group->appendTransform(toAces);
    return ocio::ROLE_INTERCHANGE_SCENE;
}

std::vector<OcioDisplay> displaysOf(const ocio::ConstConfigRcPtr& config) {
    std::vector<OcioDisplay> displays;
    for (int i = 0; i < config->getNumDisplays(); ++i) {
        OcioDisplay display{config->getDisplay(i), {}};
        for (int v = 0; v < config->getNumViews(display.name.c_str()); ++v) {
            display.views.emplace_back(config->getView(display.name.c_str(), v));
        }
        if (!display.views.empty()) { displays.push_back(std::move(display)); }
    }
    return displays;
}

/// `wanted`, or the first where it is empty. Error: there is none of that name.
Result<std::string> chosen(const std::string& wanted, const std::vector<std::string>& names, const char* what,
                           const std::string& file) {
    const std::vector<std::string_view> known(names.begin(), names.end());
    if (names.empty()) { return Error{fmt::format("has no {}", what), {.file = file}}; }
    if (wanted.empty()) { return names.front(); }
    if (std::find(names.begin(), names.end(), wanted) != names.end()) { return wanted; }
    return Error{fmt::format("there is no {} '{}'{}; expected {}", what, wanted, didYouMean(wanted, known),
                             joinNames(known)),
                 {.file = file}};
}

Result<std::shared_ptr<const OcioView>> load(const OcioChoice& choice) {
    const auto config = ocio::Config::CreateFromFile(choice.config.c_str());
    config->validate();
    std::vector<OcioDisplay> displays = displaysOf(config);
    std::vector<std::string> names;
    names.reserve(displays.size());
    for (const OcioDisplay& display : displays) {
        names.push_back(display.name);
    }
    const auto display = chosen(choice.display, names, "display", choice.config);
    if (!display) { return display.error(); }
    const auto at = std::find(names.begin(), names.end(), *display) - names.begin();
    const std::vector<std::string> views = displays[static_cast<size_t>(at)].views;
    const auto name = chosen(choice.view, views, "view", choice.config);
    if (!name) { return name.error(); }
    const auto group = ocio::GroupTransform::Create();
    const std::string source = appendSource(config, choice.config, group);
    const auto shows = ocio::DisplayViewTransform::Create();
    shows->setSrc(source.c_str());
    shows->setDisplay(display->c_str());
    shows->setView(name->c_str());
    group->appendTransform(shows);
    return std::shared_ptr<const OcioView>(std::make_shared<LibraryView>(
        OcioChoice{choice.config, *display, *name}, std::move(displays), config->getProcessor(group)));
}

}  // namespace

Result<std::shared_ptr<const OcioView>> loadOcioView(const OcioChoice& choice) {
    ocio::SetLoggingLevel(ocio::LOGGING_LEVEL_NONE);
    try {
        return load(choice);
    } catch (const std::exception& problem) {
        return Error{fmt::format("is no OpenColorIO configuration that can be used: {}", problem.what()),
                     {.file = choice.config}};
    }
}

bool hasOcio() { return true; }

#else

Result<std::shared_ptr<const OcioView>> loadOcioView(const OcioChoice& choice) {
    return Error{"this build has no OpenColorIO; expected libopencolorio-dev when it was configured",
                 {.file = choice.config}};
}

bool hasOcio() { return false; }

#endif

}  // namespace glint
