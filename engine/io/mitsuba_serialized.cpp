// Mitsuba's manual (version 0.6), section 8.2.3: a header of two shorts, a zlib stream for each mesh, and at
// the end where each begins.
#include "engine/io/mitsuba_serialized.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <fmt/format.h>
#include <zlib.h>

namespace glint {
namespace {

constexpr uint16_t kFileId = 0x041c;
constexpr size_t kHeaderBytes = 4;
constexpr uint64_t kMaxCount = uint64_t{1} << 26;
constexpr uint32_t kHasNormals = 0x0001, kHasUvs = 0x0002, kHasColors = 0x0008, kHasFaceNormals = 0x0010,
                   kSingle = 0x1000, kDouble = 0x2000;

template <class T>
T numberAt(std::string_view bytes, size_t at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

/// Unpacks as it is read from, so that nothing is allocated for numbers that a file merely states.
class Inflater {
  public:
    explicit Inflater(std::string_view packed) {
        stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));  // zlib only reads it
        stream_.avail_in = static_cast<uInt>(std::min<size_t>(packed.size(), UINT32_MAX));
        isGood_ = inflateInit(&stream_) == Z_OK;
    }
    ~Inflater() { inflateEnd(&stream_); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    bool isGood() const { return isGood_; }

    template <class T>
    T read() {
        T value{};
        fill(&value, sizeof value);
        return value;
    }

    /// `count` groups of numbers of the file's precision.
    template <int kComponents, class Vector>
    void readVectors(uint64_t count, bool isDouble, std::vector<Vector>* out) {
        constexpr uint64_t kChunk = 1 << 15;
        std::vector<double> doubles;
        for (uint64_t done = 0; done < count && isGood_; done += kChunk) {
            const size_t n = static_cast<size_t>(std::min(kChunk, count - done));
            const size_t before = out->size();
            out->resize(before + n);
            if (!isDouble) {
                fill(out->data() + before, n * sizeof(Vector));
                continue;
            }
            doubles.resize(n * kComponents);
            fill(doubles.data(), doubles.size() * sizeof(double));
            for (size_t i = 0; i < doubles.size(); ++i) {
                (*out)[before + i / kComponents][static_cast<int>(i % kComponents)] =
                    static_cast<float>(doubles[i]);
            }
        }
    }

    void fill(void* to, size_t bytes) {
        stream_.next_out = static_cast<Bytef*>(to);
        stream_.avail_out = static_cast<uInt>(bytes);
        while (isGood_ && stream_.avail_out > 0) {
            const int state = inflate(&stream_, Z_NO_FLUSH);
            isGood_ = state == Z_OK || (state == Z_STREAM_END && stream_.avail_out == 0);
        }
        if (!isGood_) { std::memset(to, 0, bytes); }
    }

  private:
    z_stream stream_{};
    bool isGood_ = false;
};

void readIndices(Inflater* in, uint64_t triangles, bool areLong, std::vector<uint32_t>* out) {
    constexpr uint64_t kChunk = 1 << 15;
    std::vector<uint64_t> longs;
    for (uint64_t done = 0; done < 3 * triangles && in->isGood(); done += kChunk) {
        const size_t n = static_cast<size_t>(std::min(kChunk, 3 * triangles - done)), before = out->size();
        out->resize(before + n);
        if (!areLong) {
            in->fill(out->data() + before, n * sizeof(uint32_t));
            continue;
        }
        longs.resize(n);
        in->fill(longs.data(), n * sizeof(uint64_t));
        std::ranges::transform(longs, out->begin() + static_cast<ptrdiff_t>(before), [](uint64_t index) {
            return static_cast<uint32_t>(std::min<uint64_t>(index, UINT32_MAX));
        });
    }
}

Result<SerializedMesh> parseMesh(std::string_view packed, int version, const std::string& path) {
    const auto error = [&path](std::string message) { return Error{std::move(message), {.file = path}}; };
    Inflater in(packed);
    const auto flags = in.read<uint32_t>();
    for (char c = 1; version >= 4 && c != 0 && in.isGood();) {
        c = in.read<char>();  // the name
    }
    const auto vertices = in.read<uint64_t>(), triangles = in.read<uint64_t>();
    if (!in.isGood()) { return error("the mesh is cut off, or its compressed data is broken"); }
    if (vertices > kMaxCount || triangles > kMaxCount || triangles == 0) {
        return error(fmt::format("there cannot be {} vertices and {} triangles", vertices, triangles));
    }
    const bool isDouble = (flags & kDouble) != 0;
    if (isDouble == ((flags & kSingle) != 0)) { return error("its numbers are neither single nor double"); }
    SerializedMesh out{std::make_shared<MeshData>(), (flags & kHasFaceNormals) != 0};
    MeshData& mesh = *out.mesh;
    in.readVectors<3>(vertices, isDouble, &mesh.positions);
    if ((flags & kHasNormals) != 0) { in.readVectors<3>(vertices, isDouble, &mesh.normals); }
    if ((flags & kHasUvs) != 0) { in.readVectors<2>(vertices, isDouble, &mesh.uvs); }
    if ((flags & kHasColors) != 0) { in.readVectors<3>(vertices, isDouble, &mesh.colors); }
    readIndices(&in, triangles, vertices > UINT32_MAX, &mesh.indices);
    if (!in.isGood()) { return error("the mesh is cut off, or its compressed data is broken"); }
    for (const Vec3& p : mesh.positions) {
        if (!(maxComponent(absVec(p)) <= kMaxCoordinate)) {
            return error("a position is not finite or above 1e18");
        }
    }
    for (const uint32_t index : mesh.indices) {
        if (index >= vertices) {
            return error(fmt::format("there is no vertex {}; there are {}", index, vertices));
        }
    }
    return out;
}

}  // namespace

Result<SerializedMesh> parseSerialized(const std::string& bytes, const std::string& path, int number) {
    const auto error = [&path](std::string message) { return Error{std::move(message), {.file = path}}; };
    if (bytes.size() < kHeaderBytes + sizeof(uint32_t) || numberAt<uint16_t>(bytes, 0) != kFileId) {
        return error("is no serialized Mitsuba mesh");
    }
    const int version = numberAt<uint16_t>(bytes, 2);
    if (version != 3 && version != 4) {
        return error(fmt::format("is a serialized mesh of version {}; expected 3 or 4", version));
    }
    const uint64_t count = numberAt<uint32_t>(bytes, bytes.size() - sizeof(uint32_t));
    const uint64_t entry = version == 4 ? sizeof(uint64_t) : sizeof(uint32_t);
    const uint64_t table = count * entry + sizeof(uint32_t);
    if (count == 0 || table > bytes.size() - kHeaderBytes) {
        return error(fmt::format("the file is cut off: it cannot hold {} meshes", count));
    }
    if (number < 0 || static_cast<uint64_t>(number) >= count) {
        return error(fmt::format("has {} meshes; there is no mesh {} (they count from 0)", count, number));
    }
    const size_t tableAt = bytes.size() - static_cast<size_t>(table);
    const size_t at = tableAt + static_cast<size_t>(number) * static_cast<size_t>(entry);
    const uint64_t begin = version == 4 ? numberAt<uint64_t>(bytes, at) : numberAt<uint32_t>(bytes, at);
    if (begin > tableAt || tableAt - begin < kHeaderBytes) {
        return error(fmt::format("mesh {} begins beyond the file's end", number));
    }
    const std::string_view packed =
        std::string_view(bytes).substr(static_cast<size_t>(begin), tableAt - static_cast<size_t>(begin));
    return parseMesh(packed.substr(kHeaderBytes), version, path);
}

}  // namespace glint
