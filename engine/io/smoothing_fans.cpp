// Edges are sorted by their lesser position with a counting sort, so that each is looked at beside
// its neighbours.
#include "engine/io/smoothing_fans.h"

#include <algorithm>
#include <cmath>

#include "engine/io/mesh_normals.h"

namespace glint {
namespace {

uint32_t next(uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

bool isSmooth(const SmoothFace& a, const SmoothFace& b) {
    static const float kLeastCosine = std::cos(kCreaseAngleDeg * kPi / 180.0f);
    const float cosine = glm::dot(a.normal, b.normal);
    return a.group == b.group &&
           (a.group == Smoothing::ByAngle ? cosine >= kLeastCosine
                                          : a.group != Smoothing::Off && cosine > -0.99f);
}

}  // namespace

SmoothingFans::SmoothingFans(const std::vector<SmoothFace>& faces, uint32_t positionCount)
    : faces_(faces), parent_(3 * faces.size()) {
    for (size_t i = 0; i < parent_.size(); ++i) {
        parent_[i] = static_cast<uint32_t>(i);
    }
    joinAcrossEdges(positionCount);
}

uint32_t SmoothingFans::rootOf(uint32_t corner) {
    while (parent_[corner] != corner) {
        corner = parent_[corner] = parent_[parent_[corner]];
    }
    return corner;
}

void SmoothingFans::joinAcrossEdges(uint32_t positionCount) {
    std::vector<uint32_t> first(size_t{positionCount} + 1, 0);
    const auto corners = static_cast<uint32_t>(parent_.size());
    const auto lesser = [&](uint32_t c) { return std::min(positionOf(c), positionOf(next(c))); };
    for (uint32_t c = 0; c < corners; ++c) {
        ++first[lesser(c) + 1];
    }
    for (size_t i = 1; i < first.size(); ++i) {
        first[i] += first[i - 1];
    }
    std::vector<Edge> edges(corners);
    std::vector<uint32_t> at(first.begin(), first.end() - 1);
    for (uint32_t c = 0; c < corners; ++c) {
        edges[at[lesser(c)]++] = {std::max(positionOf(c), positionOf(next(c))), c};
    }
    for (size_t i = 0; i + 1 < first.size(); ++i) {
        std::sort(edges.begin() + first[i], edges.begin() + first[i + 1], [](const Edge& a, const Edge& b) {
            return a.other != b.other ? a.other < b.other : a.corner < b.corner;
        });
        for (size_t e = first[i]; e < first[i + 1];) {
            size_t end = e + 1;
            while (end < first[i + 1] && edges[end].other == edges[e].other) {
                ++end;
            }
            if (end - e == 2) { joinAcross(edges[e].corner, edges[e + 1].corner); }
            e = end;
        }
    }
}

void SmoothingFans::joinAcross(uint32_t a, uint32_t b) {
    const bool oneWinding = positionOf(a) == positionOf(next(b));
    if (!oneWinding || !isSmooth(faces_[a / 3], faces_[b / 3])) { return; }
    parent_[rootOf(a)] = rootOf(next(b));
    parent_[rootOf(next(a))] = rootOf(b);
}

}  // namespace glint
