// EXT_meshopt_compression, unpacked by meshoptimizer.
#include <optional>

#include <fmt/format.h>
#include <meshoptimizer.h>

#include "engine/io/gltf_compression.h"

namespace glint {
namespace {

/// The format's own bound: of 16 equal bytes, two bits stay.
constexpr uint64_t kMostUnpacked = 64;

struct PackedView {
    std::string_view bytes;
    uint64_t count, stride;
    std::string mode, filter;
};

/// SIZE_MAX: it is no such number.
size_t wholeNumber(const tinygltf::Value& value, const char* key, double otherwise) {
    const double number = numberOf(&value, key, otherwise);
    constexpr double kMost = 9e15;
    return number >= 0.0 && number <= kMost ? static_cast<size_t>(number) : SIZE_MAX;
}

std::string textOf(const tinygltf::Value& value, const char* key) {
    return value.Get(key).IsString() ? value.Get(key).Get<std::string>() : std::string();
}

Result<PackedView> readPackedView(const GltfFile& file, const tinygltf::Value& from,
                                  const std::string& what) {
    const auto& buffers = file.model.buffers;
    const size_t buffer = wholeNumber(from, "buffer", -1.0), offset = wholeNumber(from, "byteOffset", 0.0);
    const size_t length = wholeNumber(from, "byteLength", -1.0);
    if (buffer >= buffers.size()) { return file.error(what + ": there is no such buffer"); }
    const auto& bytes = buffers[buffer].data;
    if (offset > bytes.size() || length > bytes.size() - offset) {
        return file.error(fmt::format("{} ends beyond its buffer of {} bytes", what, bytes.size()));
    }
    PackedView view{.bytes = {reinterpret_cast<const char*>(bytes.data()) + offset, length},
                    .count = wholeNumber(from, "count", -1.0),
                    .stride = wholeNumber(from, "byteStride", -1.0),
                    .mode = textOf(from, "mode"),
                    .filter = textOf(from, "filter")};
    if (view.filter.empty()) { view.filter = "NONE"; }
    constexpr size_t kMostStride = 256;
    const bool isOfVertices =
        view.mode == "ATTRIBUTES" && view.stride % 4 == 0 && view.stride >= 4 && view.stride <= kMostStride;
    const bool isOfIndices = (view.mode == "TRIANGLES" || view.mode == "INDICES") &&
                             (view.stride == 2 || view.stride == 4) && view.filter == "NONE" &&
                             (view.mode == "INDICES" || view.count % 3 == 0);
    const bool isFiltered = view.filter == "NONE" || view.filter == "EXPONENTIAL" ||
                            (view.filter == "OCTAHEDRAL" && (view.stride == 4 || view.stride == 8)) ||
                            (view.filter == "QUATERNION" && view.stride == 8);
    if (!(isOfVertices || isOfIndices) || !isFiltered) {
        return file.error(fmt::format("{} makes no sense: mode {}, filter {}, {} bytes an element", what,
                                      view.mode, view.filter, view.stride));
    }
    if (view.count > kMostUnpacked * length / view.stride) {
        return file.error(
            fmt::format("{}: {} elements are more than its {} bytes can hold", what, view.count, length));
    }
    return view;
}

/// False: the bytes are broken.
bool unpack(const PackedView& view, std::vector<unsigned char>* out) {
    out->resize(view.count * view.stride);
    const auto* bytes = reinterpret_cast<const unsigned char*>(view.bytes.data());
    const size_t size = view.bytes.size();
    if (view.mode == "TRIANGLES") {
        return meshopt_decodeIndexBuffer(out->data(), view.count, view.stride, bytes, size) == 0;
    }
    if (view.mode == "INDICES") {
        return meshopt_decodeIndexSequence(out->data(), view.count, view.stride, bytes, size) == 0;
    }
    if (meshopt_decodeVertexBuffer(out->data(), view.count, view.stride, bytes, size) != 0) { return false; }
    if (view.filter == "OCTAHEDRAL") { meshopt_decodeFilterOct(out->data(), view.count, view.stride); }
    if (view.filter == "QUATERNION") { meshopt_decodeFilterQuat(out->data(), view.count, view.stride); }
    if (view.filter == "EXPONENTIAL") { meshopt_decodeFilterExp(out->data(), view.count, view.stride); }
    return true;
}

}  // namespace

Status unpackViews(GltfFile* file) {
    uint64_t budget = 0;  // since views may share their bytes
    for (const auto& buffer : file->model.buffers) {
        budget += kMostUnpacked * buffer.data.size();
    }
    for (size_t i = 0; i < file->model.bufferViews.size(); ++i) {
        tinygltf::BufferView& view = file->model.bufferViews[i];
        const auto* packed = extensionOf(view, kMeshopt);
        if (packed == nullptr) { continue; }
        const std::string what = fmt::format("compressed buffer view {}", i);
        const Result<PackedView> from = readPackedView(*file, *packed, what);
        if (!from) { return from.error(); }
        tinygltf::Buffer buffer;
        const uint64_t size = from->count * from->stride;
        if (size > budget) { return file->error(what + ": too many views unpack the same bytes"); }
        budget -= size;
        if (!unpack(*from, &buffer.data)) { return file->error(what + " is broken or cut off"); }
        view.buffer = static_cast<int>(file->model.buffers.size());
        view.byteOffset = 0;
        view.byteLength = buffer.data.size();
        file->model.buffers.push_back(std::move(buffer));
    }
    return {};
}

}  // namespace glint
