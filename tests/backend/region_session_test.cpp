// A session that goes on with a part of the picture alone.
#include <memory>

#include <gtest/gtest.h>

#include "engine/render/error_estimate.h"
#include "engine/render/render_session.h"
#include "tests/support/render_scene.h"
#include "tests/support/test_scenes.h"

namespace glint {
namespace {

using namespace test;

constexpr double kPatience = 300.0;
// Not on the tiles' grid.
constexpr FilmRegion kRegion{13, 21, 30, 37};

SceneDescription sceneOf(IntegratorKind integrator) {
    SceneDescription scene = cornellBox();
    scene.resolution = {64, 48};
    scene.options.integrator = integrator;
    return scene;
}

/// So many passes of the whole picture, then of the region up to `passes`, then of the whole up to `end`.
Film renderWithRegion(const SceneDescription& scene, uint32_t whole, uint32_t passes, uint32_t end,
                      SessionStatus* status = nullptr) {
    RenderSession session(makeCpuBackend(2), {.previews = false, .threads = 2});
    RenderRequest request{.limits = {.passes = whole}};
    session.request(request);
    session.post({std::make_shared<SceneDescription>(scene), EditKind::Everything});
    EXPECT_EQ(session.wait(kPatience), SessionState::Finished);
    request.region = kRegion;
    request.limits.passes = passes;
    session.request(request);
    EXPECT_EQ(session.wait(kPatience), SessionState::Finished);
    if (status != nullptr) { *status = session.status(); }
    request.region.reset();
    request.limits.passes = end;
    session.request(request);
    EXPECT_EQ(session.wait(kPatience), SessionState::Finished);
    return session.capture()->film;
}

bool isSame(const FilmPixel& a, const FilmPixel& b) {
    return a.mean == b.mean && a.luminanceM2 == b.luminanceM2 && a.count == b.count;
}

TEST(RegionSession, ThePixelsInItGetThePassesAndTheOthersStay) {
    const SceneDescription scene = sceneOf(IntegratorKind::PathTracing);
    SessionStatus status;
    const Film film = renderWithRegion(scene, 3, 11, 11, &status);
    const Film before = renderFilm(scene, 3);
    const Film all = renderFilm(scene, 11);
    EXPECT_EQ(film.passes(), 11u);
    for (int y = 0; y < film.height(); ++y) {
        for (int x = 0; x < film.width(); ++x) {
            const auto i = static_cast<size_t>(y * film.width() + x);
            const Film& like = kRegion.contains(x, y) ? all : before;
            ASSERT_TRUE(isSame(film.pixels()[i], like.pixels()[i])) << x << ", " << y;
        }
    }
    EXPECT_LT(film.rays(), before.rays() + (all.rays() - before.rays()) / 4) << "a tenth of the pixels";
    ASSERT_TRUE(status.region);
    EXPECT_EQ(*status.region, kRegion);
    EXPECT_EQ(status.relativeError, estimateError(film, nullptr, 0, &kRegion).relative);
    EXPECT_LT(status.relativeError, estimateError(film, nullptr).relative);
}

TEST(RegionSession, AfterwardsEveryPixelKnowsHowManySamplesItHas) {
    const SceneDescription scene = sceneOf(IntegratorKind::PathTracing);
    const Film film = renderWithRegion(scene, 2, 64, 80);
    // An unbiased picture whose standard errors hold: squared deviations from one that has many more samples
    // are what they say, inside and outside.
    SceneDescription other = scene;
    other.options.seed += 1;
    const Film reference = renderFilm(other, 512);
    for (const bool inside : {true, false}) {
        double said = 0.0;
        double found = 0.0;
        for (int y = 0; y < film.height(); ++y) {
            for (int x = 0; x < film.width(); ++x) {
                if (kRegion.contains(x, y) != inside) { continue; }
                const auto i = static_cast<size_t>(y * film.width() + x);
                ASSERT_EQ(film.pixels()[i].count, inside ? 80u : 18u);
                const double error = film.standardError(film.pixels()[i]);
                const double ownError = reference.standardError(reference.pixels()[i]);
                const double off = pixelLuminance(film, nullptr, i) - pixelLuminance(reference, nullptr, i);
                said += error * error + ownError * ownError;
                found += off * off;
            }
        }
        // Low-discrepancy passes err less than their variance says, never much more.
        EXPECT_LT(found, 1.5 * said) << inside;
        EXPECT_GT(found, 0.02 * said) << inside;
    }
}

TEST(RegionSession, ACalibrationComparesPixelsThatDoubledTheirSamplesOnly) {
    const SceneDescription scene = sceneOf(IntegratorKind::PathTracing);
    const Film part = renderWithRegion(scene, 4, 8, 8);
    const NoiseCalibration& calibration = part.calibration();
    ASSERT_EQ(calibration.passes, 8u);
    // Pixels that stood still would say that passes err a thousandth of what they do.
    for (const double factor : calibration.factors) {
        EXPECT_GT(factor, 0.01);
    }
}

TEST(RegionSession, PhotonsRenderTheWholePicture) {
    SceneDescription scene = sceneOf(IntegratorKind::Sppm);
    scene.sppm.photonsPerPass = 2000;
    SessionStatus status;
    const Film film = renderWithRegion(scene, 2, 4, 4, &status);
    EXPECT_FALSE(status.region);
    for (const FilmPixel& pixel : film.pixels()) {
        ASSERT_EQ(pixel.count, 4u);
    }
}

TEST(RegionSession, OutsideOfThePictureIsNoRegion) {
    EXPECT_FALSE(clipped({70, 10, 90, 20}, 64, 48));
    EXPECT_FALSE(clipped({5, 5, 5, 20}, 64, 48));
    EXPECT_EQ(clipped({-5, 40, 10, 90}, 64, 48), (FilmRegion{0, 40, 10, 48}));
}

}  // namespace
}  // namespace glint
