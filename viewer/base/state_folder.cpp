#include "viewer/base/state_folder.h"

#include <cstdlib>
#include <filesystem>

namespace glint {

namespace {

std::filesystem::path variable(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
}

std::string folder(const char* name, const std::filesystem::path& inHome) {
    const std::filesystem::path named = variable(name);
    // A relative one is to be ignored (XDG Base Directory Specification 0.8).
    return ((named.is_absolute() ? named : variable("HOME") / inHome) / "glint").string();
}

}  // namespace

std::string stateFolder() { return folder("XDG_STATE_HOME", ".local/state"); }
std::string preferencesFolder() { return folder("XDG_CONFIG_HOME", ".config"); }

}  // namespace glint
