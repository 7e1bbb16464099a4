// The two filters on a picture whose truth is known: a textured floor, a wall and a ball before nothing, with
// light that falls off and a shadow that no feature tells of.
#include "engine/denoise/denoise.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "engine/math/color.h"

namespace glint {
namespace {

constexpr int kWidth = 128;
constexpr int kHeight = 96;
constexpr int kHorizon = 40;

struct KnownPicture {
    DenoiseInput input;
    std::vector<Vec3> truth;
};

size_t at(int x, int y) { return static_cast<size_t>(y * kWidth + x); }
bool isFloor(int y) { return y >= kHorizon + 4; }

/// The floor has squares of 3 pixels, bright and dark.
void addHit(int x, int y, DenoiseInput* input) {
    const Vec2 fromBall(static_cast<float>(x - 90), static_cast<float>(y - 30));
    const float radius = 16.0f, distance = glm::length(fromBall);
    if (distance < radius) {
        const Vec2 flat = fromBall / radius;
        input->normal.emplace_back(flat.x, -flat.y, std::sqrt(1.0f - glm::dot(flat, flat)));
        input->albedo.emplace_back(0.2f, 0.4f, 0.8f);
        input->depth.push_back(3.0f);
    } else if (y < kHorizon) {
        input->normal.emplace_back(x < 30 ? Vec3(0.0f) : Vec3(0.0f, 0.0f, 1.0f));
        input->albedo.emplace_back(x < 30 ? Vec3(0.0f) : Vec3(0.7f));
        input->depth.push_back(x < 30 ? 0.0f : 6.0f);
    } else {
        const bool isDark = (x / 3 + y / 3) % 2 == 0;
        input->normal.emplace_back(0.0f, 1.0f, 0.0f);
        input->albedo.emplace_back(isDark ? Vec3(0.15f, 0.1f, 0.1f) : Vec3(0.8f, 0.7f, 0.6f));
        input->depth.push_back(100.0f / static_cast<float>(y - kHorizon + 16));
    }
}

/// What lights a pixel: brighter to the right, from above on the ball, less in a shadow on the floor.
float lightAt(int x, int y, const Vec3& normal) {
    const float gradient = 0.3f + static_cast<float>(x) / kWidth;
    const float shadow = isFloor(y) && x + y / 2 < 60 ? 0.3f : 1.0f;
    return gradient * shadow * (0.6f + 0.4f * normal.y + 0.2f * normal.z);
}

/// As after so many passes, each of which scatters by its own mean, like a sum of few bright paths.
KnownPicture knownPicture(int passes, unsigned seed) {
    KnownPicture out{.input = {.width = kWidth, .height = kHeight}, .truth = {}};
    std::mt19937 random(seed);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            addHit(x, y, &out.input);
            const bool isHit = out.input.depth.back() > 0.0f;
            out.truth.push_back(isHit ? out.input.albedo.back() * lightAt(x, y, out.input.normal.back())
                                      : Vec3(0.25f));
            std::gamma_distribution<float> factor(1.0f, 1.0f);
            double mean = 0.0, squares = 0.0;
            for (int pass = 0; pass < passes; ++pass) {
                const double value = static_cast<double>(factor(random));
                mean += value / passes;
                squares += value * value / passes;
            }
            const auto light = static_cast<double>(luminance(out.truth.back()));
            const double variance =
                passes > 1 ? (squares - mean * mean) / (passes - 1) : std::numeric_limits<double>::infinity();
            out.input.radiance.push_back(out.truth.back() * static_cast<float>(mean));
            out.input.variance.push_back(static_cast<float>(variance * light * light));
        }
    }
    return out;
}

double relMse(const std::vector<Vec3>& image, const std::vector<Vec3>& truth) {
    double sum = 0.0;
    for (size_t i = 0; i < truth.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const auto miss = static_cast<double>(image[i][c] - truth[i][c]);
            const auto right = static_cast<double>(truth[i][c]);
            sum += miss * miss / (right * right + 0.01);
        }
    }
    return sum / static_cast<double>(3 * truth.size());
}

double meanSquare(const std::vector<float>& values) {
    double sum = 0.0;
    for (const float value : values) {
        sum += static_cast<double>(value) * static_cast<double>(value);
    }
    return sum / static_cast<double>(values.size());
}

