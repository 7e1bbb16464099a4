// SPPM against path tracing where both converge: block by block, over independent seeds, whichever side of
// walls is their front.
//
// The signed difference of each of 16 blocks must lie within its confidence interval and the bias that the
// radius allows. Family-wise level 1e-3 for each scene and mode: Student's t with at least 11 degrees of
// freedom, two-sided at 1e-3 / 17 (Bonferroni: 16 blocks and the whole picture).
#include <array>
#include <cmath>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/support/render_scene.h"
#include "tests/support/sppm_render.h"
#include "tests/support/sppm_scenes.h"
#include "tests/support/statistics.h"
#include "tests/support/test_scenes.h"

namespace glint::test {
namespace {

constexpr int kSeeds = 12;
constexpr double kStudentQuantile = 6.3;  // t(11) at 2.9e-5 above
constexpr int kBlocks = 4;                // an axis
constexpr int kBlockPixels = 8;

SppmParams paramsFor(bool sampleDirectLight) {
    SppmParams params;
    params.photonsPerPass = 8000;
    params.radiusFootprints = 2.0f;
    params.sampleDirectLight = sampleDirectLight;
    return params;
}

struct Block {
    RunningMean sppm, paths;
    double difference() const { return sppm.mean() - paths.mean(); }
    double error() const { return std::hypot(sppm.standardError(), paths.standardError()); }
};
/// The last one is the whole picture.
using Blocks = std::array<Block, kBlocks * kBlocks + 1>;
constexpr size_t kWhole = kBlocks * kBlocks;

template <class Add>
void addBlocks(const std::vector<Vec3>& image, Add&& add) {
    for (int i = 0; i < kBlocks * kBlocks; ++i) {
        add(static_cast<size_t>(i), blockMean(image, kBlocks * kBlockPixels, i % kBlocks * kBlockPixels,
                                              i / kBlocks * kBlockPixels, kBlockPixels));
    }
    add(kWhole, blockMean(image, kBlocks * kBlockPixels, 0, 0, kBlocks * kBlockPixels));
}

void addPaths(const SceneDescription& scene, Blocks* blocks) {
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
        addBlocks(renderPaths(scene, 100 + seed, 96),
                  [&](size_t i, double mean) { (*blocks)[i].paths.add(mean); });
    }
}

double meanRadius(const SppmState& state) {
    RunningMean mean;
    for (const SppmPixel& pixel : state.pixels) {
        if (pixel.radiusSquared > 0.0) { mean.add(std::sqrt(pixel.radiusSquared)); }
    }
    return mean.mean();
}

/// Adds the pictures of all seeds; returns the mean final radius as a share of the first.
double addSppm(const SceneDescription& scene, SppmParams params, uint32_t passes, Blocks* blocks) {
    RunningMean final;
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
        params.pass.seed = seed;
        const SppmRender render = renderSppm(scene, params, passes);
        addBlocks(render.image, [&](size_t i, double mean) { (*blocks)[i].sppm.add(mean); });
        final.add(meanRadius(render.state));
    }
    params.alpha = 0.999999;  // one pass that keeps the radius
    return final.mean() / meanRadius(renderSppm(scene, params, 1).state);
}

/// What the disc may cost or bring. Within a radius r of an edge between surfaces it misses between a half
/// and nothing of itself, 4 / (3 pi) / 2 = 0.21 on average; edges that cross a block both ways have such
/// strips on both sides over at most 4 r / 8 of it, r in pixels. The picture is the mean over passes, whose
/// radii fall like i^(-1/6) for the alpha of 2/3 and are 6/5 of the last on average.
double blockBiasBound(double finalRadiusPixels) {
    return 0.21 * 4.0 * 1.2 * finalRadiusPixels / kBlockPixels;
}

/// What one edge loses another gains: over a whole picture the bias is much smaller than in a block.
constexpr double kWholeBiasBound = 0.03;

void expectAgreement(const SceneDescription& scene, const SppmParams& params, uint32_t passes) {
    Blocks blocks;
    addPaths(scene, &blocks);
    const double shrink = addSppm(scene, params, passes, &blocks);
    const double blockBound = blockBiasBound(static_cast<double>(params.radiusFootprints) * shrink);
    const double mean = blocks[kWhole].paths.mean();
    for (size_t i = 0; i < blocks.size(); ++i) {
        const Block& block = blocks[i];
        const double bound = i == kWhole ? kWholeBiasBound : blockBound;
        EXPECT_LE(std::fabs(block.difference()),
                  kStudentQuantile * block.error() + bound * block.paths.mean())
            << "block " << i << ": " << block.difference() / mean << " of the picture's mean, error "
            << block.error() / mean;
        EXPECT_LT(block.error(), 0.06 * mean) << "block " << i << " is too noisy to tell";
    }
}

/// Whether direct light is sampled, and whether flat objects are wound the other way.
class SppmAgainstPaths : public testing::TestWithParam<std::tuple<bool, bool>> {
  protected:
    static SppmParams params() { return paramsFor(std::get<0>(GetParam())); }
    static void expectAgreementOf(const SceneDescription& scene, const SppmParams& params) {
        expectAgreement(std::get<1>(GetParam()) ? otherWinding(scene) : scene, params, 24);
    }
};

TEST_P(SppmAgainstPaths, CornellBox) { expectAgreementOf(small(cornellBox()), params()); }
TEST_P(SppmAgainstPaths, RoughGlass) { expectAgreementOf(roughGlassBox(), params()); }
TEST_P(SppmAgainstPaths, RoughGlassInContact) { expectAgreementOf(roughGlassInContact(), params()); }
TEST_P(SppmAgainstPaths, EmitterForms) { expectAgreementOf(small(emitterShapes()), params()); }
TEST_P(SppmAgainstPaths, Furnace) {
    SppmParams more = params();
    more.photonsPerPass = 40000;
    expectAgreementOf(small(whiteFurnace()), more);
}

INSTANTIATE_TEST_SUITE_P(DirectLight, SppmAgainstPaths, testing::Combine(testing::Bool(), testing::Bool()),
                         [](const auto& mode) {
                             return std::string(std::get<0>(mode.param) ? "Sampled" : "Photons") +
                                    (std::get<1>(mode.param) ? "OtherWinding" : "");
                         });

/// Sum of squared differences of the blocks, less what their errors explain.
double squaredBias(const SceneDescription& scene, const SppmParams& params, uint32_t passes, Blocks blocks) {
    addSppm(scene, params, passes, &blocks);
    double sum = 0.0;
    for (size_t i = 0; i < kWhole; ++i) {
        const Block& block = blocks[i];
        sum += block.difference() * block.difference() - block.error() * block.error();
    }
    return sum;
}

TEST(Sppm, DifferenceShrinksWithPasses) {
    const SceneDescription scene = small(cornellBox());
    SppmParams params = paramsFor(false);
    params.radiusFootprints = 8.0f;  // wide, so that its bias stands out of the noise
    Blocks paths;
    addPaths(scene, &paths);
    const double few = squaredBias(scene, params, 2, paths);
    const double some = squaredBias(scene, params, 12, paths);
    const double many = squaredBias(scene, params, 72, paths);
    EXPECT_GT(few, 0.0);
    EXPECT_LT(some, 0.8 * few);
    EXPECT_LT(many, 0.8 * some);
}

}  // namespace
}  // namespace glint::test
