#include "engine/scene/generated_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "engine/base/nearest_name.h"
#include "engine/scene/mesh_grid.h"

namespace glint {
namespace {

constexpr uint32_t kMinTriangles = 12;
constexpr uint32_t kMaxTriangles = 100'000'000;

/// Smooth noise in [-1, 1]: a few plane waves whose directions and phases come from the seed.
class Waves {
  public:
    explicit Waves(uint32_t seed) {
        uint64_t state = 0x9e3779b97f4a7c15ull * (uint64_t{seed} + 1);
        const auto next = [&state] {  // splitmix64 (Steele, Lea and Flood 2014)
            state += 0x9e3779b97f4a7c15ull;
            uint64_t z = state;
            z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
            z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
            return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
        };
        for (Wave& wave : waves_) {
            const double z = 2.0 * next() - 1.0;
            const double angle = 2.0 * kPiD * next();
            const double r = std::sqrt(1.0 - z * z);
            wave = {{r * std::cos(angle), z, r * std::sin(angle)}, 2.0 * kPiD * next()};
        }
    }

    /// `octaves` times doubles the frequency and halves the height.
    double at(const Vec3d& p, double frequency, int octaves) const {
        double sum = 0.0;
        double total = 0.0;
        double height = 1.0;
        for (int octave = 0; octave < octaves; ++octave) {
            for (size_t i = 0; i < kPerOctave; ++i) {
                const Wave& wave = waves_[(static_cast<size_t>(octave) * kPerOctave + i) % waves_.size()];
                sum += height * std::sin(frequency * glm::dot(wave.direction, p) + wave.phase);
                total += height;
            }
            frequency *= 2.0;
            height *= 0.5;
        }
        return sum / total;
    }

