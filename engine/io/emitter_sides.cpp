#include "engine/io/emitter_sides.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace glint {
namespace {

constexpr size_t kMostParts = 64;
constexpr size_t kMostProbes = 64;
/// Of the root of the lamp's area: how near a wall behind it stands.
constexpr double kReach = 0.25;

enum class Side { Both, Front, Back };

glm::dvec3 corner(const MeshData& mesh, size_t index) { return {mesh.positions[mesh.indices[index]]}; }

/// From a lamp's triangle to both sides of it.
struct Probe {
    glm::dvec3 origin;
    glm::dvec3 reach;  ///< along the normal
    bool front = false;
    bool back = false;
};

/// Distance along `way`, of which it is 1 at the end, in both directions; infinite: not met.
double meet(const glm::dvec3& origin, const glm::dvec3& way, const MeshData& mesh, size_t index) {
    const glm::dvec3 a = corner(mesh, index);
    const glm::dvec3 e1 = corner(mesh, index + 1) - a;
    const glm::dvec3 e2 = corner(mesh, index + 2) - a;
    const glm::dvec3 p = glm::cross(way, e2);
    const double determinant = glm::dot(e1, p);
    const glm::dvec3 s = origin - a;
    const glm::dvec3 q = glm::cross(s, e1);
    const double u = glm::dot(s, p) / determinant;
    const double v = glm::dot(way, q) / determinant;
    const bool isInside = u >= 0.0 && v >= 0.0 && u + v <= 1.0;  // false on NaN
    return isInside ? glm::dot(e2, q) / determinant : HUGE_VAL;
}

/// A closed body's volume, positive where its faces look outwards; 0 where an edge has not two faces, and of
/// what is flat.
double volumeIfClosed(const MeshData& mesh) {
    std::vector<std::array<float, 6>> edges;
    double volume = 0.0;
    double area = 0.0;
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        for (size_t e = 0; e < 3; ++e) {
            const Vec3& a = mesh.positions[mesh.indices[i + e]];
            const Vec3& b = mesh.positions[mesh.indices[i + (e + 1) % 3]];
            edges.push_back({a.x, a.y, a.z, b.x, b.y, b.z});
        }
        const glm::dvec3 a = corner(mesh, i) - corner(mesh, 0);
        const glm::dvec3 b = corner(mesh, i + 1) - corner(mesh, 0), c = corner(mesh, i + 2) - corner(mesh, 0);
        volume += glm::dot(a, glm::cross(b, c)) / 6.0;
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    if (std::fabs(volume) < 1e-6 * std::pow(area, 1.5)) { return 0.0; }
    std::ranges::sort(edges);
    for (const auto& e : edges) {
        if (!std::ranges::binary_search(edges, std::array{e[3], e[4], e[5], e[0], e[1], e[2]})) {
            return 0.0;
        }
    }
    return volume;
}

std::vector<Probe> probesOf(const MeshData& mesh) {
    std::vector<Probe> probes;
    double area = 0.0;
    const size_t count = mesh.indices.size() / 3;
    const size_t step = (count + kMostProbes - 1) / kMostProbes;
    for (size_t t = 0; t < count; ++t) {
        const glm::dvec3 a = corner(mesh, 3 * t), b = corner(mesh, 3 * t + 1), c = corner(mesh, 3 * t + 2);
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const double length = glm::length(normal);
        area += 0.5 * length;
        if (t % step == 0 && length > 0.0) { probes.push_back({(a + b + c) / 3.0, normal / length}); }
    }
    for (Probe& probe : probes) {
        probe.reach *= kReach * std::sqrt(area);
    }
    return probes;
}

void look(const MeshFile& file, const MeshPart& emitter, std::vector<Probe>* probes) {
    glm::dvec3 lo(HUGE_VAL), hi(-HUGE_VAL);
    for (const Probe& probe : *probes) {
        lo = glm::min(lo, probe.origin - glm::abs(probe.reach));
        hi = glm::max(hi, probe.origin + glm::abs(probe.reach));
    }
    for (const MeshPart& part : file.parts) {
        if (part.mesh == emitter.mesh) { continue; }
        const MeshData& mesh = *part.mesh;
        for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const glm::dvec3 a = corner(mesh, i), b = corner(mesh, i + 1), c = corner(mesh, i + 2);
            if (glm::any(glm::lessThan(glm::max(a, glm::max(b, c)), lo)) ||
                glm::any(glm::greaterThan(glm::min(a, glm::min(b, c)), hi))) {
                continue;
            }
            for (Probe& probe : *probes) {
                const double distance = meet(probe.origin, probe.reach, mesh, i);
                probe.front = probe.front || (distance >= 0.0 && distance <= 1.0);
                probe.back = probe.back || (distance <= 0.0 && distance >= -1.0);
            }
        }
    }
}

Side sideOf(const MeshFile& file, const MeshPart& emitter) {
    if (const double volume = volumeIfClosed(*emitter.mesh); volume != 0.0) {
        return volume > 0.0 ? Side::Front : Side::Back;
    }
    std::vector<Probe> probes = probesOf(*emitter.mesh);
    look(file, emitter, &probes);
    const auto all = [&](bool front, bool back) {
        return !probes.empty() && std::ranges::all_of(probes, [&](const Probe& probe) {
            return probe.front == front && probe.back == back;
        });
    };
    return all(false, true) ? Side::Front : all(true, false) ? Side::Back : Side::Both;
}

void turnOver(MeshData* mesh) {
    for (size_t i = 0; i + 2 < mesh->indices.size(); i += 3) {
        std::swap(mesh->indices[i + 1], mesh->indices[i + 2]);
    }
    for (Vec3& normal : mesh->normals) {
        normal = -normal;
    }
}

}  // namespace

void chooseEmitterSides(const std::string& path, MeshFile* file) {
    std::vector<std::vector<MeshPart*>> emitters(file->materials.size());
    size_t count = 0;
    for (MeshPart& part : file->parts) {
        const auto material = static_cast<size_t>(part.material);
        if (file->materials[material].emissive() && ++count <= kMostParts) {
            emitters[material].push_back(&part);
        }
    }
    if (count > kMostParts) { return; }
    std::string names;
    for (size_t m = 0; m < emitters.size(); ++m) {
        std::vector<MeshPart*> oneSided;
        for (MeshPart* emitter : emitters[m]) {
            const Side side = sideOf(*file, *emitter);
            if (side == Side::Back) { turnOver(emitter->mesh.get()); }
            if (side != Side::Both) { oneSided.push_back(emitter); }
        }
        if (oneSided.empty()) { continue; }
        names += (names.empty() ? "" : ", ") + file->materials[m].name;
        Material outer = file->materials[m];
        outer.emitsBothSides = false;
        if (oneSided.size() == emitters[m].size()) {
            file->materials[m] = std::move(outer);
            continue;
        }
        // Other lamps of the material stand free.
        outer.name += " (outer side)";
        for (MeshPart* emitter : oneSided) {
            emitter->material = static_cast<int>(file->materials.size());
        }
        file->materials.push_back(std::move(outer));
    }
    if (!names.empty()) {
        file->notes.push_back(fmt::format(
            "{}: these lamps are closed or close to a wall, and shine on their outer side alone: {}", path,
            names.substr(0, 400)));
    }
}

}  // namespace glint
