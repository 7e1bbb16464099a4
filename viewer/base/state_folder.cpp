#include "viewer/base/state_folder.h"

#include <cstdlib>
#include <filesystem>

namespace glint {

std::string stateFolder() {
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return std::filesystem::path(value != nullptr ? value : "");
    };
    const std::filesystem::path state = variable("XDG_STATE_HOME");
    // A relative one is to be ignored (XDG Base Directory Specification 0.8).
    const std::filesystem::path base = state.is_absolute() ? state : variable("HOME") / ".local" / "state";
    return (base / "glint").string();
}

}  // namespace glint
