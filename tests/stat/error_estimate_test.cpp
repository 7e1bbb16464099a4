// How well the error estimate is calibrated: against references that are much better than what is estimated,
// over pixels and seeds.
//
// The issue is coverage: the truth is to lie within the 90 % bound for 85 to 95 % of the pixels. Pixels of a
// seed share photons and neighbourhoods, so that seeds are the independent units: a scene fails when its
// coverage over kSeeds seeds lies outside by more than the error of their mean at the family's significance.
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
#include "tests/support/uniform_numbers.h"

namespace glint::test {
namespace {

constexpr int kSide = 20;
constexpr uint32_t kSeeds = 8;

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

/// Root of the mean squared error without the worst kTrimmedShare, relative to the reference's mean.
double trueError(const std::vector<double>& picture, const std::vector<double>& reference) {
    std::vector<double> squares;
    double mean = 0.0;
    for (size_t i = 0; i < picture.size(); ++i) {
        squares.push_back(std::pow(picture[i] - reference[i], 2.0));
        mean += reference[i] / static_cast<double>(picture.size());
    }
    const double worst = kTrimmedShare * static_cast<double>(squares.size());
    double sum = -worst * *std::ranges::max_element(squares);  // less than a pixel here
    for (const double square : squares) {
        sum += square;
    }
    return std::sqrt(sum / (static_cast<double>(squares.size()) - worst)) / mean;
}

double coverage(const std::vector<double>& picture, const std::vector<double>& reference,
                const std::vector<float>& bounds) {
    double inside = 0.0;
    for (size_t i = 0; i < picture.size(); ++i) {
        inside += std::abs(picture[i] - reference[i]) <= static_cast<double>(bounds[i]) ? 1.0 : 0.0;
    }
    return inside / static_cast<double>(picture.size());
}

struct Calibration {
    RunningMean pixels;    ///< share of the pixels within their bound, over seeds
    int inBand = 0;        ///< seeds whose whole-picture error lay within its band
    RunningMean logRatio;  ///< of the true error to the estimate, over seeds
};

Calibration calibrate(const SceneDescription& scene, const std::vector<double>& reference, uint32_t passes) {
    Calibration result;
    const auto built = buildAll(scene);
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
        ErrorTrial trial(built, scene, seed);
        trial.renderTo(passes);
        const std::vector<double> picture = trial.luminances();
        const ErrorEstimate estimate = estimateError(trial.film(), trial.sppm());
        const double truth = trueError(picture, reference);
        result.pixels.add(coverage(picture, reference, errorBounds(trial.film(), trial.sppm())));
        result.inBand += truth >= estimate.low && truth <= estimate.high ? 1 : 0;
        result.logRatio.add(std::log(truth / estimate.relative));
    }
    return result;
}

std::vector<double> referenceOf(const SceneDescription& scene, uint32_t passes) {
    ErrorTrial trial(buildAll(scene), scene, 999);
    trial.renderTo(passes);
    return trial.luminances();
}

/// The truth lies within the 90 % bound for 85 to 95 % of the pixels; the whole picture's error within its
/// band for at least 6 of 8 seeds (with 90 % each, 5 or fewer have a probability of 0.04, with 95 % of 0.006,
/// so the band may be a little too wide but not too narrow), and within a factor of 1.5 of the estimate on
/// average.
void expectCalibrated(const Calibration& found, const char* what) {
    const double slack = 3.0 * found.pixels.standardError();
    EXPECT_GE(found.pixels.mean(), 0.85 - slack) << what << ": bounds are too narrow";
    EXPECT_LE(found.pixels.mean(), 0.95 + slack) << what << ": bounds are too wide";
    EXPECT_LT(found.pixels.standardError(), 0.02) << what << ": too few seeds to tell";
    EXPECT_GE(found.inBand, 6) << what;
    EXPECT_LT(std::abs(found.logRatio.mean()), std::log(1.5)) << what;
    std::printf(
        "%s: %.1f %% of the pixels within their bound, %d of %u seeds within the band, truth / estimate "
        "%.2f\n",
        what, 100.0 * found.pixels.mean(), found.inBand, kSeeds, std::exp(found.logRatio.mean()));
}

TEST(ErrorEstimate, OfADiffuseBoxByPaths) {
    const SceneDescription scene = small(cornellBox());
    const std::vector<double> reference = referenceOf(scene, 2048);
    expectCalibrated(calibrate(scene, reference, 32), "diffuse box, 32 passes");
    expectCalibrated(calibrate(scene, reference, 100), "diffuse box, 100 passes");
}

TEST(ErrorEstimate, OfGlassAndMirrorByPaths) {
    const SceneDescription scene = small(fromFile("cornell_glass_mirror.json", IntegratorKind::PathTracing));
    const std::vector<double> reference = referenceOf(scene, 3000);
    expectCalibrated(calibrate(scene, reference, 32), "glass and mirror, 32 passes");
    expectCalibrated(calibrate(scene, reference, 100), "glass and mirror, 100 passes");
}

TEST(ErrorEstimate, UnderAnEnvironmentByPaths) {
    const SceneDescription scene = small(meshInstances());
    const std::vector<double> reference = referenceOf(scene, 2048);
    expectCalibrated(calibrate(scene, reference, 32), "environment, 32 passes");
    expectCalibrated(calibrate(scene, reference, 100), "environment, 100 passes");
}

/// Most of the error is bias here: the reference has a quarter of the radius and eight times the photons.
TEST(ErrorEstimate, OfCausticsByPhotons) {
    const SceneDescription scene = small(fromFile("sppm_glass_sphere.json", IntegratorKind::Sppm));
    SceneDescription fine = scene;
    fine.sppm.radiusFootprints /= 4.0f;
    fine.sppm.photonsPerPass *= 8;
    const std::vector<double> reference = referenceOf(fine, 160);
    expectCalibrated(calibrate(scene, reference, 16), "caustics, 16 passes");
    expectCalibrated(calibrate(scene, reference, 50), "caustics, 50 passes");
}

/// Everything about the estimate is the same for any number of threads.
TEST(ErrorEstimate, BitsDoNotDependOnThreads) {
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

/// A film in code: pixel i scatters by `sigma`, one pixel holds one firefly.
TEST(ErrorEstimate, AFireflyDoesNotDecideForThePicture) {
    Film film(64, 64);
    std::vector<PixelSample> samples(64 * 64);
    UniformNumbers random(3);
    for (uint32_t pass = 0; pass < 64; ++pass) {
        for (PixelSample& sample : samples) {
            sample.radiance = Vec3(random.next() * 2.0f);
        }
        if (pass == 40) {
            samples[1234].radiance = Vec3(1e6f);
        }
        film.commit(samples, pass, 1);
        calibrateNoise(nullptr, 0.0, 1, &film);
    }
    // Uniform on [0, 2]: a standard deviation of 1 / sqrt(3).
    const ErrorEstimate estimate = estimateError(film, nullptr);
    const double mean = 1.0 + 1e6 / 64.0 / 4096.0;
    EXPECT_NEAR(estimate.relative * mean, std::sqrt(1.0 / 3.0 / 64.0), 0.1 * std::sqrt(1.0 / 3.0 / 64.0));
    EXPECT_LE(estimate.low, estimate.relative);
    EXPECT_GE(estimate.high, estimate.relative);
    EXPECT_GT(film.relativeErrorEstimate(), 3.0) << "without leaving the worst out";
}

TEST(ErrorEstimate, OfNothingIsInfiniteAndOfBlacknessZero) {
    Film film(4, 4);
    EXPECT_TRUE(std::isinf(estimateError(film, nullptr).relative));
    EXPECT_TRUE(std::isinf(estimateError(Film(), nullptr).high));
    const std::vector<PixelSample> black(16);
    film.commit(black, 0, 1);
    EXPECT_TRUE(std::isinf(estimateError(film, nullptr).relative));
    EXPECT_TRUE(std::isinf(errorBounds(film, nullptr)[0]));
    film.commit(black, 1, 1);
    calibrateNoise(nullptr, 0.0, 1, &film);
    EXPECT_EQ(estimateError(film, nullptr).relative, 0.0);
    EXPECT_EQ(errorBounds(film, nullptr)[0], 0.0f);
}

/// A pixel whose samples were all dropped has an unknown error; the others' estimate stays.
TEST(ErrorEstimate, APixelWithoutSamplesSpoilsNothing) {
    Film film(40, 40);
    std::vector<PixelSample> samples(1600);
    UniformNumbers random(4);
    for (uint32_t pass = 0; pass < 16; ++pass) {
        for (PixelSample& sample : samples) {
            sample.radiance = Vec3(random.next());
        }
        samples[7] = {.radiance = Vec3(0.0f), .fault = SampleFault::NotANumber};
        film.commit(samples, pass, 1);
        calibrateNoise(nullptr, 0.0, 1, &film);
    }
    const ErrorEstimate estimate = estimateError(film, nullptr);
    EXPECT_GT(estimate.relative, 0.05);
    EXPECT_LT(estimate.high, 1.0);
}

}  // namespace
}  // namespace glint::test
