// Text files as other systems write them, made UTF-8 with line feeds. For the readers of OBJ, MTL and PLY.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace glint {

struct PlainText {
    std::string text;
    std::string_view repaired;  ///< the sentence of a remark (remarks.h) on what was changed
};

/// By a mark, or by every other one of the first characters' bytes being zero.
bool isUtf16(std::string_view bytes);

/// `bytes` in UTF-8 where they are UTF-16; where the first 64 KiB have a carriage return without a line
/// feed, each of these becomes one. Nothing where `bytes` can stay as they are.
std::optional<PlainText> asPlainText(const std::string& bytes);

}  // namespace glint
