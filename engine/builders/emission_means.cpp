#include "engine/builders/emission_means.h"

#include <initializer_list>

#include "engine/kernels/texture.h"

namespace glint {
namespace {

constexpr int kGrid = 64;         // each way, over a whole shape
constexpr int kTriangleGrid = 4;  // small triangles each way, over one triangle

Vec3 emissionOf(const TextureView& texture, const Vec2& uv) {
    return glm::max(sampleTexture(texture, uv), Vec3(0.0f));
}

}  // namespace

EmissionMeans::EmissionMeans(const TextureView& texture) : texture_(texture) {
    for (int y = 0; y < kGrid; ++y) {
        for (int x = 0; x < kGrid; ++x) {
            const Vec2 cell(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            overAll_ +=
                emissionOf(texture, cell / static_cast<float>(kGrid)) / static_cast<float>(kGrid * kGrid);
        }
    }
}

Vec3 EmissionMeans::overTriangle(const Vec2& a, const Vec2& b, const Vec2& c) const {
    Vec3 sum(0.0f);
    // The centres of the upright and of the overturned small triangles.
    for (const float shift : {1.0f / 3.0f, 2.0f / 3.0f}) {
        for (int i = 0; i < kTriangleGrid; ++i) {
            for (int j = 0; i + j < kTriangleGrid - (shift > 0.5f ? 1 : 0); ++j) {
                const Vec2 weight = Vec2(static_cast<float>(i) + shift, static_cast<float>(j) + shift) /
                                    static_cast<float>(kTriangleGrid);
                sum += emissionOf(texture_, a + weight.x * (b - a) + weight.y * (c - a));
            }
        }
    }
    return glm::max(sum / static_cast<float>(kTriangleGrid * kTriangleGrid), 0.05f * overAll_);
}

}  // namespace glint
