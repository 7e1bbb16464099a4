// SPPM against path tracing where both converge: block by block, over independent seeds, whichever side of
// walls is their front.
//
// The signed difference of each of 16 blocks must lie within its confidence interval and the bias that the
// radius allows. Family-wise level 1e-3 for each scene and mode: Student's t with at least 11 degrees of
// freedom, two-sided at 1e-3 / 17 (Bonferroni: 16 blocks and the whole picture).
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/support/sppm_render.h"
#include "tests/support/statistics.h"

namespace glint::test {

constexpr int kAgreementBlocks = 4;  ///< an axis

struct AgreementBlock {
    RunningMean sppm, paths;
    double difference() const { return sppm.mean() - paths.mean(); }
    double error() const { return std::hypot(sppm.standardError(), paths.standardError()); }
};
/// The last one is the whole picture.
using AgreementBlocks = std::array<AgreementBlock, kAgreementBlocks * kAgreementBlocks + 1>;

/// Adds the pictures of all seeds of a scene that is small (sppm_scenes.h).
void addPaths(const SceneDescription& scene, AgreementBlocks* blocks);
void addSppm(const SceneDescription& scene, SppmParams params, uint32_t passes, AgreementBlocks* blocks);

/// 8000 photons a pass and a radius of two pixels.
SppmParams agreementParams(bool sampleDirectLight);

void expectAgreement(const SceneDescription& scene, const SppmParams& params, uint32_t passes);

/// Whether direct light is sampled, and whether flat objects are wound the other way.
class SppmAgainstPaths : public testing::TestWithParam<std::tuple<bool, bool>> {
  protected:
    static SppmParams params() { return agreementParams(std::get<0>(GetParam())); }
    /// Where light changes within the usual radius: highlights and balls of a few pixels.
    static SppmParams finer(uint32_t photons, float radiusFootprints = 1.0f) {
        SppmParams out = params();
        out.photonsPerPass = photons;
        out.radiusFootprints = radiusFootprints;
        return out;
    }
    static void expectAgreementOf(const SceneDescription& scene, const SppmParams& params);
};

/// Of a mode of SppmAgainstPaths.
inline std::string agreementModeName(const testing::TestParamInfo<std::tuple<bool, bool>>& mode) {
    return std::string(std::get<0>(mode.param) ? "Sampled" : "Photons") +
           (std::get<1>(mode.param) ? "OtherWinding" : "");
}

}  // namespace glint::test