  private:
    struct Wave {
        Vec3d direction;
        double phase;
    };
    static constexpr size_t kPerOctave = 4;
    std::array<Wave, 32> waves_;
};

uint32_t atLeast(uint32_t least, double x) { return std::max(least, static_cast<uint32_t>(std::lround(x))); }

/// Unit direction of u (around +y, from -z over -x) and v (from the south pole up): the uvs of the
/// analytic sphere.
Vec3d sphereDirection(double u, double v) {
    const double longitude = 2.0 * kPiD * (u - 0.5);
    const double latitude = kPiD * (v - 0.5);
    const bool pole = v == 0.0 || v == 1.0;
    const double r = pole ? 0.0 : std::cos(latitude);
    return {r * std::sin(longitude), pole ? std::copysign(1.0, v - 0.5) : std::sin(latitude),
            r * std::cos(longitude)};
}

MeshGrid sphereGrid(uint32_t triangles) {
    const uint32_t rows = atLeast(3, 0.5 + std::sqrt(0.25 * triangles + 0.25));
    return {atLeast(3, triangles / (2.0 * (rows - 1))), rows, true, false, true};
}

MeshData makeSphere(const MeshGenerator& generator) {
    return bendGrid(sphereGrid(generator.triangles), sphereDirection);
}

/// A closed, smoothly dented body around the origin, which it surrounds: radius 0.6 to 1.4.
MeshData makeBlob(const MeshGenerator& generator) {
    const Waves waves(generator.seed);
    return bendGrid(sphereGrid(generator.triangles), [&](double u, double v) {
        const Vec3d direction = sphereDirection(u, v);
        return direction * (1.0 + 0.4 * waves.at(direction, 4.0, 4));
    });
}

/// A height field over x and z in [-1, 1], facing +y. Open.
MeshData makeTerrain(const MeshGenerator& generator) {
    const Waves waves(generator.seed);
    const uint32_t cells = atLeast(3, std::sqrt(generator.triangles / 2.0));
    const MeshGrid grid{cells, atLeast(2, generator.triangles / (2.0 * cells)), false, false, false};
    return bendGrid(grid, [&](double u, double v) {
        const Vec3d ground(2.0 * u - 1.0, 0.0, 1.0 - 2.0 * v);
        const double ridge = waves.at(ground, 5.0, 6);
        return ground + Vec3d(0.0, 0.25 * ridge, 0.0);
    });
}

/// A tube along a (2, 3) torus knot, about 2 across. Closed.
MeshData makeTorusKnot(const MeshGenerator& generator) {
    constexpr double kTubeRadius = 0.13;
    const auto knot = [](double t) {
        const double r = 0.62 + 0.25 * std::cos(3.0 * t);
        return Vec3d(r * std::cos(2.0 * t), 0.25 * std::sin(3.0 * t), r * std::sin(2.0 * t));
    };
    const uint32_t rows = atLeast(3, std::sqrt(generator.triangles / 2.0 / 12.0));
    const MeshGrid grid{atLeast(12, generator.triangles / (2.0 * rows)), rows, true, true, false};
    return bendGrid(grid, [&](double u, double v) {
        const double t = 2.0 * kPiD * u;
        const Vec3d tangent = glm::normalize(knot(t + 1e-4) - knot(t - 1e-4));
        // Away from the torus's circle: never parallel to the tangent, and closed after one round.
        const Vec3d ring = Vec3d(std::cos(2.0 * t), 0.0, std::sin(2.0 * t)) * 0.62;
        const Vec3d outward = knot(t) - ring;
        const Vec3d side = glm::normalize(outward - tangent * glm::dot(outward, tangent));
        const Vec3d other = glm::cross(tangent, side);
        const double angle = 2.0 * kPiD * v;
        return knot(t) + kTubeRadius * (std::cos(angle) * side - std::sin(angle) * other);
    });
}

/// A still pond over x and z in [-1, 1], facing +y: gentle waves, 0.1 high at the most. Open.
MeshData makeWater(const MeshGenerator& generator) {
    const Waves waves(generator.seed);
    const uint32_t cells = atLeast(3, std::sqrt(generator.triangles / 2.0));
    const MeshGrid grid{cells, atLeast(2, generator.triangles / (2.0 * cells)), false, false, false};
    return bendGrid(grid, [&](double u, double v) {
        const Vec3d ground(2.0 * u - 1.0, 0.0, 1.0 - 2.0 * v);
        return ground + Vec3d(0.0, 0.1 * waves.at(ground, 9.0, 2), 0.0);
    });
}

/// A band around the y axis: upright walls, outer radius 1, 0.08 thick and 0.5 high, with rounded
/// rims. Closed.
MeshData makeRing(const MeshGenerator& generator) {
    constexpr double kRim = 0.04;
    constexpr double kHalfWall = 0.21;
    const uint32_t rows = 4 * atLeast(1, std::sqrt(generator.triangles / 16.0) / 4.0);
    const MeshGrid grid{atLeast(3, generator.triangles / (2.0 * rows)), rows, true, true, false};
    return bendGrid(grid, [&](double u, double v) {
        const double part = 4.0 * v;  // outer wall up, upper rim, inner wall down, lower rim
        const double angle =
            kPiD * (part < 2.0 ? std::clamp(part - 1.0, 0.0, 1.0) : 1.0 + std::clamp(part - 3.0, 0.0, 1.0));
        const double wall = part < 2.0 ? std::min(part, 1.0) : 1.0 - std::min(part - 2.0, 1.0);
        const double radius = 1.0 - kRim + kRim * std::cos(angle);
        const double y = kHalfWall * (2.0 * wall - 1.0) + kRim * std::sin(angle);
        const double longitude = 2.0 * kPiD * u;
        return Vec3d(radius * std::sin(longitude), y, radius * std::cos(longitude));
    });
}

/// The cube [-1, 1]^3 with flat normals; every side has the whole texture. Closed.
MeshData makeCube(const MeshGenerator& generator) {
    const uint32_t cells = atLeast(1, std::sqrt(generator.triangles / 12.0));
    const MeshGrid grid{cells, cells, false, false, false};
    MeshData mesh;
    for (int side = 0; side < 6; ++side) {
        const int axis = side / 2;
        Vec3 normal(0.0f);
        normal[axis] = side % 2 ? -1.0f : 1.0f;
        const uint32_t first = static_cast<uint32_t>(mesh.positions.size());
        for (uint32_t row = 0; row <= cells; ++row) {
            for (uint32_t column = 0; column <= cells; ++column) {
                const Vec2 uv(static_cast<float>(column) / static_cast<float>(cells),
                              static_cast<float>(row) / static_cast<float>(cells));
                // Coordinates of integers, the same from all sides; the first one runs backwards on
                // negative sides.
                const uint32_t s = side % 2 ? cells - column : column;
                Vec3 p = normal;
                p[(axis + 1) % 3] = static_cast<float>(2.0 * s / cells - 1.0);
                p[(axis + 2) % 3] = static_cast<float>(2.0 * row / cells - 1.0);
                mesh.positions.push_back(p);
                mesh.normals.push_back(normal);
                mesh.uvs.push_back(uv);
            }
        }
        addGridTriangles(grid, first, &mesh);
    }
    return mesh;
}

struct MeshMaker {
    std::string_view name;
    MeshData (*make)(const MeshGenerator&);
};
constexpr std::array<MeshMaker, 7> kMakers = {{{"blob", makeBlob},
                                               {"cube", makeCube},
                                               {"ring", makeRing},
                                               {"sphere", makeSphere},
                                               {"terrain", makeTerrain},
                                               {"torus-knot", makeTorusKnot},
                                               {"water", makeWater}}};

const MeshMaker* findMaker(std::string_view name) {
    const auto* found =
        std::find_if(kMakers.begin(), kMakers.end(), [name](const MeshMaker& g) { return g.name == name; });
    return found == kMakers.end() ? nullptr : found;
}

}  // namespace

Status checkMeshGenerator(const MeshGenerator& generator) {
    if (findMaker(generator.name) == nullptr) {
        return Error{fmt::format("unknown mesh generator \"{}\"{}", generator.name,
                                 didYouMean(generator.name, meshGeneratorNames())),
                     {}};
    }
    if (generator.triangles < kMinTriangles || generator.triangles > kMaxTriangles) {
        return Error{fmt::format("{} triangles for the mesh generator \"{}\"; expected {} to {}",
                                 generator.triangles, generator.name, kMinTriangles, kMaxTriangles),
                     {}};
    }
    return {};
}

Result<std::shared_ptr<MeshData>> generateMesh(const MeshGenerator& generator) {
    if (Status known = checkMeshGenerator(generator); !known) { return known.error(); }
    return std::make_shared<MeshData>(findMaker(generator.name)->make(generator));
}

std::vector<std::string_view> meshGeneratorNames() {
    std::vector<std::string_view> names;
    names.reserve(std::size(kMakers));
    for (const MeshMaker& maker : kMakers) {
        names.push_back(maker.name);
    }
    return names;
}

}  // namespace glint
