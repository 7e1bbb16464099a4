// The camera rays of a tile in vector code are, bit for bit, those of the pixels one by one: for every
// filter and lens, also where a tile reaches over the picture's edge. And the logarithm that both draw their
// filter by.
#include <cmath>
#include <cstring>
#include <set>

#include <gtest/gtest.h>

#include "engine/math/log.h"
#include "engine/render/cpu_camera_rays.h"

namespace glint {
namespace {

constexpr FeatureMask kMask = kFeatureCameraArea;
constexpr int kWidth = 29;
constexpr int kHeight = 19;

CameraData cameraWith(float lensRadius, int blades) {
    CameraData camera;
    camera.position = {1.0f, -2.0f, 3.5f};
    camera.frame = Frame::fromNormal(glm::normalize(Vec3(0.3f, 0.2f, 0.9f)));
    camera.halfWidth = 0.6f;
    camera.halfHeight = 0.4f;
    camera.lensRadius = lensRadius;
    camera.focalDistance = 4.0f;
    camera.blades = blades;
    camera.bladeRotationRad = 0.3f;
    return camera;
}

PassParams paramsWith(FilterKind filter) {
    PassParams params;
    params.width = kWidth;
    params.height = kHeight;
    params.pass = 5;
    params.seed = 77;
    params.filter = filter;
    return params;
}

bool same(const Vec3& a, const Vec3& b) { return std::memcmp(&a, &b, sizeof(Vec3)) == 0; }

void expectTilesLikePixels(const CameraData& camera, const PassParams& params) {
    const PixelRect rect{3, 2, kWidth, kHeight};
    std::set<std::pair<int, int>> seen;
    forEachCameraRay(camera, params, rect, [&](int x, int y, const Sampler& sampler, const Ray& ray) {
        seen.insert({x, y});
        const Sampler own = makeSampler(params, x, y);
        const Ray expected = pixelRay<kMask>(camera, params, own, x, y);
        EXPECT_EQ(sampler.pixelKey, own.pixelKey);
        EXPECT_EQ(sampler.pass, own.pass);
        EXPECT_EQ(sampler.reversedPass, own.reversedPass);
        EXPECT_TRUE(same(ray.origin, expected.origin)) << x << " " << y;
        EXPECT_TRUE(same(ray.direction, expected.direction)) << x << " " << y;
        EXPECT_EQ(ray.tMin, expected.tMin);
        EXPECT_EQ(ray.tMax, expected.tMax);
    });
    EXPECT_EQ(seen.size(), static_cast<size_t>((rect.x1 - rect.x0) * (rect.y1 - rect.y0)));
    EXPECT_EQ(*seen.begin(), (std::pair{rect.x0, rect.y0}));
    EXPECT_EQ(*seen.rbegin(), (std::pair{rect.x1 - 1, rect.y1 - 1}));
}

TEST(CameraRays, TilesAreLikePixels) {
    for (const FilterKind filter : {FilterKind::Box, FilterKind::Gaussian, FilterKind::BlackmanHarris}) {
        for (CameraData camera : {cameraWith(0.0f, 0), cameraWith(0.2f, 0), cameraWith(0.2f, 6)}) {
            expectTilesLikePixels(camera, paramsWith(filter));
            camera.middle = {0.31f, -0.17f};
            expectTilesLikePixels(camera, paramsWith(filter));
            camera.isOrthographic = true;
            expectTilesLikePixels(camera, paramsWith(filter));
        }
    }
}

/// What naturalLog() promises, all over the positive floats and next to 1, where the result is small.
TEST(NaturalLog, IsAccurate) {
    const auto expectAccurate = [](float x) {
        const double exact = std::log(static_cast<double>(x));
        const double unit = std::max(std::fabs(exact), 0.1) * 0x1p-23;
        EXPECT_NEAR(static_cast<double>(naturalLog(x)), exact, 2.0 * unit) << x;
    };
    for (float x = 1.2e-38f; x < 3e38f; x *= 1.0037f) {
        expectAccurate(x);
    }
    for (float x = 0.5f; x < 2.0f; x += 1e-4f) {
        expectAccurate(x);
    }
    EXPECT_EQ(naturalLog(1.0f), 0.0f);
}

}  // namespace
}  // namespace glint
