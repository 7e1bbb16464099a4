#include "engine/io/mesh_normals.h"

#include <atomic>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "engine/base/parallel.h"
#include "engine/io/smoothing_fans.h"

namespace glint {
namespace {

constexpr uint32_t kNone = UINT32_MAX;

/// A vertex of any part, numbered through.
class PositionNumbers {
  public:
    explicit PositionNumbers(const std::vector<MeshPart>& parts) {
        size_t count = 0;
        for (const MeshPart& part : parts) {
            count += part.mesh->positions.size();
        }
        table_.assign(std::bit_ceil(2 * count + 1), {Vec3(0.0f), kNone});
    }

    /// Equal positions have equal numbers, counted from 0.
    uint32_t of(const Vec3& position) {
        const Vec3 p = position + Vec3(0.0f);  // -0 is 0
        size_t slot = hashOf(p) & (table_.size() - 1);
        while (table_[slot].number != kNone && table_[slot].position != p) {
            slot = (slot + 1) & (table_.size() - 1);
        }
        if (table_[slot].number == kNone) { table_[slot] = {p, count_++}; }
        return table_[slot].number;
    }
    uint32_t count() const { return count_; }

  private:
    struct Slot {
        Vec3 position;
        uint32_t number;
    };
    static size_t hashOf(const Vec3& p) {
        uint64_t hash = 0;
        for (int axis = 0; axis < 3; ++axis) {
            hash = (hash ^ std::bit_cast<uint32_t>(p[axis])) * 0x9e3779b97f4a7c15ull;
            hash ^= hash >> 29;
        }
        return static_cast<size_t>(hash);
    }

    std::vector<Slot> table_;
    uint32_t count_ = 0;
};

Vec3 faceNormal(const Vec3& a, const Vec3& b, const Vec3& c) {
    const glm::dvec3 n = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
    const double length = glm::length(n);
    return length > 0.0 ? Vec3(n / length) : Vec3(0.0f);
}

float angleAt(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 u = a - p;
    const Vec3 v = b - p;
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

bool lacksNormals(const MeshData& mesh, const uint32_t* corners) {
    return mesh.normals.empty() || (isZero(mesh.normals[corners[0]]) && isZero(mesh.normals[corners[1]]) &&
                                    isZero(mesh.normals[corners[2]]));
}

std::vector<SmoothFace> facesWithoutNormals(const std::vector<MeshPart>& parts) {
    std::vector<SmoothFace> faces;
    for (size_t p = 0; p < parts.size(); ++p) {
        const MeshData& mesh = *parts[p].mesh;
        const std::vector<SmoothingRun>& runs = parts[p].smoothing;
        size_t run = 0;
        for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
            while (run + 1 < runs.size() && runs[run + 1].firstTriangle <= t) {
                ++run;
            }
            const uint32_t* corners = &mesh.indices[3 * size_t{t}];
            if (!lacksNormals(mesh, corners)) { continue; }
            const Vec3 normal = faceNormal(mesh.positions[corners[0]], mesh.positions[corners[1]],
                                           mesh.positions[corners[2]]);
            if (isZero(normal)) { continue; }
            faces.push_back({static_cast<uint32_t>(p),
                             t,
                             {},
                             normal,
                             runs.empty() ? Smoothing::ByAngle : runs[run].group});
        }
    }
    return faces;
}

/// Writes corners' normals into a part's mesh. A vertex gets the normal of the first fan that has it; others
/// get copies.
class NormalWriter {
  public:
    explicit NormalWriter(MeshData* mesh) : mesh_(*mesh), heads_(mesh->positions.size(), kNone) {
        mesh_.normals.resize(mesh_.positions.size(), Vec3(0.0f));
    }

    void write(uint32_t* vertex, uint32_t fan, const Vec3& normal) {
        uint32_t& head = heads_[*vertex];
        int compared = 0;
        for (uint32_t i = head; i != kNone && compared < kMostCompared; i = copies_[i].next, ++compared) {
            if (copies_[i].fan == fan) {
                *vertex = copies_[i].vertex;
                return;
            }
        }
        const uint32_t own = head == kNone ? *vertex : copy(*vertex);
        copies_.push_back({fan, own, head});
        head = static_cast<uint32_t>(copies_.size()) - 1;
        mesh_.normals[own] = normal;
        *vertex = own;
    }

  private:
    /// Beyond, a fan may get a vertex twice, so that time stays linear.
    static constexpr int kMostCompared = 32;
    struct Copy {
        uint32_t fan;
        uint32_t vertex;
        uint32_t next;
    };

    uint32_t copy(uint32_t vertex) {
        const auto append = [vertex](auto& values) {
            if (!values.empty()) {
                const auto value = values[vertex];
                values.push_back(value);
            }
        };
        append(mesh_.positions);
        append(mesh_.normals);
        append(mesh_.uvs);
        append(mesh_.colors);
        append(mesh_.tangents);
        return static_cast<uint32_t>(mesh_.positions.size()) - 1;
    }

