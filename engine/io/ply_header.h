// The text part of a PLY file: which elements follow, with which properties, in which encoding. For
// ply_loader.cpp only.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"

namespace glint {

enum class PlyFormat : uint8_t { Ascii, BinaryLittleEndian, BinaryBigEndian };
enum class PlyType : uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

constexpr bool isFloat(PlyType type) { return type == PlyType::Float32 || type == PlyType::Float64; }
/// Bytes in binary files.
constexpr size_t sizeOf(PlyType type) {
    constexpr size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[static_cast<size_t>(type)];
}

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float32;  ///< of a list's items, for lists
    bool isList = false;
    PlyType countType = PlyType::Uint8;
};

struct PlyElement {
    std::string name;
    uint64_t count = 0;
    std::vector<PlyProperty> properties;
    SourcePlace place;  ///< its line in the header

    /// Whether it has one of these names, in any case.
    bool is(std::initializer_list<std::string_view> names) const;
    /// Index of the first property with one of these names, in any case, or -1.
    int find(std::initializer_list<std::string_view> names) const;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
    std::vector<std::string>
        textures;           ///< what `comment TextureFile` lines (and the like) name, in file order
    size_t bodyOffset = 0;  ///< of the first byte after the line end_header
    std::vector<std::string> warnings;
};

/// How many bytes it takes, with the end of its last line, whatever ends lines; all where it has no end.
size_t sizeOfPlyHeader(const std::string& bytes);

/// Error: with line and column.
Result<PlyHeader> parsePlyHeader(const std::string& bytes, const std::string& path);

}  // namespace glint
