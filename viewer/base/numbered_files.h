// Pictures under one name with numbers: "out-000010.png".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

/// "out.png" after 10 passes, or the tenth of many: "out-000010.png".
std::string numberedPath(const std::string& path, uint32_t number);

/// numberedPath(path, n) for the multiples n of `every` up to `last`.
struct NumberedFiles {
    std::string path;
    uint32_t every = 1, last = 0;

    /// 0: no picture of these has this name (without its folder).
    uint32_t numberOf(std::string_view name) const;
    /// Those that are there already, by their numbers.
    std::vector<std::string> existing() const;
    /// Those of them that are more than a name of their own: links, folders, pipes.
    std::vector<std::string> shared() const;
};

}  // namespace glint
