// SPPM against path tracing where both converge: means of whole pictures over independent seeds.
//
// Each check at a significance of 1e-6 (statistics.h) beyond the bias that the radius allows.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/render_scene.h"
#include "tests/support/sppm_render.h"
#include "tests/support/statistics.h"
#include "tests/support/test_scenes.h"

namespace glint::test {
namespace {

constexpr int kSeeds = 6;

SceneDescription small(SceneDescription scene) {
    scene.resolution = {32, 32};
    scene.options.maxDepth = 8;
    return scene;
}

/// A box of diffuse walls with a lamp, and a ball of rough glass in it.
SceneDescription roughGlassBox() {
    SceneDescription scene = small(cornellBox());
    Material glass;
    glass.name = "rough glass";
    glass.kind = MaterialKind::Dielectric;
    glass.color.value = Vec3(1.0f);
    glass.roughness = 0.3f;
    scene.materials.push_back(glass);
    for (Object& object : scene.objects) {
        if (object.shape == ShapeKind::Sphere) {
            object.material = static_cast<int>(scene.materials.size()) - 1;
        }
    }
    return scene;
}

struct Comparison {
    double meanDifference = 0.0;  ///< signed, of the whole picture, relative to the path tracer's mean
    double standardError = 0.0;   ///< of meanDifference, from the seeds
};

/// Whole-picture means over seeds: of SPPM with `passes`, minus those of path tracing.
Comparison compare(const SceneDescription& scene, SppmParams params, uint32_t passes) {
    RunningMean sppm;
    RunningMean paths;
    const int width = scene.resolution.width;
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
        params.pass.seed = seed;
        sppm.add(blockMean(renderSppm(scene, params, passes).picture, width, 0, 0, width));
        paths.add(blockMean(renderPaths(scene, 100 + seed, 64), width, 0, 0, width));
    }
    return {(sppm.mean() - paths.mean()) / paths.mean(),
            std::hypot(sppm.standardError(), paths.standardError()) / paths.mean()};
}

SppmParams quickParams() {
    SppmParams params;
    params.photonsPerPass = 8000;
    params.radiusFootprints = 2.0f;
    return params;
}

/// What the kernel's finite radius may cost: near edges a disc of radius r loses or gains light over a strip
/// of width r. With r of two pixels (shrinking) and edges over less than a quarter of a 32-pixel picture, a
/// few percent of the photons' part.
constexpr double kBiasBound = 0.03;

class SppmAgainstPaths : public testing::TestWithParam<bool> {};

TEST_P(SppmAgainstPaths, CornellBoxAgrees) {
    SppmParams params = quickParams();
    params.sampleDirectLight = GetParam();
    const Comparison result = compare(small(cornellBox()), params, 12);
    EXPECT_LT(std::fabs(result.meanDifference), kNormalQuantile * result.standardError + kBiasBound);
    EXPECT_LT(result.standardError, 0.02) << "too noisy to tell";
}

TEST_P(SppmAgainstPaths, RoughGlassAgrees) {
    SppmParams params = quickParams();
    params.sampleDirectLight = GetParam();
    const Comparison result = compare(roughGlassBox(), params, 12);
    EXPECT_LT(std::fabs(result.meanDifference), kNormalQuantile * result.standardError + kBiasBound);
    EXPECT_LT(result.standardError, 0.02) << "too noisy to tell";
}

TEST_P(SppmAgainstPaths, AllLampShapesAgree) {
    SppmParams params = quickParams();
    params.sampleDirectLight = GetParam();
    const Comparison result = compare(small(lampShapes()), params, 12);
    EXPECT_LT(std::fabs(result.meanDifference), kNormalQuantile * result.standardError + kBiasBound);
}

TEST_P(SppmAgainstPaths, FurnaceAgrees) {
    SppmParams params = quickParams();
    params.sampleDirectLight = GetParam();
    params.photonsPerPass = 40000;
    const Comparison result = compare(small(whiteFurnace()), params, 12);
    EXPECT_LT(std::fabs(result.meanDifference), kNormalQuantile * result.standardError + kBiasBound);
}

INSTANTIATE_TEST_SUITE_P(DirectLight, SppmAgainstPaths, testing::Bool(),
                         [](const auto& mode) { return mode.param ? "Sampled" : "Photons"; });

TEST(Sppm, BiasShrinksWithTheRadius) {
    SppmParams params = quickParams();
    params.sampleDirectLight = false;
    params.radiusFootprints = 8.0f;
    const Comparison wide = compare(small(cornellBox()), params, 8);
    params.radiusFootprints = 1.5f;
    const Comparison narrow = compare(small(cornellBox()), params, 8);
    EXPECT_GT(std::fabs(wide.meanDifference), 2.0 * wide.standardError) << "the wide radius must show a bias";
    EXPECT_LT(std::fabs(narrow.meanDifference) + 2.0 * narrow.standardError, std::fabs(wide.meanDifference));
}

}  // namespace
}  // namespace glint::test
