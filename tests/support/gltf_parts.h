// Buffers of glTF files, part by part.
#pragma once

#include <initializer_list>
#include <string>

#include "tests/support/gltf_files.h"

namespace glint::test {

/// Component types of accessors, as the specification numbers them.
constexpr int kByte = 5121, kShort = 5122, kFloat = 5126;

/// A buffer of which each part has a view and an accessor; the first is a triangle's corners.
class Parts {
  public:
    Parts() { add(packed<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}), kFloat, "VEC3", 3); }

    int add(const std::string& bytes, int type, const std::string& shape, int count,
            bool normalized = false) {
        const std::string comma = count_ > 0 ? "," : "";
        views_ += comma + R"({"buffer": 0, "byteOffset": )" + std::to_string(buffer.size()) +
                  ", \"byteLength\": " + std::to_string(bytes.size()) + "}";
        accessors_ += comma + "{\"bufferView\": " + std::to_string(count_) +
                      ", \"componentType\": " + std::to_string(type) + ", \"type\": \"" + shape +
                      "\", \"count\": " + std::to_string(count) +
                      (normalized ? ", \"normalized\": true}" : "}");
        buffer += bytes + std::string((4 - bytes.size() % 4) % 4, '\0');
        return count_++;
    }
    int times(std::initializer_list<float> seconds) {
        return add(packed<float>(seconds), kFloat, "SCALAR", static_cast<int>(seconds.size()));
    }
    int vectors(std::initializer_list<float> numbers, int width) {
        const std::string shape = width == 1 ? "SCALAR" : "VEC" + std::to_string(width);
        return add(packed<float>(numbers), kFloat, shape, static_cast<int>(numbers.size()) / width);
    }
    std::string text() const {
        return "\"bufferViews\": [" + views_ + "], \"accessors\": [" + accessors_ + "]";
    }

    std::string buffer;

  private:
    std::string views_, accessors_;
    int count_ = 0;
};

}  // namespace glint::test
