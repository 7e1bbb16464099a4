// A text file in memory that can name places in itself.
//
// Places count lines from 1 and columns in bytes from 1, as compilers do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"

namespace glint {

/// Finds the lines of a text by halving, however many are asked for: their ends are listed when the first
/// one is.
class LineIndex {
  public:
    /// The line of the byte at `offset`, from 1. `text` must stay what it was.
    int line(const std::string& text, size_t offset);
    /// How many bytes were looked at to list the ends.
    uint64_t searchedBytes() const { return searchedBytes_; }

  private:
    std::vector<uint32_t> ends_;
    uint64_t searchedBytes_ = 0;
    bool isListed_ = false;
};

struct TextSource {
    std::string path;
    std::string text;
    mutable LineIndex lines = {};  ///< of the text, which does not change once there is a place to name

    /// The place of the byte at `offset`; offsets past the end name the place just after the last byte.
    SourcePlace place(size_t offset) const;
    Error error(size_t offset, std::string message) const { return {std::move(message), place(offset)}; }
    /// "path:line: message", in time that does not grow with the text or its lines.
    std::string warning(size_t offset, std::string_view message) const;
};

/// Reads a scene file. Error: missing, a folder, unreadable, empty, or larger than 256 MiB (found before it
/// is read).
Result<TextSource> readSceneFile(const std::string& path);

/// What became of a decimal number's text.
enum class NumberParse { Ok, NotANumber, NotFinite };

/// The float nearest to the decimal number `text`, which must be a number as a whole; values too small for a
/// float become 0. NotFinite: too large for a float, or "nan" or "inf". Independent of the locale.
NumberParse parseFloat(std::string_view text, float* value);

}  // namespace glint
