// Asks the system for permission instead of creating a file, so that a refused run leaves no trace.
#include "viewer/commands/output_files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fmt/format.h>
#include <unistd.h>

namespace glint {

Status checkWritable(const std::string& path) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path target(path);
    if (path.empty() || fs::is_directory(target, ignored) || !target.has_filename()) {
        return Error{fmt::format("cannot write '{}': it is a folder; expected a file's name", path), {}};
    }
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, ignored)) {
        return Error{fmt::format("cannot write '{}': the folder '{}' does not exist", path, folder.string()),
                     {}};
    }
    // A new file is made in the folder and renamed; devices are written in place.
    const bool device = fs::exists(target, ignored) && !fs::is_regular_file(target, ignored);
    const std::string asked = device ? path : folder.string();
    if (access(asked.c_str(), W_OK) != 0) {
        return Error{fmt::format("cannot write '{}': {}: {}", path, asked, std::strerror(errno)), {}};
    }
    return {};
}

Status checkAllWritable(const std::vector<std::string>& paths) {
    for (auto path = paths.begin(); path != paths.end(); ++path) {
        if (path->empty()) { continue; }
        if (Status writable = checkWritable(*path); !writable) { return writable; }
        const auto isSameFile = [&](const std::string& other) {
            std::error_code ignored;
            return !other.empty() && std::filesystem::weakly_canonical(other, ignored) ==
                                         std::filesystem::weakly_canonical(*path, ignored);
        };
        if (std::any_of(paths.begin(), path, isSameFile)) {
            return Error{fmt::format("two outputs go to one file, '{}'; expected different names", *path),
                         {}};
        }
    }
    return {};
}

}  // namespace glint
