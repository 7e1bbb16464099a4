// A text file in memory that can name places in itself. Used by the JSON and the 6.837 scene readers.
//
// Places count lines from 1 and columns in bytes from 1, as compilers do.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "engine/base/result.h"

namespace glint {

struct TextSource {
    std::string path;
    std::string text;

    /// The place of the byte at `offset`; offsets past the end name the place just after the last byte.
    SourcePlace place(size_t offset) const;
    Error error(size_t offset, std::string message) const { return {std::move(message), place(offset)}; }
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
