#include "viewer/base/typed_path.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace glint {

std::string typedPath(const std::string& typed) {
    if (std::ranges::all_of(typed, [](char letter) { return letter == ' '; })) { return ""; }
    const char* home = std::getenv("HOME");
    const bool isOfHome = typed == "~" || typed.starts_with("~/");
    if (!isOfHome || home == nullptr) { return typed; }
    return (std::filesystem::path(home) / typed.substr(std::min<size_t>(2, typed.size()))).string();
}

}  // namespace glint
