// File names as people type them.
#pragma once

#include <string>

namespace glint {

/// "~" and what begins with "~/" in the home folder, where there is one; nothing for blanks alone. Everything
/// else stays.
std::string typedPath(const std::string& typed);

}  // namespace glint
