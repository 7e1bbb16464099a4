// The film's mean, variance and error estimate against the textbook's two-pass formulas, and its independence
// of threads.
#include "engine/render/film.h"

#include <cmath>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

namespace glint {
namespace {

std::vector<std::vector<PixelSample>> randomPasses(int pixels, int passes, float offset) {
    std::mt19937 engine(7);
    std::exponential_distribution<float> brightness(1.0f);
    std::vector<std::vector<PixelSample>> out(passes, std::vector<PixelSample>(pixels));
    for (auto& pass : out) {
        for (PixelSample& sample : pass) {
            sample.radiance = Vec3(offset) + Vec3(brightness(engine), brightness(engine), brightness(engine));
            sample.rays = 5;
        }
    }
    return out;
}

double luminanceOf(const Vec3& c) {
    return 0.2126 * double(c.x) + 0.7152 * double(c.y) + 0.0722 * double(c.z);
}

Film filmOf(int width, int height, const std::vector<std::vector<PixelSample>>& passes, int threads) {
    Film film(width, height);
    for (size_t pass = 0; pass < passes.size(); ++pass) {
        film.commit(passes[pass], static_cast<uint32_t>(pass), threads);
    }
    return film;
}

bool sameBits(const Film& a, const Film& b) {
    if (a.pixels().size() != b.pixels().size()) { return false; }
    for (size_t i = 0; i < a.pixels().size(); ++i) {
        const FilmPixel &p = a.pixels()[i], &q = b.pixels()[i];
        if (std::memcmp(p.mean.data(), q.mean.data(), sizeof p.mean) != 0 ||
            std::memcmp(&p.luminanceM2, &q.luminanceM2, sizeof p.luminanceM2) != 0 || p.count != q.count) {
            return false;
        }
    }
    return a.rays() == b.rays() && a.passes() == b.passes();
}

TEST(Film, VarianceAgreesWithTheTwoPassFormula) {
    constexpr int kWidth = 9, kHeight = 5, kPasses = 400;
    // A large offset makes the naive sum of squares lose its digits; Welford's must not.
    for (const float offset : {0.0f, 1000.0f}) {
        const auto passes = randomPasses(kWidth * kHeight, kPasses, offset);
        const Film film = filmOf(kWidth, kHeight, passes, 1);
        for (int i = 0; i < kWidth * kHeight; ++i) {
            double mean = 0.0, squares = 0.0;
            for (const auto& pass : passes) {
                mean += luminanceOf(pass[i].radiance) / kPasses;
            }
            for (const auto& pass : passes) {
                squares += std::pow(luminanceOf(pass[i].radiance) - mean, 2.0);
            }
            const FilmPixel& pixel = film.pixels()[i];
            EXPECT_NEAR(0.2126 * pixel.mean[0] + 0.7152 * pixel.mean[1] + 0.0722 * pixel.mean[2], mean,
                        1e-10 * mean);
            EXPECT_NEAR(pixel.luminanceM2, squares, 1e-9 * squares);
            EXPECT_NEAR(film.standardError(pixel), std::sqrt(squares / (kPasses - 1.0) / kPasses), 1e-9);
        }
    }
}

TEST(Film, RelativeErrorIsTheRootMeanSquareOverTheMean) {
    const auto passes = randomPasses(64, 50, 0.0f);
    const Film film = filmOf(8, 8, passes, 1);
    double squares = 0.0, luminance = 0.0;
    for (const FilmPixel& pixel : film.pixels()) {
        squares += std::pow(film.standardError(pixel), 2.0) / 64;
        luminance += (0.2126 * pixel.mean[0] + 0.7152 * pixel.mean[1] + 0.0722 * pixel.mean[2]) / 64;
    }
    EXPECT_NEAR(film.relativeErrorEstimate(), std::sqrt(squares) / luminance, 1e-12);
}

TEST(Film, ErrorIsInfiniteBeforeTwoPassesAndZeroForABlackImage) {
    Film film(4, 4);
    const std::vector<PixelSample> black(16);
    EXPECT_TRUE(std::isinf(film.relativeErrorEstimate()));
    film.commit(black, 0, 1);
    EXPECT_TRUE(std::isinf(film.relativeErrorEstimate()));
    film.commit(black, 1, 1);
    EXPECT_EQ(film.relativeErrorEstimate(), 0.0);
}

TEST(Film, BitsDoNotDependOnTheNumberOfThreads) {
    constexpr int kWidth = 301, kHeight = 211;
    const auto passes = randomPasses(kWidth * kHeight, 5, 0.0f);
    const Film one = filmOf(kWidth, kHeight, passes, 1);
    for (const int threads : {2, 3, 7}) {
        const Film many = filmOf(kWidth, kHeight, passes, threads);
        EXPECT_TRUE(sameBits(one, many)) << threads << " threads";
        EXPECT_EQ(one.relativeErrorEstimate(1), many.relativeErrorEstimate(threads));
    }
}

TEST(Film, FaultsAreCountedRecordedAndLeftOut) {
    constexpr int kWidth = 200, kHeight = 150;
    std::vector<PixelSample> samples(kWidth * kHeight);
    for (PixelSample& sample : samples) {
        sample.radiance = Vec3(2.0f);
    }
    samples[7] = {Vec3(0.0f), SampleFault::NotANumber, 1};
    samples[29 * kWidth + 11] = {Vec3(0.0f), SampleFault::Negative, 1};
    for (const int threads : {1, 3}) {
        Film film(kWidth, kHeight);
        film.commit(samples, 42, threads);
        EXPECT_EQ(film.faultCounts()[static_cast<size_t>(SampleFault::NotANumber)], 1u);
        EXPECT_EQ(film.faultCounts()[static_cast<size_t>(SampleFault::Negative)], 1u);
        EXPECT_EQ(film.faultCounts()[static_cast<size_t>(SampleFault::Infinite)], 0u);
        ASSERT_EQ(film.faults().size(), 2u);
        EXPECT_EQ(film.faults()[0].x, 7);
        EXPECT_EQ(film.faults()[0].y, 0);
        EXPECT_EQ(film.faults()[1].x, 11);
        EXPECT_EQ(film.faults()[1].y, 29);
        EXPECT_EQ(film.faults()[1].pass, 42u);
        EXPECT_EQ(film.pixels()[7].count, 0u);
        EXPECT_EQ(film.pixels()[8].mean[0], 2.0);
    }
}

TEST(Film, KeepsNoMoreThanItsShareOfFaultRecords) {
    Film film(100, 100);
    const std::vector<PixelSample> bad(10000, {Vec3(0.0f), SampleFault::Infinite, 1});
    film.commit(bad, 0, 2);
    EXPECT_EQ(film.faultCounts()[static_cast<size_t>(SampleFault::Infinite)], 10000u);
    EXPECT_EQ(film.faults().size(), Film::kMaxFaultRecords);
}

TEST(Film, ClearedFilmIsLikeANewOne) {
    const auto passes = randomPasses(64, 3, 0.0f);
    Film used = filmOf(8, 8, passes, 1);
    used.clear();
    EXPECT_TRUE(sameBits(used, Film(8, 8)));
}

TEST(AovFilm, MeansAreAveragesAndIdsAreTheFirstPasses) {
    AovFilm film(1, 1);
    AovSample a, b;
    a.albedo = Vec3(0.2f);
    a.depth = 2.0f;
    a.objectId = 3;
    b.albedo = Vec3(0.6f);
    b.depth = 4.0f;
    b.objectId = 9;
    film.commit({a}, 1);
    film.commit({b}, 1);
    EXPECT_FLOAT_EQ(film.pixels()[0].albedo.x, 0.4f);
    EXPECT_FLOAT_EQ(film.pixels()[0].depth, 3.0f);
    EXPECT_EQ(film.pixels()[0].objectId, 3u);
}

}  // namespace
}  // namespace glint
