// JSON text with comments as a flat tree whose every value knows its place. For the scene reader; no
// general library.
//
// Numbers stay text until they are asked for, so that a float is rounded once. A value costs 16 bytes beside
// the text.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/io/text_source.h"

namespace glint {

enum class JsonType : uint8_t { Null, Bool, Number, String, Array, Object };

/// One value of the tree. Children follow their parent directly; an object's children alternate key
/// and value.
struct JsonNode {
    uint32_t begin;  ///< bytes of the source: [begin, end); strings without their quotes
    uint32_t end;
    uint32_t next;  ///< index of the first node after this one and its children
    JsonType type;
};

struct JsonDocument {
    TextSource source;
    std::vector<JsonNode> nodes;  ///< nodes[0] is the root
};

/// Parses JSON with // and /* */ comments. Errors: anything outside the grammar, a key twice in one object,
/// nesting deeper than 64, more than 2 GiB of text; all with their place.
Result<std::shared_ptr<const JsonDocument>> parseJson(TextSource source);

/// A cheap handle on one value; valid as long as the document. A default-made one stands for "absent".
class JsonValue {
  public:
    JsonValue() = default;
    explicit JsonValue(const JsonDocument* document, uint32_t index = 0)
        : document_(document), index_(index) {}

    bool present() const { return document_ != nullptr; }
    JsonType type() const { return node().type; }
    bool is(JsonType wanted) const { return present() && type() == wanted; }
    /// The source text: a number's digits, `true`, a string's characters with their escapes.
    std::string_view raw() const;
    /// A string with its escapes resolved.
    std::string string() const;
    /// An error at the value's first character, a string's opening quote.
    Error error(std::string message) const;

    /// Elements of an array, or keys and values in turn of an object: for (v = first(); v.present(); v
    /// = next(v)).
    JsonValue first() const;
    JsonValue next(const JsonValue& child) const;
    uint32_t size() const;  ///< elements, or members; walks them

  private:
    const JsonNode& node() const { return document_->nodes[index_]; }

    const JsonDocument* document_ = nullptr;
    uint32_t index_ = 0;
};

/// "a number", "an object", … for messages.
std::string_view describe(JsonType type);

/// `text` in quotes with JSON's escapes.
std::string quoteJson(std::string_view text);

}  // namespace glint
