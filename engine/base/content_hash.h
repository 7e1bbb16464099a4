// A 128-bit fingerprint of data, the same on every little-endian machine and in every version of Glint.
//
// For telling whether a checkpoint belongs to a scene and whether a file is damaged. It is not cryptographic:
// nobody is kept from making two scenes with one fingerprint.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace glint {

struct Hash128 {
    uint64_t low = 0;
    uint64_t high = 0;

    bool operator==(const Hash128&) const = default;
    /// 32 hexadecimal digits.
    std::string hex() const;
};

/// Takes data piece by piece. The pieces' sizes enter too, so that ("ab", "c") and ("a", "bc") differ.
class ContentHash {
  public:
    void addBytes(const void* data, size_t size);
    /// Of `size` bytes that come in pieces, each of a whole number of 8 bytes but the last: the same as
    /// addBytes() of all together.
    void beginBytes(size_t size) { addWord(size); }
    void addPiece(const void* data, size_t size);
    void add(std::string_view text) { addBytes(text.data(), text.size()); }

    /// Numbers and enumerations. Structs may hold padding: add their fields.
    template <class T>
    requires std::is_arithmetic_v<T> || std::is_enum_v<T>
    void add(T value) { addBytes(&value, sizeof value); }

    Hash128 finish() const;

  private:
    void addWord(uint64_t word);

    uint64_t low_ = 0x243f6a8885a308d3u;  // the first digits of pi: any numbers without a pattern do
    uint64_t high_ = 0x13198a2e03707344u;
};

}  // namespace glint