    MeshData& mesh_;
    std::vector<uint32_t> heads_;
    std::vector<Copy> copies_;
};

void numberPositions(const std::vector<MeshPart>& parts, std::vector<SmoothFace>* faces,
                     PositionNumbers* numbers) {
    for (SmoothFace& face : *faces) {
        const MeshData& mesh = *parts[face.part].mesh;
        for (int corner = 0; corner < 3; ++corner) {
            face.positions[corner] = numbers->of(
                mesh.positions[mesh.indices[3 * size_t{face.triangle} + static_cast<size_t>(corner)]]);
        }
    }
}

/// The unit normal of each fan, at its root's number.
std::vector<Vec3> fanNormals(const std::vector<MeshPart>& parts, const std::vector<SmoothFace>& faces,
                             SmoothingFans* fans) {
    std::vector<Vec3> sums(3 * faces.size(), Vec3(0.0f));
    for (size_t f = 0; f < faces.size(); ++f) {
        const MeshData& mesh = *parts[faces[f].part].mesh;
        const uint32_t* corners = &mesh.indices[3 * size_t{faces[f].triangle}];
        const Vec3 p[3] = {mesh.positions[corners[0]], mesh.positions[corners[1]],
                           mesh.positions[corners[2]]};
        for (uint32_t c = 0; c < 3; ++c) {
            sums[fans->rootOf(static_cast<uint32_t>(3 * f) + c)] +=
                angleAt(p[c], p[(c + 1) % 3], p[(c + 2) % 3]) * faces[f].normal;
        }
    }
    for (Vec3& sum : sums) {
        const float length = glm::length(sum);
        sum = length > 0.0f ? sum / length : sum;
    }
    return sums;
}

/// Of faces `begin` to `end`, which are of one part.
void writeNormals(const std::vector<Vec3>& normals, const std::vector<SmoothFace>& faces, size_t begin,
                  size_t end, SmoothingFans* fans, MeshData* mesh) {
    NormalWriter writer(mesh);
    for (size_t f = begin; f < end; ++f) {
        for (uint32_t c = 0; c < 3; ++c) {
            const uint32_t root = fans->rootOf(static_cast<uint32_t>(3 * f) + c);
            writer.write(&mesh->indices[3 * size_t{faces[f].triangle} + c], root,
                         isZero(normals[root]) ? faces[f].normal : normals[root]);
        }
    }
}

}  // namespace

uint64_t turnByNormals(MeshData* mesh) {
    if (mesh->normals.empty()) { return 0; }
    std::atomic<uint64_t> turned = 0;
    parallelChunks(mesh->triangleCount(), 1 << 16, 0, [&](int64_t begin, int64_t end) {
        uint64_t here = 0;
        for (int64_t t = begin; t < end; ++t) {
            uint32_t* corners = &mesh->indices[3 * static_cast<size_t>(t)];
            const Vec3& a = mesh->positions[corners[0]];
            const Vec3 normal = glm::cross(mesh->positions[corners[1]] - a, mesh->positions[corners[2]] - a);
            const Vec3 wanted =
                mesh->normals[corners[0]] + mesh->normals[corners[1]] + mesh->normals[corners[2]];
            if (glm::dot(normal, wanted) < 0.0f) {
                std::swap(corners[1], corners[2]);
                ++here;
            }
        }
        turned += here;
    });
    return turned;
}

uint64_t addSmoothNormals(std::vector<MeshPart>* parts) {
    std::vector<SmoothFace> faces = facesWithoutNormals(*parts);
    if (faces.empty()) { return 0; }
    PositionNumbers numbers(*parts);
    numberPositions(*parts, &faces, &numbers);
    SmoothingFans fans(faces, numbers.count());
    const std::vector<Vec3> normals = fanNormals(*parts, faces, &fans);
    const auto isBent = [&](size_t f) {
        for (uint32_t c = 0; c < 3; ++c) {
            const Vec3& normal = normals[fans.rootOf(static_cast<uint32_t>(3 * f) + c)];
            if (glm::dot(normal, faces[f].normal) < 1.0f - 1e-6f && !isZero(normal)) { return true; }
        }
        return false;
    };
    uint64_t count = 0;
    for (size_t f = 0; f < faces.size();) {
        size_t end = f;
        const uint64_t before = count;
        for (; end < faces.size() && faces[end].part == faces[f].part; ++end) {
            count += isBent(end) ? 1 : 0;
        }
        // Flat ones, too: they share vertices with those that are not.
        if (count > before) {
            writeNormals(normals, faces, f, end, &fans, (*parts)[faces[f].part].mesh.get());
        }
        f = end;
    }
    return count;
}

void completeNormals(const std::string& path, MeshFile* file, bool isFaceted) {
    uint64_t turned = 0;
    bool hasGroups = false;
    for (const MeshPart& part : file->parts) {
        turned += turnByNormals(part.mesh.get());
        hasGroups =
            hasGroups || (!part.smoothing.empty() && part.smoothing.back().group != Smoothing::ByAngle);
    }
    if (turned > 0) {
        file->warnings.push_back(fmt::format(
            "{}: {} triangles are wound against their normals and turned over: normals decide which side is "
            "the front",
            path, turned));
    }
    if (isFaceted) { return; }
    if (const uint64_t smooth = addSmoothNormals(&file->parts); smooth > 0) {
        file->notes.push_back(
            fmt::format("{}: {} triangles without normals get smooth ones, {}", path, smooth,
                        hasGroups ? "by the file's smoothing groups"
                                  : fmt::format("across edges of up to {} degrees", kCreaseAngleDeg)));
    }
}

}  // namespace glint
