// Reading text files and numbers with their places.
#include "engine/io/text_source.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"

namespace glint {
namespace {

constexpr size_t kMaxSceneBytes = size_t{256} << 20;

}  // namespace

SourcePlace TextSource::place(size_t offset) const {
    offset = std::min(offset, text.size());
    const size_t before = offset == 0 ? std::string::npos : text.rfind('\n', offset - 1);
    const size_t lineStart = before == std::string::npos ? 0 : before + 1;
    size_t lineEnd = std::min(text.find('\n', offset), text.size());
    if (lineEnd > lineStart && text[lineEnd - 1] == '\r') { lineEnd = std::max(lineEnd - 1, offset); }
    const auto line =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(lineStart), '\n') + 1;
    return {path, static_cast<int>(line), static_cast<int>(offset - lineStart + 1),
            text.substr(lineStart, lineEnd - lineStart)};
}

Result<TextSource> readSceneFile(const std::string& path) {
    const SourcePlace place{path, 0, 0, ""};
    if (Status regular = checkRegularFile(path, "a file"); !regular) { return regular.error(); }
    std::ifstream file(path, std::ios::binary);
    if (!file) { return Error{fmt::format("cannot be opened: {}", std::strerror(errno)), place}; }
    TextSource source{path, {}};
    char block[1 << 16];
    while (file.read(block, sizeof block), file.gcount() > 0) {
        source.text.append(block, static_cast<size_t>(file.gcount()));
        if (source.text.size() > kMaxSceneBytes) {
            return Error{
                fmt::format("is larger than {} MiB, the most a scene file may be", kMaxSceneBytes >> 20),
                place};
        }
    }
    if (source.text.find_first_not_of(" \t\r\n") == std::string::npos) {
        return Error{"is empty; expected a scene", place};
    }
    return source;
}

NumberParse parseFloat(std::string_view text, float* value) {
    if (!text.empty() && text.front() == '+') { text.remove_prefix(1); }
    const char* end = text.data() + text.size();
    const auto [stop, code] = std::from_chars(text.data(), end, *value);
    if (stop != end || code == std::errc::invalid_argument) { return NumberParse::NotANumber; }
    if (code == std::errc::result_out_of_range) {
        // Too small or too large: the exponent of the first significant digit tells which.
        const size_t mark = text.find_first_of("eE");
        const std::string_view mantissa = text.substr(0, mark);
        const bool negativeExponent =
            mark != std::string_view::npos && mark + 1 < text.size() && text[mark + 1] == '-';
        const bool isSmall = negativeExponent || mantissa.find_first_of("123456789") > mantissa.find('.');
        *value = 0.0f;
        return isSmall ? NumberParse::Ok : NumberParse::NotFinite;
    }
    return std::isfinite(*value) ? NumberParse::Ok : NumberParse::NotFinite;
}

}  // namespace glint
