// Numbers in the buffers of a glTF file: every component type, strides and sparse accessors.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/io/gltf_file.h"

namespace glint {

/// What an accessor holds, one element after the other; integers that are normalised are in [-1, 1].
struct GltfNumbers {
    int components = 0;
    std::vector<float> values;

    size_t count() const { return values.size() / static_cast<size_t>(components); }
    const float* at(size_t element) const { return &values[element * static_cast<size_t>(components)]; }
};

/// The accessor of a primitive's attribute; -1: it has none of that name.
int accessorOf(const tinygltf::Primitive& primitive, const std::string& attribute);

/// `what` names the accessor's user in messages. Error: there is no such accessor, it ends beyond its buffer,
/// has another number of components than `least` to `most`, or is too large for any file.
Result<GltfNumbers> readNumbers(const GltfFile& file, int accessor, int least, int most,
                                const std::string& what);

/// Of each accessor of the file, the first one that says the same: of the same bytes and type.
std::vector<int> firstsOfTheSame(const GltfFile& file);

/// readNumbers() of whole numbers >= 0.
Result<std::vector<uint32_t>> readIndices(const GltfFile& file, int accessor, const std::string& what);

/// The bytes of a buffer view. Error: it ends beyond its buffer.
Result<std::string_view> bufferViewBytes(const GltfFile& file, int view, const std::string& what);

}  // namespace glint
