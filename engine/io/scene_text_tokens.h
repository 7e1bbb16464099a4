// Words, braces and numbers of a 6.837-style scene, with their places. Internal to the text scene reader.
//
// The first error is kept; after it every getter answers at once with nothing, so that the reader's
// loops end.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "engine/io/text_source.h"
#include "engine/math/vec.h"

namespace glint {

/// A word or one of { } [ ]; empty at the end of the file.
struct TextToken {
    std::string_view text;
    size_t offset = 0;
};

class SceneTextTokens {
  public:
    explicit SceneTextTokens(TextSource source);

    const TextSource& source() const { return source_; }
    bool failed() const { return error_.has_value(); }
    const Error& error() const { return *error_; }
    void fail(const TextToken& at, std::string message);

    /// The next token without eating it; empty at the end and after an error.
    TextToken peek() const { return failed() ? TextToken{{}, next_.offset} : next_; }
    bool atEnd() const { return peek().text.empty(); }
    TextToken take();
    /// Eats the next token if it is `word`.
    bool accept(std::string_view word);
    /// Eats `word`, or fails: "expected '{' after Sphere, not 'center'".
    void expect(std::string_view word, std::string_view after);
    /// Fails at the next token: what it is and which words were expected in `where`.
    void failUnknown(std::string_view where, std::span<const std::string_view> expected);

    float number(std::string_view what);
    /// The same, within [lo, hi].
    float number(std::string_view what, float lo, float hi, std::string_view expected);
    int integer(std::string_view what, int lo, int hi);
    Vec3 vec3(std::string_view what);
    /// Three numbers that are not negative.
    Vec3 color(std::string_view what);
    /// Three numbers that are not all 0.
    Vec3 direction(std::string_view what);
    std::string path(std::string_view what);

  private:
    TextToken scan(size_t from) const;

    TextSource source_;
    TextToken next_;
    std::optional<Error> error_;
};

}  // namespace glint
