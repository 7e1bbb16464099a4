// Where Glint keeps what outlives a session: recent files, the layout, bookmarks of cameras, recovered
// sessions.
#pragma once

#include <string>

namespace glint {

/// $XDG_STATE_HOME/glint, or ~/.local/state/glint. It need not exist.
std::string stateFolder();

}  // namespace glint
