// KHR_draco_mesh_compression, unpacked by Draco.
#include <map>
#include <new>

#include <draco/compression/decode.h>
#include <fmt/format.h>

#include "engine/io/byte_stream.h"
#include "engine/io/gltf_accessor.h"
#include "engine/io/gltf_compression.h"

namespace glint {
namespace {

/// Seven bits a byte, the low ones first.
uint64_t readVarint(ByteReader* bytes) {
    uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 7) {
        const auto byte = bytes->read<uint8_t>();
        value |= static_cast<uint64_t>(byte & 0x7f) << shift;
        if ((byte & 0x80) == 0) { break; }
    }
    return value;
}

/// Draco allocates what the first bytes state before it looks at the others ("Draco Bitstream Specification",
/// version 2.2, sections 2 to 6). Faces and vertices together.
Result<uint64_t> statedCounts(const GltfFile& file, std::string_view data, const std::string& what) {
    constexpr uint64_t kMostPerByte = 4096, kMostCount = uint64_t{1} << 26;
    ByteReader bytes(data);
    const std::string_view magic = bytes.readRaw(5);
    const auto major = bytes.read<uint8_t>(), minor = bytes.read<uint8_t>();
    const auto kind = bytes.read<uint8_t>(), method = bytes.read<uint8_t>();
    const auto flags = bytes.read<uint16_t>();
    constexpr uint16_t kHasMetadata = 0x8000;
    if (magic != "DRACO" || major != 2 || minor != 2 || kind != 1 || method > 1 ||
        (flags & kHasMetadata) != 0) {
        return file.error(what + " is no Draco mesh of version 2.2");
    }
    constexpr uint8_t kEdgebreaker = 1;
    if (method == kEdgebreaker) { bytes.read<uint8_t>(); }
    uint64_t both = 0;
    for (int i = 0; i < 2; ++i) {  // faces and vertices, the one or the other first
        const uint64_t count = readVarint(&bytes);
        if (count > kMostCount || count > kMostPerByte * data.size()) {
            return file.error(fmt::format("{}: {} vertices or faces are more than its {} bytes can hold",
                                          what, count, data.size()));
        }
        both += count;
    }
    if (bytes.failed()) { return file.error(what + " is cut off"); }
    return both;
}

/// A further buffer with a view of it, which is returned.
int addView(std::vector<unsigned char> bytes, tinygltf::Model* model) {
    tinygltf::BufferView view;
    view.buffer = static_cast<int>(model->buffers.size());
    view.byteLength = bytes.size();
    model->buffers.emplace_back().data = std::move(bytes);
    model->bufferViews.push_back(std::move(view));
    return static_cast<int>(model->bufferViews.size()) - 1;
}

template <class Number>
std::vector<unsigned char> valuesAs(const draco::PointAttribute& attribute, uint32_t points, int components) {
    const size_t size = sizeof(Number) * static_cast<size_t>(components);
    std::vector<unsigned char> out(points * size);
    for (uint32_t i = 0; i < points; ++i) {
        attribute.ConvertValue<Number>(attribute.mapped_index(draco::PointIndex(i)),
                                       static_cast<int8_t>(components),
                                       reinterpret_cast<Number*>(&out[i * size]));
    }
    return out;
}

/// Of the accessor's type; empty: there is no such type.
std::vector<unsigned char> valuesOf(const draco::PointAttribute& attribute, uint32_t points,
                                    const tinygltf::Accessor& accessor) {
    const int components = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor.type));
    constexpr int kMost = 4;
    if (components < 1 || components > kMost) { return {}; }
    switch (accessor.componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return valuesAs<int8_t>(attribute, points, components);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return valuesAs<uint8_t>(attribute, points, components);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return valuesAs<int16_t>(attribute, points, components);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return valuesAs<uint16_t>(attribute, points, components);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return valuesAs<uint32_t>(attribute, points, components);
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return valuesAs<float>(attribute, points, components);
        default:
            return {};
    }
}

class DracoReader {
  public:
    explicit DracoReader(GltfFile* file) : file_(*file), model_(file->model) {
        constexpr uint64_t kAlways = uint64_t{64} << 20, kBytesPerByte = 1024;
        budgetBytes_ = kAlways;
        for (const tinygltf::Buffer& buffer : model_.buffers) {
            budgetBytes_ += kBytesPerByte * buffer.data.size();
        }
    }

    Status unpack(tinygltf::Primitive* primitive, const std::string& what) {
        const auto* packed = extensionOf(*primitive, kDraco);
        if (packed == nullptr) { return {}; }
        const auto view = indexOf(packed, "bufferView");
        const Result<const draco::Mesh*> mesh = meshOf(view, what);
        if (!mesh) { return mesh.error(); }
        const tinygltf::Value& attributes = packed->Get("attributes");
        for (const std::string& name :
             attributes.IsObject() ? attributes.Keys() : std::vector<std::string>()) {
            const auto id = indexOf(&attributes, name.c_str());
            if (Status read = readAttribute(**mesh, view, id, name, what, primitive); !read) { return read; }
        }
        primitive->mode = TINYGLTF_MODE_TRIANGLES;
        primitive->indices = indicesOf(**mesh, view);
        return {};
    }

