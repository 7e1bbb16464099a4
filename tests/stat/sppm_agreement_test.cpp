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

/// Adds the pictures of all seeds.
void addSppm(const SceneDescription& scene, SppmParams params, uint32_t passes, Blocks* blocks) {
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
        params.pass.seed = seed;
        addBlocks(renderSppm(scene, params, passes).image,
                  [&](size_t block, double mean) { (*blocks)[block].sppm.add(mean); });
    }
}

/// What the blur of a disc of two pixels may shift over a block's edge, and what is left of what edges of
/// surfaces cut off the discs: without correction that is up to 15 % of a block, and 1 % of the whole.
constexpr double kBlockBiasBound = 0.01;
constexpr double kWholeBiasBound = 0.005;

void expectAgreement(const SceneDescription& scene, const SppmParams& params, uint32_t passes) {
    Blocks blocks;
    addPaths(scene, &blocks);
    addSppm(scene, params, passes, &blocks);
    const double mean = blocks[kWhole].paths.mean();
    for (size_t i = 0; i < blocks.size(); ++i) {
        const Block& block = blocks[i];
        const double bound = i == kWhole ? kWholeBiasBound : kBlockBiasBound;
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
    /// Where light changes within the usual radius: highlights and balls of a few pixels.
    static SppmParams finer(uint32_t photons) {
        SppmParams out = params();
        out.photonsPerPass = photons;
        out.radiusFootprints = 1.0f;
        return out;
    }
    static void expectAgreementOf(const SceneDescription& scene, const SppmParams& params) {
        expectAgreement(std::get<1>(GetParam()) ? otherWinding(scene) : scene, params, 24);
    }
};

TEST_P(SppmAgainstPaths, CornellBox) { expectAgreementOf(small(cornellBox()), params()); }
TEST_P(SppmAgainstPaths, RoughGlass) { expectAgreementOf(roughGlassBox(), params()); }
TEST_P(SppmAgainstPaths, RoughGlassInContact) { expectAgreementOf(roughGlassInContact(), params()); }
TEST_P(SppmAgainstPaths, Bumps) { expectAgreementOf(bumpyBox(), params()); }
TEST_P(SppmAgainstPaths, Cutouts) { expectAgreementOf(cutoutBox(), params()); }
TEST_P(SppmAgainstPaths, AbsorbingGlass) { expectAgreementOf(absorbingGlassBox(), params()); }
TEST_P(SppmAgainstPaths, TranslucentSheets) { expectAgreementOf(translucentBox(), params()); }
TEST_P(SppmAgainstPaths, Projector) { expectAgreementOf(projectorBox(), finer(32000)); }
TEST_P(SppmAgainstPaths, Goniometric) { expectAgreementOf(goniometricBox(), finer(32000)); }
TEST_P(SppmAgainstPaths, Portal) { expectAgreementOf(portalBox(), params()); }
TEST_P(SppmAgainstPaths, Principled) { expectAgreementOf(principledBox(), finer(32000)); }
TEST_P(SppmAgainstPaths, Passing) { expectAgreementOf(passingBox(), finer(32000)); }
TEST_P(SppmAgainstPaths, Highlights) { expectAgreementOf(highlightBox(), finer(32000)); }
TEST_P(SppmAgainstPaths, Brushed) { expectAgreementOf(brushedBox(), finer(24000)); }
TEST_P(SppmAgainstPaths, Coated) { expectAgreementOf(coatedBox(), finer(24000)); }
TEST_P(SppmAgainstPaths, DispersiveGlass) {
    SppmParams more = params();
    more.photonsPerPass = 20000;
    expectAgreementOf(dispersiveGlass(), more);
}
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
    params.photonsPerPass = 4000;
    params.radiusFootprints = 16.0f;  // wide, so that its bias stands out of the noise
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
