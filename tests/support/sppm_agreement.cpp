#include "tests/support/sppm_agreement.h"

#include "tests/support/render_scene.h"
#include "tests/support/sppm_scenes.h"

namespace glint::test {
namespace {

constexpr int kSeeds = 12;
constexpr double kStudentQuantile = 6.3;  // t(11) at 2.9e-5 above
constexpr int kBlocks = kAgreementBlocks;
constexpr int kBlockPixels = 8;
constexpr size_t kWhole = kBlocks * kBlocks;

template <class Add>
void addBlocks(const std::vector<Vec3>& image, Add&& add) {
    for (int i = 0; i < kBlocks * kBlocks; ++i) {
        add(static_cast<size_t>(i), blockMean(image, kBlocks * kBlockPixels, i % kBlocks * kBlockPixels,
                                              i / kBlocks * kBlockPixels, kBlockPixels));
    }
    add(kWhole, blockMean(image, kBlocks * kBlockPixels, 0, 0, kBlocks * kBlockPixels));
}

/// What the blur of a disc of two pixels may shift over a block's edge, and what is left of what edges of
/// surfaces cut off the discs: without correction that is up to 15 % of a block, and 1 % of the whole.
constexpr double kBlockBiasBound = 0.01;
constexpr double kWholeBiasBound = 0.005;

}  // namespace

SppmParams agreementParams(bool sampleDirectLight) {
    SppmParams params;
    params.photonsPerPass = 8000;
    params.radiusFootprints = 2.0f;
    params.sampleDirectLight = sampleDirectLight;
    return params;
}

void addPaths(const SceneDescription& scene, AgreementBlocks* blocks) {
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
        addBlocks(renderPaths(scene, 100 + seed, 96),
                  [&](size_t i, double mean) { (*blocks)[i].paths.add(mean); });
    }
}

void addSppm(const SceneDescription& scene, SppmParams params, uint32_t passes, AgreementBlocks* blocks) {
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
        params.pass.seed = seed;
        addBlocks(renderSppm(scene, params, passes).image,
                  [&](size_t block, double mean) { (*blocks)[block].sppm.add(mean); });
    }
}

void expectAgreement(const SceneDescription& scene, const SppmParams& params, uint32_t passes) {
    AgreementBlocks blocks;
    addPaths(scene, &blocks);
    addSppm(scene, params, passes, &blocks);
    const double mean = blocks[kWhole].paths.mean();
    for (size_t i = 0; i < blocks.size(); ++i) {
        const AgreementBlock& block = blocks[i];
        const double bound = i == kWhole ? kWholeBiasBound : kBlockBiasBound;
        EXPECT_LE(std::fabs(block.difference()),
                  kStudentQuantile * block.error() + bound * block.paths.mean())
            << "block " << i << ": " << block.difference() / mean << " of the picture's mean, error "
            << block.error() / mean;
        EXPECT_LT(block.error(), 0.06 * mean) << "block " << i << " is too noisy to tell";
    }
}

void SppmAgainstPaths::expectAgreementOf(const SceneDescription& scene, const SppmParams& params) {
    expectAgreement(std::get<1>(GetParam()) ? otherWinding(scene) : scene, params, 24);
}

}  // namespace glint::test
