// 10^8 rays inside closed meshes: none may leave.
#include <atomic>

#include <gtest/gtest.h>

#include "engine/base/parallel.h"
#include "tests/support/geometry_scene.h"

namespace glint {
namespace {

using namespace testing_support;

TEST(WatertightLong, AHundredMillionRaysFindNoWayOut) {
    for (const char* name : {"blob", "cube", "sphere", "blob"}) {
        const uint32_t triangles = name[0] == 'c' ? 1200 : 200'000;
        const GeometryScene scene =
            makeScene({makeObject(ShapeKind::Mesh, {}, 0)}, {generated(name, triangles, 5)});
        std::atomic<int64_t> leaks{0};
        parallelChunks(25'000'000, 100'000, 0, [&](int64_t begin, int64_t end) {
            Random random(static_cast<uint32_t>(begin / 100'000) + 77u);
            int64_t missed = 0;
            for (int64_t i = begin; i < end; ++i) {
                const Ray ray{random.box(0.3f), random.direction()};
                missed += occluded<kFeatureMesh>(scene.view, ray) ? 0 : 1;
            }
            leaks += missed;
        });
        EXPECT_EQ(leaks.load(), 0) << name;
    }
}

}  // namespace
}  // namespace glint
