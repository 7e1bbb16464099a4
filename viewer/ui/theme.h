// A calm, neutral grey theme: no hue around the picture, so that its colours are judged rightly.
#pragma once

struct ImVec4;

namespace glint {

/// Sets ImGui's colours and sizes for `scale` ImGui units per unit of a 96-dpi design.
void applyTheme(float scale);

namespace theme {

extern const ImVec4 kTextDim;  ///< labels, units, hints
extern const ImVec4 kTextError;
extern const ImVec4 kTextWarning;
extern const ImVec4 kAccent;  ///< the one control of a group that matters most
extern const ImVec4 kPanelBackground;
extern const ImVec4 kImageBackground;

}  // namespace theme
}  // namespace glint
