// Keys by GLFW's codes, on both surfaces: the codes that ImGuiIO::KeysDown is indexed with, and their names
// in scripts.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

struct ImGuiIO;

namespace glint {

/// Tells ImGui which codes move its text cursors.
void setKeyMap(ImGuiIO* io);

/// "a", "1", "space", "left", "shift", "f1", "[", …; nothing for an unknown name.
std::optional<int> keyCode(std::string_view name);
/// All names, for a message that suggests the nearest.
std::vector<std::string_view> keyNames();

}  // namespace glint
