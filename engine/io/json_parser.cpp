// The JSON grammar (RFC 8259) plus comments. Keeps only the first error, at the token that is wrong.
#include <limits>
#include <set>

#include <fmt/format.h>

#include "engine/io/json_value.h"

namespace glint {
namespace {

constexpr int kMaxDepth = 64;

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isHexDigit(char c) { return isDigit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }
bool isWordCharacter(char c) {
    return isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '.' ||
           c == '+' || c == '-';
}

class JsonParser {
  public:
    explicit JsonParser(TextSource source) : document_(std::make_shared<JsonDocument>()) {
        document_->source = std::move(source);
    }

    Result<std::shared_ptr<const JsonDocument>> parse() {
        constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
        at_ = text().starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
        if (text().size() > size_t{1} << 31) { return document_->source.error(0, "is larger than 2 GiB"); }
        if (skipBlank() && parseValue(0) && skipBlank() && at_ < text().size()) {
            fail(at_, fmt::format("unexpected {} after the end of the scene", here()));
        }
        if (error_) { return std::move(*error_); }
        return std::shared_ptr<const JsonDocument>(std::move(document_));
    }

  private:
    std::string_view text() const { return document_->source.text; }
    char peek() const { return at_ < text().size() ? text()[at_] : '\0'; }

    bool fail(size_t offset, std::string message) {
        if (!error_) { error_ = document_->source.error(offset, std::move(message)); }
        return false;
    }

    /// What stands at the current place, for messages.
    std::string here() const {
        if (at_ >= text().size()) { return "end of the file"; }
        const char c = text()[at_];
        return c > ' ' && c < 0x7f ? fmt::format("'{}'", c)
                                   : fmt::format("byte 0x{:02x}", static_cast<unsigned char>(c));
    }

    bool skipBlank() {
        for (;;) {
            const char c = peek();
            if (at_ < text().size() && (c == ' ' || c == '\t' || c == '\n' || c == '\r')) {
                ++at_;
            } else if (text().substr(at_, 2) == "//") {
                at_ = std::min(text().find('\n', at_), text().size());
            } else if (text().substr(at_, 2) == "/*") {
                const size_t end = text().find("*/", at_ + 2);
                if (end == std::string_view::npos) {
                    return fail(at_, "this comment is never closed; expected */");
                }
                at_ = end + 2;
            } else {
                return true;
            }
        }
    }

    uint32_t addNode(JsonType type, size_t begin, size_t end) {
        const auto index = static_cast<uint32_t>(document_->nodes.size());
        document_->nodes.push_back(
            {static_cast<uint32_t>(begin), static_cast<uint32_t>(end), index + 1, type});
        return index;
    }

    bool parseValue(int depth) {
        if (depth > kMaxDepth) { return fail(at_, fmt::format("nested deeper than {} levels", kMaxDepth)); }
        switch (peek()) {
            case '{':
                return parseObject(depth);
            case '[':
                return parseArray(depth);
            case '"':
                return parseString();
            default:
                return parseWord();
        }
    }

    bool parseObject(int depth) {
        const size_t begin = at_++;
        const uint32_t index = addNode(JsonType::Object, begin, begin + 1);
        std::set<std::string> keys;
        if (!skipBlank()) { return false; }
        while (peek() != '}' || !keys.empty()) {
            if (peek() != '"') {
                return fail(at_, fmt::format("expected a key in double quotes{}, not {}",
                                             keys.empty() ? " or '}'" : "", here()));
            }
            const size_t keyAt = at_;
            const auto keyIndex = static_cast<uint32_t>(document_->nodes.size());
            if (!parseString()) { return false; }
            const std::string key = JsonValue(document_.get(), keyIndex).string();
            if (!keys.insert(key).second) {
                return fail(keyAt, fmt::format("the key \"{}\" stands twice in one object", key));
            }
            if (!skipBlank() || !expect(':', "after the key")) { return false; }
            if (!skipBlank() || !parseValue(depth + 1) || !skipBlank()) { return false; }
            if (!separator('}', begin, "object")) { return false; }
            if (closed_) { break; }
        }
        return close(index);
    }

    bool parseArray(int depth) {
        const size_t begin = at_++;
        const uint32_t index = addNode(JsonType::Array, begin, begin + 1);
        if (!skipBlank()) { return false; }
        bool first = true;
        while (peek() != ']' || !first) {
            first = false;
            if (!parseValue(depth + 1) || !skipBlank() || !separator(']', begin, "array")) { return false; }
            if (closed_) { break; }
        }
        return close(index);
    }