double luminanceMse(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    std::vector<float> misses;
    for (size_t i = 0; i < a.size(); ++i) {
        misses.push_back(luminance(a[i] - b[i]));
    }
    return meanSquare(misses);
}

TEST(Denoise, ErrorFallsAndTheCarefulFilterIsTheBetterOne) {
    for (const int passes : {4, 16, 64}) {
        const KnownPicture known = knownPicture(passes, 1);
        const double before = relMse(known.input.radiance, known.truth);
        const double quick = relMse(denoiseQuickly(known.input).radiance, known.truth);
        const double careful = relMse(denoise(known.input).radiance, known.truth);
        EXPECT_LT(quick, before / 4.0) << passes;
        EXPECT_LT(careful, before / 8.0) << passes;
        EXPECT_LT(careful, quick) << passes;
        RecordProperty("gain_" + std::to_string(passes), std::to_string(before / careful));
    }
}

/// No error of the picture is understated, and what is stated is of use: within three times the true one.
TEST(Denoise, StatedErrorIsNoLessThanTheTrueOne) {
    for (const int passes : {4, 16, 64}) {
        const KnownPicture known = knownPicture(passes, 2);
        for (const DenoisedImage& image : {denoiseQuickly(known.input), denoise(known.input)}) {
            const double stated = std::sqrt(meanSquare(image.error));
            const double found = std::sqrt(luminanceMse(image.radiance, known.truth));
            EXPECT_LT(found, stated) << passes;
            EXPECT_GT(found, stated / 3.0) << passes;
            EXPECT_LT(stated, std::sqrt(luminanceMse(known.input.radiance, known.truth))) << passes;
        }
    }
}

/// How much of the floor's pattern is left: the regression of the picture on the truth's differences from
/// square to square.
double patternShare(const std::vector<Vec3>& image, const std::vector<Vec3>& truth) {
    double products = 0.0, squares = 0.0;
    for (int y = kHorizon + 8; y + 3 < kHeight; ++y) {
        for (int x = 0; x + 3 < kWidth; ++x) {
            const auto right = static_cast<double>(luminance(truth[at(x + 3, y)] - truth[at(x, y)]));
            products += right * static_cast<double>(luminance(image[at(x + 3, y)] - image[at(x, y)]));
            squares += right * right;
        }
    }
    return products / squares;
}

TEST(Denoise, TextureAndShadowStayAsSharpAsTheyWere) {
    const KnownPicture known = knownPicture(16, 3);
    for (const DenoisedImage& image : {denoiseQuickly(known.input), denoise(known.input)}) {
        EXPECT_NEAR(patternShare(image.radiance, known.truth), 1.0, 0.02);
    }
    // Without what the camera sees of the pattern, it is in the picture alone.
    KnownPicture hidden = knownPicture(1024, 4);
    std::ranges::fill(hidden.input.albedo, Vec3(0.5f));
    EXPECT_NEAR(patternShare(denoise(hidden.input).radiance, hidden.truth), 1.0, 0.02);
    EXPECT_NEAR(patternShare(denoiseQuickly(hidden.input).radiance, hidden.truth), 1.0, 0.02);
}

TEST(Denoise, WhatHasConvergedStaysWithinItsStandardError) {
    const KnownPicture known = knownPicture(16, 5);
    DenoiseInput input = known.input;
    input.radiance = known.truth;
    for (size_t i = 0; i < input.radiance.size(); ++i) {
        // A pattern that no feature tells of and every filter would take for noise.
        input.radiance[i] *= i * 2654435761u % 97 < 48 ? 0.9f : 1.1f;
        input.variance[i] = square(1e-3f * luminance(input.radiance[i]));
    }
    for (const DenoisedImage& image : {denoiseQuickly(input), denoise(input)}) {
        double relative = 0.0;
        for (size_t i = 0; i < input.radiance.size(); ++i) {
            const float miss = luminance(image.radiance[i] - input.radiance[i]);
            relative += static_cast<double>(square(miss) / input.variance[i]);
        }
        EXPECT_LT(relative / static_cast<double>(input.radiance.size()), 1.0);
    }
}

