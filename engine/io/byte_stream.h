// Plain numbers and text to and from bytes, little-endian, with every read checked. For Glint's own
// binary files.
//
// Knows nothing of any format. A reader that has failed stays failed and gives zeros, so that a caller may
// read a whole record and ask once.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace glint {

class ByteWriter {
  public:
    template <class T>
    requires std::is_arithmetic_v<T>
    void write(T value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); }
    /// Length and characters.
    void writeText(std::string_view text) {
        write(static_cast<uint64_t>(text.size()));
        bytes_.append(text);
    }
    void writeRaw(std::string_view bytes) { bytes_.append(bytes); }
    /// Replaces a number that was written before, `at` bytes from the start.
    template <class T>
    requires std::is_arithmetic_v<T>
    void overwrite(size_t at, T value) { std::memcpy(bytes_.data() + at, &value, sizeof value); }
    void reserve(size_t bytes) { bytes_.reserve(bytes); }
    const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
};

class ByteReader {
  public:
    explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

    template <class T>
    requires std::is_arithmetic_v<T> T read() {
        T value{};
        const std::string_view raw = readRaw(sizeof value);
        if (!failed_) { std::memcpy(&value, raw.data(), sizeof value); }
        return value;
    }
    std::string readText() { return std::string(readRaw(read<uint64_t>())); }
    std::string_view readRaw(uint64_t size) {
        if (failed_ || size > rest_.size()) {
            failed_ = true;
            return {};
        }
        const std::string_view out = rest_.substr(0, static_cast<size_t>(size));
        rest_.remove_prefix(static_cast<size_t>(size));
        return out;
    }

    bool failed() const { return failed_; }
    uint64_t left() const { return rest_.size(); }

  private:
    std::string_view rest_;
    bool failed_ = false;
};

}  // namespace glint
