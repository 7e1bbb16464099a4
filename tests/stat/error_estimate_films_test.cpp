// The error estimate of films that are made in code: lamps, sparks, nothing, and pixels without samples.
#include <cmath>

#include <gtest/gtest.h>

#include "engine/render/error_estimate.h"
#include "engine/render/film.h"
#include "tests/support/uniform_numbers.h"

namespace glint::test {
namespace {

/// A film in code: pixel i scatters by `sigma`, one pixel holds one firefly.
TEST(EstimateOfFilms, AFireflyDoesNotDecideForTheImage) {
    Film film(64, 64);
    std::vector<PixelSample> samples(64 * 64);
    UniformNumbers random(3);
    for (uint32_t pass = 0; pass < 64; ++pass) {
        for (PixelSample& sample : samples) {
            sample.radiance = Vec3(random.next() * 2.0f);
        }
        if (pass == 40) { samples[1234].radiance = Vec3(1e6f); }
        film.commit(samples, pass, 1);
        calibrateNoise(nullptr, 0.0, 1, &film);
    }
    // Uniform on [0, 2]: a standard deviation of 1 / sqrt(3).
    const double spread = std::sqrt(1.0 / 3.0 / 64.0);
    const double mean = 1.0 + 1e6 / 64.0 / 4096.0;
    EXPECT_NEAR(estimateRmseOverMean(film, nullptr).relative * mean, spread, 0.1 * spread);
    const ErrorEstimate estimate = estimateError(film, nullptr);
    EXPECT_NEAR(estimate.relative, spread, 0.1 * spread);
    EXPECT_LE(estimate.low, estimate.relative);
    EXPECT_GE(estimate.high, estimate.relative);
    EXPECT_GT(film.relativeErrorEstimate(), 3.0) << "without leaving the worst out";
}

/// Nine sparks in ten thousand pixels, and lamps of a thousand times the walls' brightness: the picture is
/// as good as its other pixels are, but for the sparks' own share.
TEST(EstimateOfFilms, LampsAndSparksDoNotDominate) {
    constexpr int kSide100 = 100;
    Film film(kSide100, kSide100);
    std::vector<PixelSample> samples(kSide100 * kSide100);
    UniformNumbers random(9);
    for (uint32_t pass = 0; pass < 64; ++pass) {
        for (size_t i = 0; i < samples.size(); ++i) {
            const float lamp = i < 200 ? 1000.0f : 1.0f;
            samples[i].radiance = Vec3(lamp * 2.0f * random.next());
        }
        for (size_t row = 10; row < 100 && pass == 40; row += 10) {
            samples[row * kSide100 + 50].radiance = Vec3(1e6f);
        }
        film.commit(samples, pass, 1);
        calibrateNoise(nullptr, 0.0, 1, &film);
    }
    const double spread = std::sqrt(1.0 / 3.0 / 64.0);
    const ErrorEstimate estimate = estimateError(film, nullptr);
    EXPECT_NEAR(estimate.relative, spread, 0.1 * spread);
    EXPECT_GT(estimateRmseOverMean(film, nullptr).relative, 3.0 * spread);
    EXPECT_NEAR(estimate.whollyWrong, 9e-4, 1e-4);
}

TEST(EstimateOfFilms, OfNothingIsInfiniteAndOfBlacknessZero) {
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
TEST(EstimateOfFilms, APixelWithoutSamplesSpoilsNothing) {
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
