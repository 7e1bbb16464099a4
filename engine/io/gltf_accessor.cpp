#include "engine/io/gltf_accessor.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <tuple>

#include <fmt/format.h>

namespace glint {
namespace {

constexpr uint64_t kMaxElements = uint64_t{1} << 28;
constexpr uint64_t kMaxZeros = uint64_t{1}
                               << 24;  ///< of accessors without a buffer, which cost a file nothing

template <class Number>
double loaded(const char* at) {
    Number value;
    std::memcpy(&value, at, sizeof value);
    return static_cast<double>(value);
}

double component(const char* at, int type, bool isNormalized) {
    const double scale = isNormalized ? 1.0 : 0.0;
    const auto norm = [scale](double value, double largest) {
        return scale > 0.0 ? std::max(value / largest, -1.0) : value;
    };
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return norm(loaded<int8_t>(at), 127.0);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return norm(loaded<uint8_t>(at), 255.0);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return norm(loaded<int16_t>(at), 32767.0);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return norm(loaded<uint16_t>(at), 65535.0);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return norm(loaded<uint32_t>(at), 4294967295.0);
        default:
            return loaded<float>(at);
    }
}

/// 0: there is no such type.
size_t sizeOf(int componentType) {
    switch (componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return 1;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return 2;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return 4;
        default:
            return 0;
    }
}

struct Elements {
    std::string_view bytes;  ///< from the first one
    size_t stride = 0;

    const char* at(uint64_t index) const { return bytes.data() + index * stride; }
};

/// `count` elements of `size` bytes, all of them within the view.
Result<Elements> elementsOf(const GltfFile& file, int view, uint64_t offset, uint64_t count, size_t size,
                            const std::string& what) {
    const Result<std::string_view> bytes = bufferViewBytes(file, view, what);
    if (!bytes) { return bytes.error(); }
    const size_t stated = file.model.bufferViews[static_cast<size_t>(view)].byteStride;
    const size_t stride = stated > 0 ? stated : size;
    const uint64_t end = count == 0 ? 0 : (count - 1) * stride + size;
    if (stride < size || offset > bytes->size() || end > bytes->size() - offset) {
        return file.error(
            fmt::format("{}: {} elements of {} bytes end beyond their buffer view, which has {} bytes", what,
                        count, stride, bytes->size()));
    }
    return Elements{bytes->substr(static_cast<size_t>(offset)), stride};
}

Status applySparse(const GltfFile& file, const tinygltf::Accessor& accessor, size_t components,
                   const std::string& what, std::vector<double>* values) {
    const auto& sparse = accessor.sparse;
    if (!sparse.isSparse) { return {}; }
    const size_t indexSize = sizeOf(sparse.indices.componentType), size = sizeOf(accessor.componentType);
    if (indexSize == 0 || sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) {
        return file.error(what + ": its sparse part makes no sense");
    }
    const auto count = static_cast<uint64_t>(sparse.count);
    const auto places = elementsOf(file, sparse.indices.bufferView,
                                   static_cast<uint64_t>(sparse.indices.byteOffset), count, indexSize, what);
    if (!places) { return places.error(); }
    const auto replaced =
        elementsOf(file, sparse.values.bufferView, static_cast<uint64_t>(sparse.values.byteOffset), count,
                   size * components, what);
    if (!replaced) { return replaced.error(); }
    for (uint64_t i = 0; i < count; ++i) {
        const double index = component(places->at(i), sparse.indices.componentType, false);
        if (!(index >= 0.0 && index < static_cast<double>(accessor.count))) {
            return file.error(
                fmt::format("{}: its sparse part replaces element {} of {}", what, index, accessor.count));
        }
        for (size_t c = 0; c < components; ++c) {
            (*values)[static_cast<size_t>(index) * components + c] =
                component(replaced->at(i) + c * size, accessor.componentType, accessor.normalized);
        }
    }
    return {};
}

/// In double, which holds every index.
Result<std::vector<double>> readValues(const GltfFile& file, int index, int least, int most,
                                       const std::string& what, int* components) {
    const auto& accessors = file.model.accessors;
    if (index < 0 || static_cast<size_t>(index) >= accessors.size()) {
        return file.error(
            fmt::format("{}: there is no accessor {}; the file has {}", what, index, accessors.size()));
    }
    const tinygltf::Accessor& accessor = accessors[static_cast<size_t>(index)];
    const std::string name = fmt::format("{}, accessor {}", what, index);
    *components = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor.type));
    const size_t size = sizeOf(accessor.componentType);
    if (*components < least || *components > most || accessor.type == TINYGLTF_TYPE_MAT2 || size == 0) {
        return file.error(fmt::format("{}: expected elements of {}{} numbers", name, least,
                                      most > least ? fmt::format(" to {}", most) : ""));
    }
    const auto width = static_cast<size_t>(*components);
    if (accessor.count > (accessor.bufferView < 0 ? kMaxZeros : kMaxElements)) {
        return file.error(fmt::format("{}: {} elements are too many", name, accessor.count));
    }
    std::vector<double> values;
    if (accessor.bufferView >= 0) {
        const auto elements =
            elementsOf(file, accessor.bufferView, accessor.byteOffset, accessor.count, size * width, name);
        if (!elements) { return elements.error(); }
        values.reserve(accessor.count * width);
        for (size_t i = 0; i < accessor.count; ++i) {
            for (size_t c = 0; c < width; ++c) {
                values.push_back(
                    component(elements->at(i) + c * size, accessor.componentType, accessor.normalized));
            }
        }
    } else {
        values.assign(accessor.count * width, 0.0);
    }
    if (Status sparse = applySparse(file, accessor, width, name, &values); !sparse) { return sparse.error(); }
    return values;
}

}  // namespace

