// Where Glint keeps what outlives a session: recent files, the layout, bookmarks of cameras, recovered
// sessions; and what the user prefers.
#pragma once

#include <string>

namespace glint {

/// $XDG_STATE_HOME/glint, or ~/.local/state/glint. It need not exist.
std::string stateFolder();
/// $XDG_CONFIG_HOME/glint, or ~/.config/glint. It need not exist.
std::string preferencesFolder();

}  // namespace glint
