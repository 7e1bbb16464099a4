// The panels' fonts: Roboto from the distribution's package, with a fallback that is logged.
#pragma once

#include <string>

struct ImFont;

namespace glint {

struct Fonts {
    ImFont* regular = nullptr;
    ImFont* heading = nullptr;  ///< the same size, heavier
    std::string note;           ///< what had to stand in for a missing font; empty when nothing was missing
};

/// Replaces ImGui's font atlas. `pixelsPerUnit` scales the design's font height; `framebufferScale` is what
/// the window system scales by itself. The back end has to create its font texture anew afterwards.
Fonts loadFonts(float contentScale, float framebufferScale);

}  // namespace glint