int accessorOf(const tinygltf::Primitive& primitive, const std::string& attribute) {
    const auto found = primitive.attributes.find(attribute);
    return found != primitive.attributes.end() ? found->second : -1;
}

Result<std::string_view> bufferViewBytes(const GltfFile& file, int index, const std::string& what) {
    const auto& views = file.model.bufferViews;
    if (index < 0 || static_cast<size_t>(index) >= views.size()) {
        return file.error(
            fmt::format("{}: there is no buffer view {}; the file has {}", what, index, views.size()));
    }
    const tinygltf::BufferView& view = views[static_cast<size_t>(index)];
    const auto& buffers = file.model.buffers;
    if (view.buffer < 0 || static_cast<size_t>(view.buffer) >= buffers.size()) {
        return file.error(
            fmt::format("{}: there is no buffer {}; the file has {}", what, view.buffer, buffers.size()));
    }
    const std::vector<unsigned char>& bytes = buffers[static_cast<size_t>(view.buffer)].data;
    if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset) {
        return file.error(
            fmt::format("{}: buffer view {} ends beyond its buffer of {} bytes", what, index, bytes.size()));
    }
    return std::string_view(reinterpret_cast<const char*>(bytes.data()) + view.byteOffset, view.byteLength);
}

Result<GltfNumbers> readNumbers(const GltfFile& file, int accessor, int least, int most,
                                const std::string& what) {
    GltfNumbers numbers;
    const auto values = readValues(file, accessor, least, most, what, &numbers.components);
    if (!values) { return values.error(); }
    numbers.values.assign(values->begin(), values->end());
    return numbers;
}

std::vector<int> firstsOfTheSame(const GltfFile& file) {
    using Key = std::tuple<int, size_t, int, bool, size_t, int>;
    std::map<Key, int> firsts;
    std::vector<int> same;
    for (const tinygltf::Accessor& a : file.model.accessors) {
        const auto number = static_cast<int>(same.size());
        const Key key{a.bufferView, a.byteOffset, a.componentType, a.normalized, a.count, a.type};
        same.push_back(a.sparse.isSparse ? number : firsts.try_emplace(key, number).first->second);
    }
    return same;
}

Result<std::vector<uint32_t>> readIndices(const GltfFile& file, int accessor, const std::string& what) {
    int components = 0;
    const auto values = readValues(file, accessor, 1, 1, what, &components);
    if (!values) { return values.error(); }
    std::vector<uint32_t> indices;
    for (const double value : *values) {
        if (!(value >= 0.0 && value <= 4294967295.0)) {
            return file.error(what + ": an index is no whole number");
        }
        indices.push_back(static_cast<uint32_t>(value));
    }
    return indices;
}

}  // namespace glint
