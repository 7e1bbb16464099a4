// A caustic by photon mapping against brute force: path tracing of the same scene with 65,536 paths a pixel,
// stored with its noise as caustic_reference.exr (README.md here has the command). The lamp is large enough
// for paths to meet it through the glass.
//
// 64 blocks of 4x4 pixels, family-wise significance 1e-3: Student's t with at least 11 degrees of freedom,
// two-sided at 1e-3 / 64 (Bonferroni), plus the bias that the radius allows.
#include <cmath>

#include <gtest/gtest.h>

#include "engine/io/exr_io.h"
#include "engine/io/scene_loader.h"
#include "tests/support/sppm_render.h"
#include "tests/support/statistics.h"

namespace glint {
namespace {

constexpr int kSize = 32;
constexpr int kBlock = 4;
constexpr int kAcross = kSize / kBlock;
constexpr int kSeeds = 12;
constexpr double kStudentQuantile = 7.3;  // t(11) at 7.7e-6 above
/// Blocks at the lamp's edges, seen or mirrored, stay noisy; most others, and the caustic's, must be known
/// so well.
constexpr double kSharp = 0.02;
constexpr int kCausticX = 20, kCausticY = 28;
constexpr uint32_t kPasses = 12;
constexpr double kRadiusWorld = 0.02;

struct Reference {
    std::vector<Vec3> image;
    std::vector<double> standardError;  ///< of each pixel's luminance
};

Reference loadReference() {
    Reference out;
    const std::string path = GLINT_SOURCE_DIR "/tests/data/references/caustic_reference.exr";
    const auto file = loadExr(path);
    EXPECT_TRUE(file) << "the reference is part of the repository";
    if (!file) { return out; }
    const auto image = loadExrColor(path);
    const ExrChannel* error = file->find("standardError.Y");
    EXPECT_TRUE(image && error != nullptr);
    if (!image || error == nullptr) { return out; }
    const std::vector<float>& rgb = image->color.rgb;
    for (size_t i = 0; i < error->floats.size(); ++i) {
        out.image.emplace_back(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]);
        out.standardError.push_back(static_cast<double>(error->floats[i]));
    }
    return out;
}

double blockError(const Reference& reference, int x, int y) {
    double squares = 0.0;
    for (int k = 0; k < kBlock * kBlock; ++k) {
        const double error =
            reference.standardError[static_cast<size_t>((y + k / kBlock) * kSize + x + k % kBlock)];
        squares += error * error;
    }
    return std::sqrt(squares) / (kBlock * kBlock);
}

/// What a disc of the first radius misses at the edges of surfaces: half of itself at most, in a strip as
/// wide as the radius along both sides of an edge through the block. A pixel is about 0.085 m wide at the
/// back wall.
constexpr double kBiasBound = 0.5 * 2.0 * kRadiusWorld / (kBlock * 0.085);

TEST(Caustic, PhotonsAgreeWithBruteForce) {
    auto scene = loadScene(GLINT_SOURCE_DIR "/scenes/cornell_glass_mirror.json", {});
    ASSERT_TRUE(scene);
    scene->resolution = {kSize, kSize};
    const Reference reference = loadReference();
    ASSERT_EQ(reference.image.size(), static_cast<size_t>(kSize * kSize));

    SppmParams params;
    params.photonsPerPass = 60000;
    params.radiusWorld = static_cast<float>(kRadiusWorld);
    std::vector<test::RunningMean> blocks(kAcross * kAcross);
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
        params.pass.seed = seed;
        const std::vector<Vec3> image = test::renderSppm(*scene, params, kPasses).image;
        for (int i = 0; i < kAcross * kAcross; ++i) {
            blocks[static_cast<size_t>(i)].add(
                test::blockMean(image, kSize, i % kAcross * kBlock, i / kAcross * kBlock, kBlock));
        }
    }
    const double mean = test::blockMean(reference.image, kSize, 0, 0, kSize);
    int sharpBlocks = 0;
    for (int i = 0; i < kAcross * kAcross; ++i) {
        const int x = i % kAcross * kBlock, y = i / kAcross * kBlock;
        const test::RunningMean& found = blocks[static_cast<size_t>(i)];
        const double expected = test::blockMean(reference.image, kSize, x, y, kBlock);
        const double error = std::hypot(found.standardError(), blockError(reference, x, y));
        EXPECT_LE(std::fabs(found.mean() - expected), kStudentQuantile * error + kBiasBound * expected)
            << "block " << x << "," << y << ": " << found.mean() << " +- " << error << ", brute force "
            << expected;
        sharpBlocks += error < kSharp * expected ? 1 : 0;
        if (x == kCausticX && y == kCausticY) {
            EXPECT_GT(expected, mean) << "the caustic is where it was";
            EXPECT_LT(error, kSharp * expected) << "the caustic is too noisy to tell";
        }
    }
    EXPECT_GT(sharpBlocks, kAcross * kAcross * 3 / 4) << "too noisy to tell";
}

}  // namespace
}  // namespace glint
