// Places on the screen as Dear ImGui takes them.
#pragma once

#include <imgui.h>

#include "engine/math/vec.h"

namespace glint {

inline ImVec2 im(const Vec2& v) { return {v.x, v.y}; }

}  // namespace glint