    /// Between two elements: eats a comma, or stops before the closing bracket and sets closed_.
    bool separator(char closing, size_t begin, std::string_view what) {
        closed_ = peek() == closing;
        if (closed_) { return true; }
        if (at_ >= text().size()) {
            return fail(begin, fmt::format("this {} is never closed; expected '{}' before the file ends",
                                           what, closing));
        }
        const size_t comma = at_;
        if (!expect(',', fmt::format("or '{}' after a value", closing)) || !skipBlank()) { return false; }
        if (peek() == closing) {
            return fail(comma, fmt::format("a comma before '{}'; expected another value", closing));
        }
        return true;
    }

    bool close(uint32_t index) {
        ++at_;
        document_->nodes[index].end = static_cast<uint32_t>(at_);
        document_->nodes[index].next = static_cast<uint32_t>(document_->nodes.size());
        return true;
    }

    bool expect(char wanted, std::string_view where) {
        if (peek() != wanted || at_ >= text().size()) {
            return fail(at_, fmt::format("expected '{}' {}, not {}", wanted, where, here()));
        }
        ++at_;
        return true;
    }

    bool parseString() {
        const size_t begin = at_++;
        while (at_ < text().size() && text()[at_] != '"') {
            if (static_cast<unsigned char>(text()[at_]) < 0x20) {
                return fail(
                    at_, fmt::format("{} inside a string; expected the closing quote or an escape", here()));
            }
            if (text()[at_] == '\\' && !skipEscape()) { return false; }
            ++at_;
        }
        if (at_ >= text().size()) { return fail(begin, "this string is never closed; expected '\"'"); }
        addNode(JsonType::String, begin + 1, at_);
        ++at_;
        return true;
    }

    /// At a backslash: moves to the escape's last character.
    bool skipEscape() {
        const size_t begin = at_++;
        if (peek() == 'u') {
            for (int i = 0; i < 4; ++i) {
                ++at_;
                if (!isHexDigit(peek())) { return fail(begin, "expected four hexadecimal digits after \\u"); }
            }
            return true;
        }
        if (peek() == '\0' || std::string_view("\"\\/bfnrt").find(peek()) == std::string_view::npos) {
            return fail(begin, "unknown escape; JSON knows \\\" \\\\ \\/ \\b \\f \\n \\r \\t and \\u");
        }
        return true;
    }

    bool parseWord() {
        const size_t begin = at_;
        while (at_ < text().size() && isWordCharacter(text()[at_])) {
            ++at_;
        }
        const std::string_view word = text().substr(begin, at_ - begin);
        if (word.empty()) { return fail(begin, fmt::format("expected a value, not {}", here())); }
        if (word == "true" || word == "false") {
            addNode(JsonType::Bool, begin, at_);
        } else if (word == "null") {
            addNode(JsonType::Null, begin, at_);
        } else if (isNumber(word)) {
            addNode(JsonType::Number, begin, at_);
        } else {
            return fail(begin, badWord(word.substr(0, 40)));
        }
        return true;
    }

    static std::string badWord(std::string_view word) {
        if (isDigit(word[0]) || word[0] == '-' || word[0] == '+' || word[0] == '.') {
            return fmt::format("'{}' is not a number as JSON writes it, like 0.5, -2 or 1e-3", word);
        }
        if (word == "NaN" || word == "nan" || word == "Infinity" || word == "inf" || word == "Inf") {
            return fmt::format("'{}' is not allowed; numbers must be finite", word);
        }
        return fmt::format("unknown word '{}'; expected a value, and text stands in double quotes", word);
    }

    static bool isNumber(std::string_view word) {
        size_t at = word[0] == '-' ? 1 : 0;
        const auto digits = [&] {
            const size_t begin = at;
            while (at < word.size() && isDigit(word[at])) {
                ++at;
            }
            return at - begin;
        };
        const size_t integerBegin = at;
        const size_t integerDigits = digits();
        if (integerDigits == 0 || (integerDigits > 1 && word[integerBegin] == '0')) { return false; }
        if (at < word.size() && word[at] == '.') {
            ++at;
            if (digits() == 0) { return false; }
        }
        if (at < word.size() && (word[at] == 'e' || word[at] == 'E')) {
            ++at;
            at += at < word.size() && (word[at] == '+' || word[at] == '-') ? 1 : 0;
            if (digits() == 0) { return false; }
        }
        return at == word.size();
    }

    std::shared_ptr<JsonDocument> document_;
    size_t at_ = 0;
    bool closed_ = false;
    std::optional<Error> error_;
};

}  // namespace

Result<std::shared_ptr<const JsonDocument>> parseJson(TextSource source) {
    return JsonParser(std::move(source)).parse();
}

}  // namespace glint
