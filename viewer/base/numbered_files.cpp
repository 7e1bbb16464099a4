// The names may be millions, so they are never gone through: the folder's entries are compared with
// the pattern.
#include "viewer/base/numbered_files.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace glint {

namespace fs = std::filesystem;

std::string numberedPath(const std::string& path, uint32_t number) {
    const size_t dot = path.rfind('.');
    return fmt::format("{}-{:06}{}", path.substr(0, dot), number, path.substr(dot));
}

uint32_t NumberedFiles::numberOf(std::string_view name) const {
    const std::string own = fs::path(path).filename().string();
    const size_t dash = own.rfind('.');
    if (name.size() <= dash) { return 0; }
    uint32_t number = 0;
    std::from_chars(name.data() + dash + 1, name.data() + name.size(), number);
    const bool isOne = number > 0 && number <= last && number % every == 0;
    return isOne && numberedPath(own, number) == name ? number : 0;
}

std::vector<std::string> NumberedFiles::existing() const {
    std::vector<std::string> found;
    const fs::path folder = fs::path(path).parent_path();
    std::error_code problem;
    for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, problem)) {
        const fs::path name = entry.path().filename();
        if (numberOf(name.string()) > 0) { found.push_back((folder / name).string()); }
    }
    std::ranges::sort(found, {}, [](const std::string& name) { return std::pair(name.size(), name); });
    return found;
}

std::vector<std::string> NumberedFiles::shared() const {
    std::vector<std::string> found = existing();
    std::erase_if(found, [](const std::string& name) {
        std::error_code problem;
        const fs::directory_entry entry(name, problem);
        return !entry.is_symlink(problem) && entry.is_regular_file(problem) &&
               entry.hard_link_count(problem) == 1;
    });
    return found;
}

}  // namespace glint
