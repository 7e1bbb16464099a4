// The mesh and the image of the scenes made in code.
#include "tests/support/test_scenes.h"

namespace glint::test {

std::shared_ptr<const MeshData> bumpySphere(int rings, int segments, bool withColors) {
    auto mesh = std::make_shared<MeshData>();
    for (int ring = 0; ring <= rings; ++ring) {
        for (int segment = 0; segment <= segments; ++segment) {
            const Vec2 uv(static_cast<float>(segment) / static_cast<float>(segments),
                          static_cast<float>(ring) / static_cast<float>(rings));
            const float polar = kPi * uv.y;
            const float azimuth = kTwoPi * uv.x;
            const Vec3 n(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                         std::sin(polar) * std::sin(azimuth));
            mesh->positions.push_back(n * (1.0f + 0.05f * std::sin(7.0f * polar) * std::cos(5.0f * azimuth)));
            mesh->normals.push_back(n);
            mesh->uvs.push_back(uv);
            if (withColors) { mesh->colors.push_back(0.5f + 0.5f * n); }
        }
    }
    const auto vertex = [&](int ring, int segment) {
        return static_cast<uint32_t>(ring * (segments + 1) + segment);
    };
    for (int r = 0; r < rings; ++r) {
        for (int s = 0; s < segments; ++s) {
            mesh->indices.insert(mesh->indices.end(), {vertex(r, s), vertex(r, s + 1), vertex(r + 1, s)});
            mesh->indices.insert(mesh->indices.end(),
                                 {vertex(r + 1, s), vertex(r, s + 1), vertex(r + 1, s + 1)});
        }
    }
    return mesh;
}

SceneImage checkerImage(int width, int height, bool floats) {
    auto bytes = std::make_shared<Image8>();
    auto linear = std::make_shared<ImageF>();
    bytes->width = linear->width = width;
    bytes->height = linear->height = height;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int value = (x + y) % 2 == 0 ? 40 : 200;
            for (int channel = 0; channel < 3; ++channel) {
                const int texel = value + 5 * channel + (3 * x + 7 * y) % 40;
                bytes->rgb.push_back(static_cast<uint8_t>(texel));
                linear->rgb.push_back(static_cast<float>(texel) / 128.0f);
            }
        }
    }
    SceneImage source;
    if (floats) {
        source.floats = linear;
    } else {
        source.bytes = bytes;
    }
    return source;
}

}  // namespace glint::test