TEST(Denoise, NothingUnknownOrEmptyMakesItsOutputInfinite) {
    std::vector<DenoiseInput> inputs{knownPicture(1, 6).input, knownPicture(16, 7).input};
    inputs[1].variance.assign(inputs[1].variance.size(), 0.0f);
    for (const float value : {0.0f, 1e-20f, 3e15f}) {
        DenoiseInput flat = knownPicture(4, 8).input;
        std::ranges::fill(flat.radiance, Vec3(value));
        std::ranges::fill(flat.variance, square(value));
        flat.normal[5] = flat.albedo[5] = Vec3(0.0f);
        flat.depth[6] = 1e-30f;
        flat.depth[7] = INFINITY;
        inputs.push_back(flat);
    }
    for (const int side : {0, 1, 2}) {
        const auto pixels = static_cast<size_t>(side * side);
        inputs.push_back({side, side, std::vector<Vec3>(pixels, Vec3(1.0f)), std::vector<float>(pixels, 0.1f),
                          std::vector<Vec3>(pixels, Vec3(0.5f)),
                          std::vector<Vec3>(pixels, Vec3(0.0f, 0.0f, 1.0f)),
                          std::vector<float>(pixels, 2.0f)});
    }
    for (size_t i = 0; i < inputs.size(); ++i) {
        for (const DenoisedImage& image : {denoiseQuickly(inputs[i]), denoise(inputs[i])}) {
            ASSERT_EQ(image.radiance.size(), inputs[i].radiance.size());
            for (size_t p = 0; p < image.radiance.size(); ++p) {
                const Vec3& color = image.radiance[p];
                ASSERT_TRUE(std::isfinite(color.x) && std::isfinite(color.y) && std::isfinite(color.z)) << i;
                ASSERT_GE(std::min({color.x, color.y, color.z}), 0.0f) << i;
                ASSERT_TRUE(std::isfinite(image.error[p])) << i;
            }
        }
    }
}

TEST(Denoise, SparksGoAway) {
    KnownPicture known = knownPicture(64, 9);
    const size_t spark = at(70, 80);
    known.input.radiance[spark] += Vec3(40.0f);
    known.input.variance[spark] += square(40.0f);
    const std::vector<Vec3> out = denoise(known.input).radiance;
    EXPECT_LT(luminance(out[spark] - known.truth[spark]), 2.0f) << "40 without";
}

/// One bright sample of a colour that luminance hardly knows: spread over its neighbourhood, it would be a
/// patch of that colour.
TEST(Denoise, SparksLeaveNoPatchOfTheirColor) {
    KnownPicture known = knownPicture(64, 9);
    const size_t spark = at(70, 80);
    const Vec3 blue(0.0f, 0.0f, 60.0f);
    known.input.radiance[spark] += blue;
    known.input.variance[spark] += square(luminance(blue));
    for (const DenoisedImage& out : {denoise(known.input), denoiseQuickly(known.input)}) {
        for (int y = 74; y <= 86; ++y) {
            for (int x = 64; x <= 76; ++x) {
                EXPECT_NEAR(out.radiance[at(x, y)].z, known.truth[at(x, y)].z, 0.5f) << x << ' ' << y;
            }
        }
    }
}

/// What is bright and certain is no spark, however small it is.
TEST(Denoise, SmallLightsStay) {
    KnownPicture known = knownPicture(64, 9);
    const size_t light = at(70, 80);
    known.input.radiance[light] = Vec3(40.0f);
    known.input.variance[light] = square(0.5f);
    EXPECT_NEAR(luminance(denoise(known.input).radiance[light]), 40.0f, 1.0f);
}

TEST(Denoise, IsTheSameForEveryNumberOfThreadsAndStopsWhenAsked) {
    const DenoiseInput input = knownPicture(8, 10).input;
    const DenoisedImage one = denoise(input, 1), quick = denoiseQuickly(input, 1);
    for (const int threads : {2, 3, 7}) {
        const DenoisedImage more = denoise(input, threads);
        EXPECT_EQ(more.radiance, one.radiance) << threads;
        EXPECT_EQ(more.error, one.error) << threads;
        EXPECT_EQ(denoiseQuickly(input, threads).radiance, quick.radiance) << threads;
    }
    const std::atomic<bool> stop{true};
    EXPECT_TRUE(denoise(input, 2, &stop).radiance.empty());
}

}  // namespace
}  // namespace glint
