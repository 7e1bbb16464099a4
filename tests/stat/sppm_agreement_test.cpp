// Photon mapping against path tracing (support/sppm_agreement.h): rooms, glass, sheets and emitters.
#include "tests/support/sppm_agreement.h"

#include "tests/support/sppm_scenes.h"
#include "tests/support/test_scenes.h"

namespace glint::test {
namespace {

TEST_P(SppmAgainstPaths, CornellBox) { expectAgreementOf(small(cornellBox()), params()); }
TEST_P(SppmAgainstPaths, RoughGlass) { expectAgreementOf(roughGlassBox(), params()); }
TEST_P(SppmAgainstPaths, RoughGlassInContact) { expectAgreementOf(roughGlassInContact(), params()); }
TEST_P(SppmAgainstPaths, Bumps) { expectAgreementOf(bumpyBox(), params()); }
TEST_P(SppmAgainstPaths, Cutouts) { expectAgreementOf(cutoutBox(), params()); }
TEST_P(SppmAgainstPaths, AbsorbingGlass) { expectAgreementOf(absorbingGlassBox(), params()); }
TEST_P(SppmAgainstPaths, TranslucentSheets) { expectAgreementOf(translucentBox(), params()); }
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
                         agreementModeName);

/// Sum of squared differences of the blocks, less what their errors explain.
double squaredBias(const SceneDescription& scene, const SppmParams& params, uint32_t passes,
                   AgreementBlocks blocks) {
    addSppm(scene, params, passes, &blocks);
    double sum = 0.0;
    for (size_t i = 0; i + 1 < blocks.size(); ++i) {
        const AgreementBlock& block = blocks[i];
        sum += block.difference() * block.difference() - block.error() * block.error();
    }
    return sum;
}

TEST(Sppm, DifferenceShrinksWithPasses) {
    const SceneDescription scene = small(cornellBox());
    SppmParams params = agreementParams(false);
    params.photonsPerPass = 4000;
    params.radiusFootprints = 16.0f;  // wide, so that its bias stands out of the noise
    AgreementBlocks paths;
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
