// SPPM goes on from a checkpoint as if nothing had happened, whatever the number of threads, and its settings
// guard its checkpoints.
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/render/checkpoint.h"
#include "engine/render/error_estimate.h"
#include "engine/render/snapshot.h"
#include "tests/support/session_render.h"
#include "tests/support/sppm_scenes.h"
#include "tests/support/temp_folder.h"
#include "tests/support/test_scenes.h"

namespace glint::test {
namespace {

using testing::HasSubstr;

SceneDescription photonScene(PhotonLookupKind lookup = PhotonLookupKind::Grid) {
    SceneDescription scene = glassBox();
    scene.options.integrator = IntegratorKind::Sppm;
    scene.sppm.lookup = lookup;
    return scene;
}

/// The capture at `passes`, from the start or from a checkpoint.
SessionCapture renderTo(uint32_t passes, const SceneDescription& scene, int threads,
                        std::optional<ResumePoint> from = {}) {
    return renderSession(makeCpuBackend(threads), scene, passes, threads, std::move(from));
}

bool sameBits(const SppmPixel& a, const SppmPixel& b) {
    return std::memcmp(&a.radiusSquared, &b.radiusSquared, sizeof a.radiusSquared) == 0 &&
           std::memcmp(&a.photonCount, &b.photonCount, sizeof a.photonCount) == 0 &&
           std::memcmp(a.flux, b.flux, sizeof a.flux) == 0 &&
           std::memcmp(&a.bias, &b.bias, sizeof a.bias) == 0 &&
           std::memcmp(&a.passM2, &b.passM2, sizeof a.passM2) == 0;
}

void expectSame(const SessionCapture& a, const SessionCapture& b) {
    const SppmState& ofA = photonsOf(a);
    const SppmState& ofB = photonsOf(b);
    EXPECT_EQ(a.film.passes(), b.film.passes());
    EXPECT_EQ(ofA.passes, ofB.passes);
    EXPECT_EQ(ofA.emittedPhotons, ofB.emittedPhotons);
    ASSERT_EQ(a.film.pixels().size(), b.film.pixels().size());
    ASSERT_EQ(ofA.pixels.size(), ofB.pixels.size());
    size_t different = 0;
    for (size_t i = 0; i < ofA.pixels.size(); ++i) {
        const FilmPixel& p = a.film.pixels()[i];
        const FilmPixel& q = b.film.pixels()[i];
        const bool same = std::memcmp(p.mean.data(), q.mean.data(), sizeof p.mean) == 0 &&
                          std::memcmp(&p.luminanceM2, &q.luminanceM2, sizeof p.luminanceM2) == 0 &&
                          p.count == q.count && p.halfSampleMean == q.halfSampleMean &&
                          sameBits(ofA.pixels[i], ofB.pixels[i]);
        different += same ? 0 : 1;
    }
    EXPECT_EQ(different, 0u);
    EXPECT_EQ(a.film.calibration().passes, b.film.calibration().passes);
    EXPECT_EQ(a.film.calibration().factors, b.film.calibration().factors);
    EXPECT_EQ(a.film.calibration().correlatedPixels, b.film.calibration().correlatedPixels);
    ASSERT_EQ(a.curve.points().size(), b.curve.points().size());
    for (size_t i = 0; i < a.curve.points().size(); ++i) {
        EXPECT_EQ(a.curve.points()[i].passes, b.curve.points()[i].passes);
        EXPECT_EQ(a.curve.points()[i].relativeError, b.curve.points()[i].relativeError);
        EXPECT_EQ(a.curve.points()[i].relativeErrorHigh, b.curve.points()[i].relativeErrorHigh);
        EXPECT_EQ(a.curve.points()[i].relativeBias, b.curve.points()[i].relativeBias);
    }
}

TEST(SppmResume, SixPassesAreThreeAndThreeMoreToTheLastBit) {
    for (const PhotonLookupKind lookup : {PhotonLookupKind::Grid, PhotonLookupKind::Tree}) {
        const SceneDescription scene = photonScene(lookup);
        const SessionCapture whole = renderTo(6, scene, 2);
        EXPECT_EQ(photonsOf(whole).passes, 6u);
        EXPECT_EQ(whole.curve.points().size(), 5u);
        EXPECT_EQ(whole.film.calibration().passes, 4u);
        for (const int threads : {1, 2}) {
            const TempFolder folder;
            const std::string path = folder.path("half.checkpoint");
            const SessionCapture half = renderTo(3, scene, threads);
            ASSERT_TRUE(saveCheckpoint(path, half));
            Result<ResumePoint> loaded = loadCheckpoint(path, scene);
            ASSERT_TRUE(loaded) << loaded.error().format();
            expectSame(SessionCapture{.scene = half.scene,
                                      .film = loaded->film,
                                      .statistics = loaded->statistics->clone(),
                                      .curve = loaded->curve},
                       half);
            expectSame(renderTo(6, scene, threads, std::move(*loaded)), whole);
        }
    }
}

TEST(SppmResume, OtherSettingsAreNamedOnlyWhereTheyMatter) {
    const TempFolder folder;
    const std::string path = folder.path("a.checkpoint");
    ASSERT_TRUE(saveCheckpoint(path, renderTo(1, photonScene(), 2)));
    const auto refusal = [&](auto edit) {
        SceneDescription scene = photonScene();
        edit(scene);
        const auto loaded = loadCheckpoint(path, scene);
        return loaded ? std::string("accepted") : loaded.error().format();
    };
    using S = SceneDescription&;
    EXPECT_EQ(refusal([](S) {}), "accepted");
    EXPECT_THAT(refusal([](S s) { s.sppm.alpha = 0.5f; }),
                HasSubstr("alpha is 0.6666667 in the checkpoint and 0.5 now"));
    EXPECT_THAT(refusal([](S s) { s.sppm.photonsPerPass = 7; }),
                HasSubstr("photonsPerPass is 3000 in the checkpoint and 7 now"));
    EXPECT_THAT(refusal([](S s) { s.sppm.radiusWorld = 0.5f; }), HasSubstr("radius is 0"));
    EXPECT_THAT(refusal([](S s) { s.sppm.radiusFootprints = 9.0f; }), HasSubstr("radiusFootprints is 4"));
    EXPECT_THAT(refusal([](S s) { s.sppm.storeRoughness = 0.5f; }), HasSubstr("storeRoughness is 0.1"));
    EXPECT_THAT(refusal([](S s) { s.sppm.sampleDirectLight = false; }),
                HasSubstr("directLight is sampled in the checkpoint and photons now"));
    EXPECT_THAT(refusal([](S s) { s.sppm.lookup = PhotonLookupKind::Tree; }), HasSubstr("lookup is grid"));
    EXPECT_THAT(refusal([](S s) { s.sppm.memoryBudgetMiB = 3; }), HasSubstr("memoryBudgetMiB is 1024"));
    EXPECT_THAT(refusal([](S s) { s.options.integrator = IntegratorKind::PathTracing; }),
                HasSubstr("integrator is sppm in the checkpoint and path now"));

    SceneDescription paths = photonScene();
    paths.options.integrator = IntegratorKind::PathTracing;
    ASSERT_TRUE(saveCheckpoint(path, renderTo(1, paths, 2)));
    paths.sppm.alpha = 0.5f;  // means nothing to the path tracer
    EXPECT_TRUE(loadCheckpoint(path, paths));
}

TEST(SppmResume, ACheckpointWithoutItsStatisticsIsRefused) {
    const TempFolder folder;
    const std::string path = folder.path("a.checkpoint");
    SessionCapture capture = renderTo(2, photonScene(), 2);
    const auto photons = std::make_shared<SppmState>(photonsOf(capture));
    capture.statistics = photons;
    photons->passes = 1;  // the film says 2
    ASSERT_TRUE(saveCheckpoint(path, capture));
    EXPECT_THAT(loadCheckpoint(path, photonScene()).error().format(),
                HasSubstr("its photon statistics cannot be read"));
    photons->passes = 2;
    photons->pixels[5].radiusSquared = std::numeric_limits<double>::infinity();
    ASSERT_TRUE(saveCheckpoint(path, capture));
    EXPECT_FALSE(loadCheckpoint(path, photonScene()));
    *photons = {};
    ASSERT_TRUE(saveCheckpoint(path, capture));
    EXPECT_FALSE(loadCheckpoint(path, photonScene()));
    capture.statistics = nullptr;
    ASSERT_TRUE(saveCheckpoint(path, capture));
    EXPECT_FALSE(loadCheckpoint(path, photonScene()));
}

/// From before the coverage of discs was counted: two numbers less a pixel.
TEST(SppmResume, OlderStatisticsGoOnWithoutCoverage) {
    const SessionCapture capture = renderTo(2, photonScene(), 2);
    const SppmState& whole = photonsOf(capture);
    ByteWriter out;
    whole.write(&out);
    constexpr size_t kHead = 20, kPixel = sizeof(SppmPixel), kOlderPixel = kPixel - 2 * sizeof(float);
    std::string older = out.bytes().substr(0, kHead);
    for (size_t i = 0; i < whole.pixels.size(); ++i) {
        older += out.bytes().substr(kHead + i * kPixel, kOlderPixel);
    }
    SppmState state;
    ASSERT_TRUE(state.read(ByteReader(older), capture.film));
    for (size_t i = 0; i < whole.pixels.size(); ++i) {
        EXPECT_EQ(std::memcmp(&state.pixels[i], &whole.pixels[i], kOlderPixel), 0);
        EXPECT_EQ(state.pixels[i].probes, 0.0f);
    }
    EXPECT_FALSE(state.read(ByteReader(older.substr(1)), capture.film));
    EXPECT_FALSE(state.read(ByteReader(older + "x"), capture.film));
}

TEST(SppmSnapshot, OfACaptureHasTheErrorOfBothParts) {
    const SessionCapture capture = renderTo(3, photonScene(), 2);
    const auto image = makeSnapshot(capture, {}, 1);
    EXPECT_EQ(image->integrator, IntegratorKind::Sppm);
    EXPECT_EQ(image->relativeError, estimateError(capture.film, capture.statistics.get()).relative);
    EXPECT_NE(image->relativeError, estimateError(capture.film, nullptr).relative);
    EXPECT_EQ(image->renderSeconds, capture.renderSeconds);
}

}  // namespace
}  // namespace glint::test
