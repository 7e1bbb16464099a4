// Reading text files and numbers with their places.
#include "engine/io/text_source.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "engine/io/file_kind.h"

namespace glint {
namespace {

constexpr size_t kMaxSceneBytes = size_t{256} << 20;

}  // namespace

int LineIndex::line(const std::string& text, size_t offset) {
    if (!isListed_) {
        for (size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
            ends_.push_back(static_cast<uint32_t>(at));
        }
        searchedBytes_ += text.size();
        isListed_ = true;
    }
    return 1 + static_cast<int>(std::ranges::lower_bound(ends_, offset) - ends_.begin());
}

SourcePlace TextSource::place(size_t offset) const {
    offset = std::min(offset, text.size());
    const size_t before = offset == 0 ? std::string::npos : text.rfind('\n', offset - 1);
    const size_t lineStart = before == std::string::npos ? 0 : before + 1;
    size_t lineEnd = std::min(text.find('\n', offset), text.size());
    if (lineEnd > lineStart && text[lineEnd - 1] == '\r') { lineEnd = std::max(lineEnd - 1, offset); }
    return {path, lines.line(text, offset), static_cast<int>(offset - lineStart + 1),
            text.substr(lineStart, lineEnd - lineStart)};
}

std::string TextSource::warning(size_t offset, std::string_view message) const {
    return fmt::format("{}:{}: {}", path, lines.line(text, std::min(offset, text.size())), message);
}

Result<TextSource> readSceneFile(const std::string& path) {
    Result<std::string> text = readFileOfKind(path, looksLikeText, kMaxSceneBytes);
    if (!text) { return text.error(); }
    if (text->find_first_not_of(" \t\r\n") == std::string::npos) {
        return Error{"is empty; expected a scene", {.file = path}};
    }
    return TextSource{path, std::move(*text)};
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
