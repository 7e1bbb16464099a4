#include "viewer/commands/output_files.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"

namespace glint {

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
