// Loop's subdivision.
#include <algorithm>
#include <array>

#include "engine/io/mitsuba_normals.h"
#include "engine/io/pbrt_grid.h"

namespace glint {
namespace {

constexpr size_t kMaxTriangles = 8'000'000;

/// An edge, and what lies across it in its triangles.
struct Edge {
    uint32_t low, high;
    std::array<uint32_t, 2> opposite{};
    int triangles = 1;
};

/// Each edge of the triangles once; edgeOf is that of each triangle's corner and the next one.
struct Edges {
    std::vector<Edge> all;
    std::vector<uint32_t> edgeOf;
};

Edges edgesOf(const std::vector<uint32_t>& indices) {
    struct Side {
        uint64_t key;
        uint32_t corner;
    };
    std::vector<Side> sides;
    sides.reserve(indices.size());
    const auto cornerOf = [&](size_t corner, size_t further) {
        return indices[corner / 3 * 3 + (corner % 3 + further) % 3];
    };
    for (size_t i = 0; i < indices.size(); ++i) {
        const auto [low, high] = std::minmax({indices[i], cornerOf(i, 1)});
        sides.push_back({uint64_t{low} << 32 | high, static_cast<uint32_t>(i)});
    }
    std::ranges::sort(sides, {}, [](const Side& s) { return std::pair(s.key, s.corner); });
    Edges out;
    out.edgeOf.resize(indices.size());
    for (size_t i = 0; i < sides.size(); ++i) {
        const uint32_t opposite = cornerOf(sides[i].corner, 2);
        if (i == 0 || sides[i].key != sides[i - 1].key) {
            out.all.push_back({static_cast<uint32_t>(sides[i].key >> 32),
                               static_cast<uint32_t>(sides[i].key & UINT32_MAX),
                               {opposite, opposite}});
        } else {
            Edge& edge = out.all.back();
            edge.opposite[1] = opposite;
            ++edge.triangles;
        }
        out.edgeOf[sides[i].corner] = static_cast<uint32_t>(out.all.size()) - 1;
    }
    return out;
}

/// The neighbours of a vertex: all, and those along the surface's edge.
struct Ring {
    Vec3 sum{0.0f}, edgeSum{0.0f};
    int count = 0, edgeCount = 0;
};

std::vector<Ring> ringsOf(const Edges& edges, const std::vector<Vec3>& positions) {
    std::vector<Ring> rings(positions.size());
    const auto add = [&](uint32_t vertex, uint32_t neighbour, bool isEdge) {
        Ring& ring = rings[vertex];
        ring.sum += positions[neighbour];
        ++ring.count;
        ring.edgeSum += isEdge ? positions[neighbour] : Vec3(0.0f);
        ring.edgeCount += isEdge ? 1 : 0;
    };
    for (const Edge& edge : edges.all) {
        add(edge.low, edge.high, edge.triangles != 2);
        add(edge.high, edge.low, edge.triangles != 2);
    }
    return rings;
}

float warrenWeight(int neighbours) {
    return neighbours == 3 ? 3.0f / 16.0f : 3.0f / (8.0f * static_cast<float>(neighbours));
}

/// `inside` is the weight of each neighbour of a vertex with as many, `edge` along the surface's edge.
template <class Inside>
void moveVertices(const std::vector<Ring>& rings, const Inside& inside, float edge,
                  std::vector<Vec3>* positions) {
    for (size_t i = 0; i < rings.size(); ++i) {
        const Ring& ring = rings[i];
        Vec3& p = (*positions)[i];
        if (ring.edgeCount == 2) {
            p = (1.0f - 2.0f * edge) * p + edge * ring.edgeSum;
        } else if (ring.edgeCount == 0 && ring.count > 0) {
            const float weight = inside(ring.count);
            p = (1.0f - static_cast<float>(ring.count) * weight) * p + weight * ring.sum;
        }
    }
}

void subdivide(std::vector<Vec3>* positions, std::vector<uint32_t>* indices) {
    const Edges edges = edgesOf(*indices);
    const auto first = static_cast<uint32_t>(positions->size());
    std::vector<Vec3> between;
    between.reserve(edges.all.size());
    for (const Edge& edge : edges.all) {
        const Vec3 ends = (*positions)[edge.low] + (*positions)[edge.high];
        const Vec3 across = (*positions)[edge.opposite[0]] + (*positions)[edge.opposite[1]];
        between.push_back(edge.triangles == 2 ? 0.375f * ends + 0.125f * across : 0.5f * ends);
    }
    moveVertices(ringsOf(edges, *positions), warrenWeight, 0.125f, positions);
    positions->insert(positions->end(), between.begin(), between.end());
    std::vector<uint32_t> finer;
    finer.reserve(4 * indices->size());
    for (size_t t = 0; t < indices->size(); t += 3) {
        const uint32_t a = (*indices)[t], b = (*indices)[t + 1], c = (*indices)[t + 2];
        const uint32_t ab = first + edges.edgeOf[t], bc = first + edges.edgeOf[t + 1],
                       ca = first + edges.edgeOf[t + 2];
        finer.insert(finer.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
    }
    *indices = std::move(finer);
}

}  // namespace

std::shared_ptr<MeshData> loopSubdivided(std::vector<Vec3> positions, std::vector<uint32_t> indices,
                                         int levels) {
    for (int level = 0; level < levels && 4 * indices.size() / 3 <= kMaxTriangles; ++level) {
        subdivide(&positions, &indices);
    }
    const auto limitWeight = [](int neighbours) {
        return 1.0f / (static_cast<float>(neighbours) + 3.0f / (8.0f * warrenWeight(neighbours)));
    };
    moveVertices(ringsOf(edgesOf(indices), positions), limitWeight, 0.2f, &positions);
    auto mesh = std::make_shared<MeshData>();
    mesh->positions = std::move(positions);
    mesh->indices = std::move(indices);
    smoothByVertices(mesh.get());
    return mesh;
}

}  // namespace glint
