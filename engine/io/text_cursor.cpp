// The text is NUL-terminated (it lives in a std::string), so that one character may be looked at beyond
// any position.
#include "engine/io/text_cursor.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <fmt/format.h>

namespace glint {
namespace {

constexpr size_t kShownWord = 40;
/// Ctrl-Z, by which DOS marked the end of a text.
constexpr char kDosEnd = '\x1a';

/// The length of a backslash followed by a line's or the text's end, also with blanks between, or 0.
int continuationLength(const char* p) {
    if (p[0] != '\\') { return 0; }
    const char* end = p + 1;
    while (*end == ' ' || *end == '\t' || *end == '\r') {
        ++end;
    }
    if (*end == '\n') { return static_cast<int>(end + 1 - p); }
    return *end == '\0' ? static_cast<int>(end - p) : 0;
}

/// Where a text ends before zero bytes and Ctrl-Z, with line ends between them.
const char* withoutPadding(const char* begin, const char* end) {
    const char* first = end;
    for (const char* p = end; p != begin; --p) {
        const char c = p[-1];
        if (c == '\0' || c == kDosEnd) {
            first = p - 1;
        } else if (c != '\n' && c != '\r' && c != ' ') {
            break;
        }
    }
    return first;
}

/// A number too small or too large for float: small ones become 0 or denormal, large ones infinite.
float outOfRangeFloat(const char* first, const char* last) {
    return static_cast<float>(std::strtod(std::string(first, last).c_str(), nullptr));
}

/// The number at `at` and where it ends; null when there is none.
inline const char* parseFloat(const char* at, const char* end, float* out) {
    const char* first = at[0] == '+' && at[1] != '-' ? at + 1 : at;
    const auto [last, code] = std::from_chars(first, end, *out);
    if (code == std::errc::result_out_of_range) {
        *out = outOfRangeFloat(first, last);
        return last;
    }
    if (code == std::errc() && *last == '#' && last[-1] == '.') {  // 1.#QNAN, as Microsoft's library has it
        *out = std::numeric_limits<float>::quiet_NaN();
        return std::find_if(last, end, [](char c) { return c <= ' '; });
    }
    return code == std::errc() ? last : nullptr;
}

}  // namespace

TextCursor::TextCursor(const std::string& text, const std::string& file)
    : begin_(text.data()), end_(text.data() + text.size()), at_(begin_), file_(file), countedTo_(begin_) {
    end_ = withoutPadding(begin_, end_);
    // The mark some editors put before UTF-8, others before that of the first.
    while (std::string_view(at_, static_cast<size_t>(end_ - at_)).starts_with("\xef\xbb\xbf")) {
        at_ += 3;
    }
}

bool TextCursor::atBlank() const {
    return *at_ == ' ' || *at_ == '\t' || *at_ == '\r' || *at_ == '\v' || *at_ == '\f';
}

bool TextCursor::atLineEnd() {
    while (true) {
        if (atBlank()) {
            ++at_;
        } else if (const int length = continuationLength(at_); length > 0) {
            if (at_[1] != '\n' && at_[1] != '\r' && at_[1] != '\0') {
                remark(at_, "blanks behind the backslash that joins two lines");
            }
            at_ += length;
        } else {
            return at_ == end_ || *at_ == '\n' || *at_ == '#';
        }
    }
}

void TextCursor::nextLine() {
    if (*at_ == '#') {
        at_ = std::find(at_, end_,
                        '\n');  // a comment that ends in a backslash, as some paths do, joins nothing
    }
    while (at_ != end_ && *at_ != '\n') {
        const int length = continuationLength(at_);
        at_ += length > 0 ? length : 1;
    }
    at_ += at_ != end_ ? 1 : 0;
}

bool TextCursor::isWordEnd(const char* p) const {
    switch (*p) {
        case ' ':
        case '\t':
        case '\r':
        case '\n':
        case '\v':
        case '\f':
            return true;
        case '\\':
            return continuationLength(p) > 0;
        case '\0':
        case kDosEnd:
            return p == end_;
        default:
            return false;
    }
}

std::string_view TextCursor::wordAt(const char* p) const {
    const char* first = p;
    while (!isWordEnd(p)) {
        ++p;
    }
    return {first, static_cast<size_t>(p - first)};
}

std::string_view TextCursor::word() {
    if (atLineEnd()) { return {}; }
    const std::string_view found = wordAt(at_);
    at_ += found.size();
    return found;
}

std::string_view TextCursor::restOfLine() {
    while (at_ != end_ && atBlank()) {
        ++at_;
    }
    const char* first = at_;
    at_ = std::find(at_, end_, '\n');
    const char* last = at_;
    while (last != first && (last[-1] == ' ' || last[-1] == '\t' || last[-1] == '\r')) {
        --last;
    }
    return {first, static_cast<size_t>(last - first)};
}

bool TextCursor::readFloat(const char* what, float* out, bool mayBeInfinite) {
    if (atLineEnd()) { return fail(at_, fmt::format("expected {}, but the line ends", what)); }
    const char* last = parseFloat(at_, end_, out);
    last = last != nullptr && (isWordEnd(last) || *last == '#') ? last : nullptr;
    if (last == nullptr || !(mayBeInfinite || std::isfinite(*out))) {
        return fail(at_, fmt::format("expected {}, a {}number, but found \"{}\"", what,
                                     last == nullptr ? "" : "finite ", wordAt(at_).substr(0, kShownWord)));
    }
    at_ = last;
    return true;
}

bool TextCursor::readInt(const char* what, int64_t* out) {
    if (atLineEnd()) { return fail(at_, fmt::format("expected {}, but the line ends", what)); }
    auto [last, code] = std::from_chars(at_, end_, *out);
    if (code == std::errc() && *last == '.') {
        const char* fraction = last + 1;
        while (*fraction == '0') {
            ++fraction;
        }
        if (isWordEnd(fraction)) {
            remark(at_, "a whole number is written with a point");
            last = fraction;
        }
    }
    if (code != std::errc() || !isWordEnd(last)) {
        return fail(at_, fmt::format("expected {}, a whole number, but found \"{}\"", what,
                                     wordAt(at_).substr(0, kShownWord)));
    }
    at_ = last;
    return true;
}

int TextCursor::readSomeFloats(int most, float* out) {
    int count = 0;
    while (count < most && !atLineEnd()) {
        const char* last = parseFloat(at_, end_, &out[count]);
        if (last == nullptr || !isWordEnd(last)) { break; }
        if (!std::isfinite(out[count])) {
            remark(at_, "a number that is not finite counts as 0", wordAt(at_));
            out[count] = 0.0f;
        }
        ++count;
        at_ = last;
    }
    return count;
}

bool TextCursor::expectLineEnd(const char* after) {
    return atLineEnd() || fail(at_, fmt::format("expected nothing more after {}, but found \"{}\"", after,
                                                wordAt(at_).substr(0, kShownWord)));
}

bool TextCursor::fail(const char* where, std::string message) {
    error_ = Error{std::move(message), placeOf(where)};
    return false;
}

int TextCursor::lineOf(const char* where) const {
    // Remarks come in the order of the text, but for few.
    if (where < countedTo_) {
        countedTo_ = begin_;
        countedLine_ = 1;
    }
    charactersCounted_ += static_cast<uint64_t>(where - countedTo_);
    countedLine_ += static_cast<int>(std::count(countedTo_, where, '\n'));
    countedTo_ = where;
    return countedLine_;
}

SourcePlace TextCursor::placeOf(const char* where) const {
    const char* lineBegin = where;
    while (lineBegin != begin_ && lineBegin[-1] != '\n') {
        --lineBegin;
    }
    const char* lineEnd = std::find(where, end_, '\n');
    lineEnd -= lineEnd != lineBegin && lineEnd[-1] == '\r' ? 1 : 0;
    return {.file = file_,
            .line = lineOf(lineBegin),
            .column = 1 + static_cast<int>(where - lineBegin),
            .lineText = std::string(lineBegin, std::max(lineBegin, lineEnd))};
}

void TextCursor::remark(const char* where, std::string_view kind, std::string_view detail) {
    remarks_.add(
        kind, [&] { return fmt::format("{}:{}", file_, lineOf(where)); }, detail);
}

}  // namespace glint
