#include "engine/io/pbrt_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace glint {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

}  // namespace

PbrtText::PbrtText(std::string text, uint32_t file)
    : text_(std::move(text)),
      file_(file),
      at_(text_.data()),
      end_(text_.data() + text_.size()),
      countedTo_(at_),
      lineBegin_(at_) {
    if (text_.starts_with("\xef\xbb\xbf")) { at_ += 3; }
}

void PbrtText::skipBlanks() {
    while (true) {
        while (isBlank(*at_)) {
            ++at_;
        }
        if (*at_ != '#') { return; }
        const void* line = std::memchr(at_, '\n', static_cast<size_t>(end_ - at_));
        at_ = line != nullptr ? static_cast<const char*>(line) : end_;
    }
}

PbrtPlace PbrtText::place() {
    skipBlanks();
    const auto lines = static_cast<uint32_t>(std::count(countedTo_, at_, '\n'));
    if (lines > 0) {
        line_ += lines;
        lineBegin_ = at_;
        while (lineBegin_[-1] != '\n') {
            --lineBegin_;
        }
    }
    countedTo_ = at_;
    return {file_, line_, 1 + static_cast<uint32_t>(at_ - lineBegin_)};
}

bool PbrtText::isEndOfWord(const char* p) const {
    return isBlank(*p) || *p == '[' || *p == ']' || *p == '"' || *p == '#' || p == end_;
}

std::string_view PbrtText::word() {
    skipBlanks();
    const char* first = at_;
    at_ += at_ != end_ ? 1 : 0;
    if (!isEndOfWord(first)) {
        while (!isEndOfWord(at_)) {
            ++at_;
        }
    }
    return {first, static_cast<size_t>(at_ - first)};
}

bool PbrtText::readString(std::string* out) {
    if (peek() != '"') { return false; }
    const char* p = at_ + 1;
    out->clear();
    for (; p != end_ && *p != '"'; ++p) {
        if (*p == '\\' && p + 1 != end_) {
            ++p;
            *out += *p == 'n' ? '\n' : *p == 't' ? '\t' : *p;
        } else {
            *out += *p;
        }
    }
    if (p == end_) { return false; }
    at_ = p + 1;
    return true;
}

/// Whole numbers may be written with a point and zeros behind it.
template <class Number>
bool PbrtText::readOne(Number* out) {
    const char* first = at_[0] == '+' && at_[1] != '-' ? at_ + 1 : at_;
    auto [last, code] = std::from_chars(first, end_, *out);
    if constexpr (std::is_floating_point_v<Number>) {
        if (code == std::errc::result_out_of_range) {  // tiny ones are 0
            *out = static_cast<Number>(std::strtod(std::string(first, last).c_str(), nullptr));
            code = {};
        }
        if (!std::isfinite(*out)) { return false; }
    } else if (code == std::errc() && *last == '.') {
        do {
            ++last;
        } while (*last == '0');
    }
    if (code != std::errc() || !isEndOfWord(last)) { return false; }
    at_ = last;
    return true;
}

bool PbrtText::readNumber(double* out) {
    skipBlanks();
    return readOne(out);
}

template <class Read>
bool PbrtText::readList(const Read& read) {
    if (peek() != '[') { return read(); }
    ++at_;
    while (peek() != ']') {
        if (!read()) { return false; }
    }
    ++at_;
    return true;
}

bool PbrtText::readFloats(std::vector<float>* out) {
    return readList([&] {
        float number = 0.0f;
        if (!readOne(&number)) { return false; }
        out->push_back(number);
        return true;
    });
}

bool PbrtText::readInts(std::vector<int>* out) {
    return readList([&] {
        int number = 0;
        if (!readOne(&number)) { return false; }
        out->push_back(number);
        return true;
    });
}

bool PbrtText::readStrings(std::vector<std::string>* out) {
    return readList([&] {
        std::string text;
        const bool isWord = peek() != '"';  // true and false
        if (isWord ? atEnd() || isEndOfWord(at_) : !readString(&text)) { return false; }
        out->push_back(isWord ? std::string(word()) : std::move(text));
        return true;
    });
}

bool PbrtText::isStringNext() {
    const char* first = at_;
    if (peek() == '[') { ++at_; }
    const bool isString = peek() == '"';
    at_ = first;
    return isString;
}

void PbrtText::skipValue() {
    std::string text;
    if (peek() != '[') {
        if (!readString(&text)) { word(); }
        return;
    }
    ++at_;
    while (!atEnd() && peek() != ']') {
        if (!readString(&text)) { word(); }
    }
    word();
}

std::string PbrtText::lineText(uint32_t line) const {
    size_t begin = 0;
    for (uint32_t i = 1; i < line && begin != std::string::npos; ++i) {
        begin = text_.find('\n', begin);
        begin += begin != std::string::npos ? 1 : 0;
    }
    if (begin >= text_.size()) { return {}; }
    return text_.substr(begin, std::min(text_.find('\n', begin), text_.size()) - begin);
}

void PbrtText::drop() {
    constexpr size_t kLong = size_t{1} << 20;
    if (text_.size() < kLong) { return; }
    text_ = {};
    at_ = end_ = countedTo_ = lineBegin_ = text_.data();
}

}  // namespace glint
