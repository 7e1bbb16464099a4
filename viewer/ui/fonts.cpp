#include "viewer/ui/fonts.h"

#include <array>
#include <cmath>
#include <cstdio>

#include <imgui.h>

namespace glint {
namespace {

constexpr float kHeightUnits = 15.0f;

// Latin with its accents, Greek, punctuation and the mathematical signs that units and numbers use.
constexpr ImWchar kGlyphs[] = {0x0020, 0x00ff, 0x0370, 0x03ff, 0x2010, 0x2027, 0x2030, 0x203a, 0x20ac,
                               0x20ac, 0x2212, 0x2212, 0x221e, 0x221e, 0x2248, 0x2265, 0};

bool isReadable(const char* path) {
    std::FILE* file = std::fopen(path, "rb");
    if (file != nullptr) { std::fclose(file); }
    return file != nullptr;
}

template <size_t kCount>
const char* firstReadable(const std::array<const char*, kCount>& paths) {
    for (const char* path : paths) {
        if (isReadable(path)) { return path; }
    }
    return nullptr;
}

ImFont* addFont(const char* path, float pixels) {
    ImFontConfig config;
    config.OversampleH = 2;
    config.OversampleV = 1;
    config.PixelSnapH = false;
    return ImGui::GetIO().Fonts->AddFontFromFileTTF(path, pixels, &config, kGlyphs);
}

}  // namespace

Fonts loadFonts(float contentScale, float framebufferScale) {
    static constexpr std::array<const char*, 2> kRegular{
        "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf",
        "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"};
    static constexpr std::array<const char*, 2> kHeading{
        "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Medium.ttf",
        "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"};
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    io.Fonts->Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
    io.FontGlobalScale = 1.0f / framebufferScale;
    const float pixels = std::round(kHeightUnits * contentScale);

    Fonts fonts;
    const char* regular = firstReadable(kRegular);
    const char* heading = firstReadable(kHeading);
    if (regular != nullptr) { fonts.regular = addFont(regular, pixels); }
    if (heading != nullptr) { fonts.heading = addFont(heading, pixels); }
    if (regular != kRegular[0]) {
        fonts.note = "The font Roboto is missing (package fonts-roboto-unhinted); ";
        fonts.note += regular != nullptr ? "DejaVu Sans stands in" : "ImGui's bitmap font stands in";
    }
    if (fonts.regular == nullptr) {
        ImFontConfig config;
        config.SizePixels = std::round(13.0f * contentScale);
        fonts.regular = io.Fonts->AddFontDefault(&config);
    }
    if (fonts.heading == nullptr) { fonts.heading = fonts.regular; }
    return fonts;
}

}  // namespace glint
