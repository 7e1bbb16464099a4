// How well the error estimate is calibrated: against references that are much better than what is estimated,
// over pixels and seeds.
//
// The issue is coverage: the truth is to lie within a 90 % bound or band for 85 to 95 % of the pixels and of
// the renders. Pixels of a seed share photons and neighbourhoods, so that seeds are the independent units: a
// scene fails when its pixels' coverage over the seeds lies outside by more than three standard errors of
// their mean (two-sided significance 0.003). The whole picture's band holds or not, once a seed: binomial
// tests at the ends of 85 and 95 %, for each scene against bands that are too narrow (significance 0.001),
// for all scenes together against both (0.005).
#include "engine/render/error_estimate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "engine/io/scene_loader.h"
#include "engine/render/noise_calibration.h"
#include "tests/support/error_trial.h"
#include "tests/support/render_scene.h"
#include "tests/support/statistics.h"
#include "tests/support/test_scenes.h"
#include "tests/support/true_error.h"
#include "tests/support/uniform_numbers.h"

namespace glint::test {
namespace {

constexpr int kSide = 20;
constexpr uint32_t kSeeds = 20;

SceneDescription fromFile(const std::string& name, IntegratorKind integrator) {
    auto loaded = loadScene(std::string(GLINT_SOURCE_DIR "/scenes/") + name);
    EXPECT_TRUE(loaded) << name;
    SceneDescription scene = std::move(*loaded);
    scene.options.integrator = integrator;
    return scene;
}

SceneDescription small(SceneDescription scene) {
    scene.resolution = {kSide, kSide};
    scene.sppm.photonsPerPass = 2000;
    return scene;
}

double coverage(const std::vector<double>& image, const std::vector<double>& reference,
                const std::vector<float>& bounds) {
    double inside = 0.0;
    for (size_t i = 0; i < image.size(); ++i) {
        inside += std::abs(image[i] - reference[i]) <= static_cast<double>(bounds[i]) ? 1.0 : 0.0;
    }
    return inside / static_cast<double>(image.size());
}

struct Calibration {
    RunningMean pixels;    ///< share of the pixels within their bound, over seeds
    int inBand = 0;        ///< seeds whose whole-picture error lay within its band
    RunningMean logRatio;  ///< of the true error to the estimate, over seeds
    RunningMean foretold;  ///< what the band says that its standard deviation is
};

/// kSeeds renders from `firstSeed` on.
Calibration calibrate(const SceneDescription& scene, const std::vector<double>& reference, uint32_t passes,
                      uint32_t firstSeed) {
    Calibration result;
    const auto built = buildAll(scene);
    for (uint32_t seed = firstSeed; seed < firstSeed + kSeeds; ++seed) {
        ErrorTrial trial(built, scene, seed);
        trial.renderTo(passes);
        const std::vector<double> image = trial.luminances();
        const ErrorEstimate estimate = estimateError(trial.film(), trial.sppm());
        const double truth = trueError(image, reference);
        result.pixels.add(coverage(image, reference, errorBounds(trial.film(), trial.sppm())));
        result.inBand += truth >= estimate.low && truth <= estimate.high ? 1 : 0;
        result.logRatio.add(std::log(truth / estimate.relative));
        result.foretold.add(std::log(estimate.high / estimate.low) / (2.0 * 1.6448536));
    }
    return result;
}

std::vector<double> referenceOf(const SceneDescription& scene, uint32_t passes) {
    ErrorTrial trial(buildAll(scene), scene, 999);
    trial.renderTo(passes);
    return trial.luminances();
}

/// The whole picture's bands of all scenes, which the tests below fill in their order.
class Estimate : public testing::Test {
  protected:
    /// By `early` and by `late` passes, with seeds of their own.
    static void expectCalibrated(const SceneDescription& scene, const std::vector<double>& reference,
                                 uint32_t early, uint32_t late, const char* what) {
        const int before = inBand_;
        expectPixels(calibrate(scene, reference, early, 1), what, early);
        expectPixels(calibrate(scene, reference, late, 1 + kSeeds), what, late);
        EXPECT_GT(binomialAtMost(inBand_ - before, 2 * static_cast<int>(kSeeds), 0.85), 0.001)
            << what << ": the band is too narrow, it held " << inBand_ - before << " times";
        renders_ += 2 * static_cast<int>(kSeeds);
        ++scenes_;
    }

