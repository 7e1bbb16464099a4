// Grids bent into shapes. Closed ones are watertight: vertices where a grid meets itself are exact copies,
// kept apart only for their texture coordinates.
#include "engine/scene/generated_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "engine/base/nearest_name.h"

namespace glint {
namespace {

using Vec3d = glm::dvec3;

constexpr uint32_t kMinTriangles = 12;
constexpr uint32_t kMaxTriangles = 100'000'000;
constexpr double kPiD = 3.14159265358979323846;

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

/// A grid of `columns` x `rows` cells. Wrapped sides and the ends of a sphere meet themselves.
struct Grid {
    uint32_t columns;
    uint32_t rows;
    bool wrapColumns;
    bool wrapRows;
    bool poles;  ///< the first and the last row shrink to a point each

    uint32_t stride() const { return columns + 1; }
    uint32_t vertex(uint32_t column, uint32_t row) const { return row * stride() + column; }
    /// The vertex whose position this one shares.
    uint32_t original(uint32_t column, uint32_t row) const {
        if (poles && (row == 0 || row == rows)) { return vertex(0, row); }
        return vertex(wrapColumns ? column % columns : column, wrapRows ? row % rows : row);
    }
};

void addGridTriangles(const Grid& grid, uint32_t firstVertex, MeshData* mesh) {
    for (uint32_t row = 0; row < grid.rows; ++row) {
        for (uint32_t column = 0; column < grid.columns; ++column) {
            const uint32_t a = firstVertex + grid.vertex(column, row);
            const uint32_t b = a + 1;
            const uint32_t c = a + grid.stride();
            const uint32_t d = c + 1;
            const bool atStart = grid.poles && row == 0;
            const bool atEnd = grid.poles && row + 1 == grid.rows;
            if (!atStart) { mesh->indices.insert(mesh->indices.end(), {a, b, d}); }
            if (!atEnd) { mesh->indices.insert(mesh->indices.end(), {a, d, c}); }
        }
    }
}

/// Normals of all faces around each position, weighted by area; seams get one normal.
void addGridNormals(const Grid& grid, MeshData* mesh) {
    std::vector<uint32_t> original(mesh->positions.size());
    for (uint32_t row = 0; row <= grid.rows; ++row) {
        for (uint32_t column = 0; column <= grid.columns; ++column) {
            original[grid.vertex(column, row)] = grid.original(column, row);
        }
    }
    std::vector<Vec3d> sums(mesh->positions.size(), Vec3d(0.0));
    for (size_t i = 0; i < mesh->indices.size(); i += 3) {
        const uint32_t* corner = &mesh->indices[i];
        const Vec3d p0 = mesh->positions[corner[0]];
        const Vec3d n =
            glm::cross(Vec3d(mesh->positions[corner[1]]) - p0, Vec3d(mesh->positions[corner[2]]) - p0);
        for (int k = 0; k < 3; ++k) {
            sums[original[corner[k]]] += n;
        }
    }
    mesh->normals.resize(mesh->positions.size());
    for (size_t v = 0; v < sums.size(); ++v) {
        const Vec3d& n = sums[original[v]];
        const double length = glm::length(n);
        mesh->normals[v] = length > 0.0 ? Vec3(n / length) : Vec3(0.0f);
    }
}

/// Bends a grid: `position(u, v)` with u and v in [0, 1], evaluated once for each place.
template <class Position>
MeshData bendGrid(const Grid& grid, const Position& position) {
    MeshData mesh;
    const size_t vertices = static_cast<size_t>(grid.stride()) * (grid.rows + 1);
    mesh.positions.resize(vertices);
    mesh.uvs.resize(vertices);
    for (uint32_t row = 0; row <= grid.rows; ++row) {
        for (uint32_t column = 0; column <= grid.columns; ++column) {
            const uint32_t vertex = grid.vertex(column, row);
            const double u = static_cast<double>(column) / grid.columns;
            const double v = static_cast<double>(row) / grid.rows;
            mesh.uvs[vertex] = Vec2(u, v);
            if (grid.original(column, row) == vertex) { mesh.positions[vertex] = Vec3(position(u, v)); }
        }
    }
    for (uint32_t row = 0; row <= grid.rows; ++row) {
        for (uint32_t column = 0; column <= grid.columns; ++column) {
            mesh.positions[grid.vertex(column, row)] = mesh.positions[grid.original(column, row)];
        }
    }
    addGridTriangles(grid, 0, &mesh);
    addGridNormals(grid, &mesh);
    return mesh;
}

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

Grid sphereGrid(uint32_t triangles) {
    const uint32_t rows = atLeast(3, 0.5 + std::sqrt(0.25 * triangles + 0.25));
    return {atLeast(3, triangles / (2.0 * (rows - 1))), rows, true, false, true};
}

MeshData makeSphere(const MeshSource& source) {
    return bendGrid(sphereGrid(source.triangles), sphereDirection);
}

/// A closed, smoothly dented body around the origin, which it surrounds: radius 0.6 to 1.4.
MeshData makeBlob(const MeshSource& source) {
    const Waves waves(source.seed);
    return bendGrid(sphereGrid(source.triangles), [&](double u, double v) {
        const Vec3d direction = sphereDirection(u, v);
        return direction * (1.0 + 0.4 * waves.at(direction, 4.0, 4));
    });
}

/// A height field over x and z in [-1, 1], facing +y. Open.
MeshData makeTerrain(const MeshSource& source) {
    const Waves waves(source.seed);
    const uint32_t cells = atLeast(3, std::sqrt(source.triangles / 2.0));
    const Grid grid{cells, atLeast(2, source.triangles / (2.0 * cells)), false, false, false};
    return bendGrid(grid, [&](double u, double v) {
        const Vec3d ground(2.0 * u - 1.0, 0.0, 1.0 - 2.0 * v);
        const double ridge = waves.at(ground, 5.0, 6);
        return ground + Vec3d(0.0, 0.25 * ridge, 0.0);
    });
}

/// A tube along a (2, 3) torus knot, about 2 across. Closed.
MeshData makeTorusKnot(const MeshSource& source) {
    constexpr double kTubeRadius = 0.13;
    const auto knot = [](double t) {
        const double r = 0.62 + 0.25 * std::cos(3.0 * t);
        return Vec3d(r * std::cos(2.0 * t), 0.25 * std::sin(3.0 * t), r * std::sin(2.0 * t));
    };
    const uint32_t rows = atLeast(3, std::sqrt(source.triangles / 2.0 / 12.0));
    const Grid grid{atLeast(12, source.triangles / (2.0 * rows)), rows, true, true, false};
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
MeshData makeWater(const MeshSource& source) {
    const Waves waves(source.seed);
    const uint32_t cells = atLeast(3, std::sqrt(source.triangles / 2.0));
    const Grid grid{cells, atLeast(2, source.triangles / (2.0 * cells)), false, false, false};
    return bendGrid(grid, [&](double u, double v) {
        const Vec3d ground(2.0 * u - 1.0, 0.0, 1.0 - 2.0 * v);
        return ground + Vec3d(0.0, 0.1 * waves.at(ground, 9.0, 2), 0.0);
    });
}

/// A band around the y axis: upright walls, outer radius 1, 0.08 thick and 0.5 high, with rounded
/// rims. Closed.
MeshData makeRing(const MeshSource& source) {
    constexpr double kRim = 0.04;
    constexpr double kHalfWall = 0.21;
    const uint32_t rows = 4 * atLeast(1, std::sqrt(source.triangles / 16.0) / 4.0);
    const Grid grid{atLeast(3, source.triangles / (2.0 * rows)), rows, true, true, false};
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
MeshData makeCube(const MeshSource& source) {
    const uint32_t cells = atLeast(1, std::sqrt(source.triangles / 12.0));
    const Grid grid{cells, cells, false, false, false};
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

struct Generator {
    std::string_view name;
    MeshData (*make)(const MeshSource&);
};
constexpr std::array<Generator, 7> kGenerators = {{{"blob", makeBlob},
                                                   {"cube", makeCube},
                                                   {"ring", makeRing},
                                                   {"sphere", makeSphere},
                                                   {"terrain", makeTerrain},
                                                   {"torus-knot", makeTorusKnot},
                                                   {"water", makeWater}}};

const Generator* findGenerator(std::string_view name) {
    const auto* found = std::find_if(kGenerators.begin(), kGenerators.end(),
                                     [name](const Generator& g) { return g.name == name; });
    return found == kGenerators.end() ? nullptr : found;
}

}  // namespace

Status checkMeshGenerator(const MeshSource& source) {
    if (findGenerator(source.generator) == nullptr) {
        return Error{fmt::format("unknown mesh generator \"{}\"{}", source.generator,
                                 didYouMean(source.generator, meshGeneratorNames())),
                     {}};
    }
    if (source.triangles < kMinTriangles || source.triangles > kMaxTriangles) {
        return Error{fmt::format("{} triangles for the mesh generator \"{}\"; expected {} to {}",
                                 source.triangles, source.generator, kMinTriangles, kMaxTriangles),
                     {}};
    }
    return {};
}

Result<std::shared_ptr<MeshData>> generateMesh(const MeshSource& source) {
    if (Status known = checkMeshGenerator(source); !known) { return known.error(); }
    return std::make_shared<MeshData>(findGenerator(source.generator)->make(source));
}

std::vector<std::string_view> meshGeneratorNames() {
    std::vector<std::string_view> names;
    names.reserve(std::size(kGenerators));
    for (const Generator& generator : kGenerators) {
        names.push_back(generator.name);
    }
    return names;
}

}  // namespace glint