  private:
    /// Of the memory that all meshes together may take, since views may share their bytes.
    Status take(uint64_t bytes, const std::string& what) {
        if (bytes > budgetBytes_) { return file_.error(what + ": the file's meshes unpack to too much"); }
        budgetBytes_ -= bytes;
        return {};
    }

    /// Primitives may share one.
    Result<const draco::Mesh*> meshOf(int view, const std::string& what) {
        std::unique_ptr<draco::Mesh>& mesh = meshes_[view];
        if (mesh) { return mesh.get(); }
        const Result<std::string_view> bytes = bufferViewBytes(file_, view, what);
        if (!bytes) { return bytes.error(); }
        const Result<uint64_t> count = statedCounts(file_, *bytes, what);
        if (!count) { return count.error(); }
        if (Status taken = take(*count * kBytesPerElement, what); !taken) { return taken.error(); }
        draco::DecoderBuffer buffer;
        buffer.Init(bytes->data(), bytes->size());
        try {
            auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
            if (!decoded.ok()) {
                return file_.error(fmt::format("{} is broken: {}", what, decoded.status().error_msg()));
            }
            mesh = std::move(decoded).value();
        } catch (const std::bad_alloc&) { return file_.error(what + " states more than any memory holds"); }
        return mesh.get();
    }

    Status readAttribute(const draco::Mesh& mesh, int view, int id, const std::string& name,
                         const std::string& what, tinygltf::Primitive* primitive) {
        const auto found = primitive->attributes.find(name);
        const draco::PointAttribute* attribute =
            id >= 0 ? mesh.GetAttributeByUniqueId(static_cast<uint32_t>(id)) : nullptr;
        if (found == primitive->attributes.end() || found->second < 0 ||
            static_cast<size_t>(found->second) >= model_.accessors.size() || attribute == nullptr) {
            return file_.error(fmt::format("{} has no {}", what, name));
        }
        const auto [known, isNew] = accessors_.try_emplace({view, id, found->second}, 0);
        if (isNew) {
            tinygltf::Accessor accessor = model_.accessors[static_cast<size_t>(found->second)];
            const uint32_t points = mesh.num_points();
            if (accessor.count != points) {
                return file_.error(fmt::format("{}: its accessor states {} of {}, Draco holds {}", what,
                                               accessor.count, name, points));
            }
            if (Status taken = take(uint64_t{points} * kBytesPerElement, what); !taken) { return taken; }
            accessor.bufferView = addView(valuesOf(*attribute, points, accessor), &model_);
            accessor.byteOffset = 0;
            known->second = add(std::move(accessor));
        }
        found->second = known->second;
        return {};
    }

    int indicesOf(const draco::Mesh& mesh, int view) {
        const auto [known, isNew] = accessors_.try_emplace({view, -1, -1}, 0);
        if (!isNew) { return known->second; }
        std::vector<unsigned char> bytes(size_t{12} * mesh.num_faces());
        for (uint32_t i = 0; i < mesh.num_faces(); ++i) {
            for (size_t c = 0; c < 3; ++c) {
                const uint32_t corner = mesh.face(draco::FaceIndex(i))[c].value();
                std::memcpy(&bytes[12 * size_t{i} + 4 * c], &corner, sizeof corner);
            }
        }
        tinygltf::Accessor accessor;
        accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
        accessor.type = TINYGLTF_TYPE_SCALAR;
        accessor.count = size_t{3} * mesh.num_faces();
        accessor.bufferView = addView(std::move(bytes), &model_);
        return known->second = add(std::move(accessor));
    }

    int add(tinygltf::Accessor accessor) {
        model_.accessors.push_back(std::move(accessor));
        return static_cast<int>(model_.accessors.size()) - 1;
    }

    /// About what a face or a vertex takes, decoded.
    static constexpr uint64_t kBytesPerElement = 16;

    GltfFile& file_;
    tinygltf::Model& model_;
    uint64_t budgetBytes_ = 0;
    std::map<int, std::unique_ptr<draco::Mesh>> meshes_;  ///< by buffer view
    std::map<std::array<int, 3>, int> accessors_;         ///< by buffer view, attribute and accessor
};

}  // namespace

Status unpackPrimitives(GltfFile* file) {
    DracoReader reader(file);
    for (size_t i = 0; i < file->model.meshes.size(); ++i) {
        auto& primitives = file->model.meshes[i].primitives;
        for (size_t k = 0; k < primitives.size(); ++k) {
            const std::string what = fmt::format("mesh {}, primitive {}, its Draco mesh", i, k);
            if (Status unpacked = reader.unpack(&primitives[k], what); !unpacked) { return unpacked; }
        }
    }
    return {};
}

}  // namespace glint