    static int inBand_, renders_, scenes_;

  private:
    /// Also: the mean estimate is within a factor of 1.35 of the truth.
    static void expectPixels(const Calibration& found, const char* what, uint32_t passes) {
        const double slack = 3.0 * found.pixels.standardError();
        EXPECT_GE(found.pixels.mean(), 0.85 - slack) << what << ": bounds are too narrow";
        EXPECT_LE(found.pixels.mean(), 0.95 + slack) << what << ": bounds are too wide";
        EXPECT_LT(found.pixels.standardError(), 0.02) << what << ": too few seeds to tell";
        EXPECT_LT(std::abs(found.logRatio.mean()), std::log(1.35)) << what << ", " << passes << " passes";
        std::printf(
            "%s, %u passes: %.1f %% of the pixels within their bound, %d of %u seeds within the band; "
            "ln(truth / "
            "estimate) %.2f +- %.2f, foretold 0 +- %.2f\n",
            what, passes, 100.0 * found.pixels.mean(), found.inBand, kSeeds, found.logRatio.mean(),
            std::sqrt(found.logRatio.variance()), found.foretold.mean());
        inBand_ += found.inBand;
    }
};

int Estimate::inBand_ = 0;
int Estimate::renders_ = 0;
int Estimate::scenes_ = 0;

TEST_F(Estimate, OfADiffuseBoxByPaths) {
    const SceneDescription scene = small(cornellBox());
    const std::vector<double> reference = referenceOf(scene, 2048);
    expectCalibrated(scene, reference, 32, 100, "diffuse box");
}

TEST_F(Estimate, OfGlassAndMirrorByPaths) {
    const SceneDescription scene = small(fromFile("cornell_glass_mirror.json", IntegratorKind::PathTracing));
    const std::vector<double> reference = referenceOf(scene, 3000);
    expectCalibrated(scene, reference, 32, 100, "glass and mirror");
}

/// Blurred lamps, which most pixels miss for long: without its neighbours a pixel would know nothing of them.
TEST_F(Estimate, OfBlurredLampsByPaths) {
    const SceneDescription scene = small(fromFile("depth_of_field.json", IntegratorKind::PathTracing));
    const std::vector<double> reference = referenceOf(scene, 6000);
    for (const uint32_t passes : {8u, 64u}) {
        const auto built = buildAll(scene);
        RunningMean logRatio;
        for (uint32_t seed = 1; seed <= 10; ++seed) {
            ErrorTrial trial(built, scene, seed);
            trial.renderTo(passes);
            const ErrorEstimate estimate = estimateError(trial.film(), nullptr);
            logRatio.add(std::log(trueError(trial.luminances(), reference) / estimate.relative));
        }
        std::printf("blurred lamps, %u passes: ln(truth / estimate) %.2f +- %.2f\n", passes, logRatio.mean(),
                    logRatio.standardError());
        EXPECT_LT(std::abs(logRatio.mean()), std::log(1.4)) << passes;
    }
}

TEST_F(Estimate, UnderAnEnvironmentByPaths) {
    const SceneDescription scene = small(meshInstances());
    const std::vector<double> reference = referenceOf(scene, 2048);
    expectCalibrated(scene, reference, 32, 100, "environment");
}

/// Most of the error is bias here: the reference has a quarter of the radius and eight times the photons.
TEST_F(Estimate, OfCausticsByPhotons) {
    const SceneDescription scene = small(fromFile("sppm_glass_sphere.json", IntegratorKind::Sppm));
    SceneDescription fine = scene;
    fine.sppm.radiusFootprints /= 4.0f;
    fine.sppm.photonsPerPass *= 8;
    const std::vector<double> reference = referenceOf(fine, 160);
    expectCalibrated(scene, reference, 16, 50, "caustics");
}

/// Must come after the four above.
TEST_F(Estimate, BandsOfAllScenesHoldNeitherTooSeldomNorTooOften) {
    if (scenes_ < 4) { GTEST_SKIP() << "needs the four scenes before it"; }
    std::printf("%d of %d bands held: %.1f %%\n", inBand_, renders_, 100.0 * inBand_ / renders_);
    EXPECT_GT(binomialAtMost(inBand_, renders_, 0.85), 0.005) << "too narrow";
    EXPECT_GT(1.0 - binomialAtMost(inBand_ - 1, renders_, 0.95), 0.005) << "too wide";
}

/// What is left out are the largest errors as they turned out, not the pixels with the largest variances:
/// with the error in few pixels that is much more.
TEST_F(Estimate, KnowsWhatLeavingOutTheWorstTakesAway) {
    constexpr int kWidth = 64, kLoud = 40, kTrials = 120;
    RunningMean truth, estimated;
    int inBand = 0;
    UniformNumbers random(11);
    const auto normal = [&random] {
        const double u = std::max(1e-7, static_cast<double>(random.next()));
        return static_cast<float>(std::sqrt(-2.0 * std::log(u)) *
                                  std::cos(6.283185307 * static_cast<double>(random.next())));
    };
    for (int trial = 0; trial < kTrials; ++trial) {
        Film film(kWidth, kWidth);
        std::vector<PixelSample> samples(kWidth * kWidth);
        for (uint32_t pass = 0; pass < 32; ++pass) {
            for (size_t i = 0; i < samples.size(); ++i) {
                samples[i].radiance = Vec3(10.0f + (i < kLoud ? 5.0f : 0.1f) * normal());
            }
            film.commit(samples, pass, 1);
            calibrateNoise(nullptr, 0.0, 1, &film);
        }
        std::vector<double> squares;
        for (const FilmPixel& pixel : film.pixels()) {
            squares.push_back(std::pow(pixel.mean[0] - 10.0, 2.0));
        }
        std::ranges::sort(squares);
        double sum = 0.0;
        for (size_t i = 0; i + 4 < squares.size(); ++i) {
            sum += squares[i];
        }
        const ErrorEstimate estimate = estimateRmseOverMean(film, nullptr);
        truth.add(sum / kWidth / kWidth / 100.0);
        estimated.add(estimate.relative * estimate.relative);
        const double error = std::sqrt(sum) / kWidth / 10.0;
        inBand += error >= estimate.low && error <= estimate.high ? 1 : 0;
    }
    // The four largest of forty squares hold 0.36 of their sum, the four largest variances a tenth.
    const double slack = 4.0 * std::hypot(truth.standardError(), estimated.standardError());
    EXPECT_NEAR(estimated.mean(), truth.mean(), slack);
    EXPECT_LT(slack, 0.15 * truth.mean()) << "too few trials to tell";
    EXPECT_GT(binomialAtMost(inBand, kTrials, 0.85), 0.001) << inBand;
}

/// Everything about the estimate is the same for any number of threads.
TEST_F(Estimate, BitsDoNotDependOnThreads) {
    const SceneDescription scene = small(fromFile("sppm_glass_sphere.json", IntegratorKind::Sppm));
    const auto built = buildAll(scene);
    ErrorTrial one(built, scene, 5, 1);
    ErrorTrial many(built, scene, 5, 3);
    one.renderTo(8);
    many.renderTo(8);
    const NoiseCalibration& learnt = one.film().calibration();
    EXPECT_EQ(learnt.passes, 8u);
    EXPECT_EQ(learnt.factors, many.film().calibration().factors);
    EXPECT_EQ(learnt.correlatedPixels, many.film().calibration().correlatedPixels);
    EXPECT_GT(learnt.correlatedPixels, 1.4) << "discs of four pixels share photons";
    const ErrorEstimate a = estimateError(one.film(), one.sppm(), 1);
    const ErrorEstimate b = estimateError(many.film(), many.sppm(), 3);
    EXPECT_EQ(a.relative, b.relative);
    EXPECT_EQ(a.high, b.high);
    EXPECT_EQ(errorBounds(one.film(), one.sppm(), 1), errorBounds(many.film(), many.sppm(), 3));
}

}  // namespace
}  // namespace glint::test
