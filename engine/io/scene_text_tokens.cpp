// Scanning a 6.837-style scene.
#include "engine/io/scene_text_tokens.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "engine/base/nearest_name.h"
#include "engine/io/json_fields.h"

namespace glint {
namespace {

constexpr std::string_view kWordEnds = " \t\r\n\v\f{}[]";
constexpr std::string_view kBlanks = kWordEnds.substr(0, 6);
constexpr std::string_view kBraces = kWordEnds.substr(6);

std::string shown(const TextToken& token) {
    return token.text.empty() ? "the end of the file" : fmt::format("'{}'", token.text.substr(0, 40));
}

}  // namespace

SceneTextTokens::SceneTextTokens(TextSource source) : source_(std::move(source)) { next_ = scan(0); }

TextToken SceneTextTokens::scan(size_t from) const {
    const std::string_view text = source_.text;
    const size_t begin = text.find_first_not_of(kBlanks, from);
    if (begin == std::string_view::npos) { return {{}, text.size()}; }
    if (kBraces.find(text[begin]) != std::string_view::npos) { return {text.substr(begin, 1), begin}; }
    const size_t end = std::min(text.find_first_of(kWordEnds, begin), text.size());
    return {text.substr(begin, end - begin), begin};
}

void SceneTextTokens::fail(const TextToken& at, std::string message) {
    if (!error_) { error_ = source_.error(at.offset, std::move(message)); }
}

TextToken SceneTextTokens::take() {
    const TextToken token = peek();
    if (!failed()) { next_ = scan(token.offset + token.text.size()); }
    return token;
}

bool SceneTextTokens::accept(std::string_view word) {
    if (peek().text != word) { return false; }
    take();
    return true;
}

void SceneTextTokens::expect(std::string_view word, std::string_view after) {
    if (!accept(word)) {
        fail(peek(), fmt::format("expected '{}' after {}, not {}", word, after, shown(peek())));
    }
}

void SceneTextTokens::failUnknown(std::string_view where, std::span<const std::string_view> expected) {
    fail(peek(), fmt::format("{} is not known in {}{}; expected {}", shown(peek()), where,
                             didYouMean(peek().text, expected), joinNames(expected)));
}

float SceneTextTokens::number(std::string_view what) {
    const TextToken token = take();
    float value = 0.0f;
    switch (parseFloat(token.text, &value)) {
        case NumberParse::Ok:
            return value;
        case NumberParse::NotANumber:
            fail(token, fmt::format("expected a number of {}, not {}", what, shown(token)));
            break;
        case NumberParse::NotFinite:
            fail(token, fmt::format("{} in {}; expected a finite number up to 3.4e38", shown(token), what));
            break;
    }
    return 0.0f;
}

float SceneTextTokens::number(std::string_view what, float lo, float hi, std::string_view expected) {
    const TextToken token = peek();
    const float value = number(what);
    if (!failed() && !(value >= lo && value <= hi)) {
        fail(token, fmt::format("{} is {}; expected {}", what, token.text, expected));
    }
    return failed() ? lo : value;
}

int SceneTextTokens::integer(std::string_view what, int lo, int hi) {
    const TextToken token = take();
    int value = 0;
    const char* end = token.text.data() + token.text.size();
    const auto [stop, code] = std::from_chars(token.text.data(), end, value);
    if (token.text.empty() || stop != end || code != std::errc() || value < lo || value > hi) {
        fail(token,
             fmt::format("{} is {}; expected a whole number from {} to {}", what, shown(token), lo, hi));
        return lo;
    }
    return value;
}

Vec3 SceneTextTokens::vec3(std::string_view what) {
    const float x = number(what);
    const float y = number(what);
    const float z = number(what);
    return {x, y, z};
}

Vec3 SceneTextTokens::color(std::string_view what) {
    const TextToken token = peek();
    const Vec3 value = vec3(what);
    if (!failed() && minComponent(value) < 0.0f) {
        fail(token, fmt::format("{} is negative; expected three numbers >= 0", what));
    }
    return value;
}

Vec3 SceneTextTokens::direction(std::string_view what) {
    const TextToken token = peek();
    const Vec3 value = vec3(what);
    if (!failed() && isZero(value)) { fail(token, fmt::format("{} is 0 0 0, which has no direction", what)); }
    return value;
}

std::string SceneTextTokens::path(std::string_view what) {
    const TextToken token = take();
    if (token.text.empty() || kBraces.find(token.text[0]) != std::string_view::npos) {
        fail(token, fmt::format("expected the path of {}, not {}", what, shown(token)));
    }
    return std::string(token.text);
}

}  // namespace glint
