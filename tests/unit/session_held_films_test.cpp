// Going back to a scene whose film a session still holds, with a fake backend.
#include <cstring>

#include <gtest/gtest.h>

#include "tests/support/session_bench.h"

namespace glint {
namespace {

using namespace test;

/// Holds films, and shows no previews: the fake's passes take no time.
struct HoldingBench : SessionBench {
    explicit HoldingBench(size_t bytes = size_t{1} << 20) : SessionBench(false) {
        options.heldFilmBytes = bytes;
        session = std::make_unique<RenderSession>(makeFakeBackend(control), options);
        limit({.passes = 1});
    }
    void renderTo(uint32_t passes) {
        limit({.passes = passes});
        ASSERT_EQ(session->wait(kPatience), SessionState::Finished);
        ASSERT_EQ(session->status().passes, passes);
    }
};

std::shared_ptr<const SceneDescription> moved(const SceneDescription& scene, float x) {
    SceneDescription other = scene;
    other.camera.position.x = x;
    return std::make_shared<const SceneDescription>(other);
}

void expectSameBits(const Film& a, const Film& b) {
    ASSERT_EQ(a.passes(), b.passes());
    ASSERT_EQ(a.pixels().size(), b.pixels().size());
    for (size_t i = 0; i < a.pixels().size(); ++i) {
        EXPECT_EQ(std::memcmp(a.pixels()[i].mean.data(), b.pixels()[i].mean.data(), 3 * sizeof(double)), 0);
        EXPECT_EQ(a.pixels()[i].luminanceM2, b.pixels()[i].luminanceM2);
    }
}

TEST(HeldFilms, GoingBackGoesOnBitForBit) {
    const auto scene = fakeScene(9, 7);
    HoldingBench straight;
    straight.session->post({scene, EditKind::Everything});
    straight.renderTo(12);

    HoldingBench bench;
    bench.session->post({scene, EditKind::Everything});
    bench.renderTo(5);
    const auto shown = bench.session->snapshot();
    bench.limit({.passes = 3});
    bench.session->post({moved(*scene, 1.0f), EditKind::Camera});
    bench.renderTo(3);
    // What differs is found by content: the user may have typed the old value.
    bench.session->post({moved(*scene, scene->camera.position.x), EditKind::Camera});
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    EXPECT_EQ(bench.session->status().passes, 5u) << "its film is there at once";
    EXPECT_EQ(bench.session->snapshot()->radiance, shown->radiance);
    EXPECT_FALSE(bench.session->convergenceCurve(IntegratorKind::PathTracing)->empty());
    bench.renderTo(12);
    expectSameBits(bench.session->capture()->film, straight.session->capture()->film);
    // The limit comes first, or passes are rendered before it is known.
    bench.limit({.passes = 3});
    bench.session->post({moved(*scene, 1.0f), EditKind::Camera});
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    EXPECT_EQ(bench.session->status().passes, 3u) << "and forward again";
    EXPECT_EQ(bench.session->status().counters.filmRestarts, 2u);
}

TEST(HeldFilms, ATakeIsAFilmOfItsOwn) {
    const auto scene = fakeScene(8, 8);
    HoldingBench bench;
    bench.session->post({scene, EditKind::Everything}, 1);
    bench.renderTo(6);
    bench.limit({.passes = 2});
    bench.session->post({scene, EditKind::None}, 2);
    bench.renderTo(2);
    bench.session->post({scene, EditKind::None}, 1);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    EXPECT_EQ(bench.session->status().passes, 6u);
}

TEST(HeldFilms, EachIntegratorHasItsOwn) {
    const auto scene = fakeScene(8, 8);
    SceneDescription other = *scene;
    other.sppm.alpha = 0.5f;
    HoldingBench bench;
    bench.session->post({scene, EditKind::Everything});
    bench.renderTo(4);
    // It leaves the film of path tracing as it is, which is of both scenes then.
    bench.session->post({std::make_shared<const SceneDescription>(other), EditKind::SppmParameters});
    bench.renderTo(5);
    bench.session->post({moved(other, 1.0f), EditKind::Camera});
    bench.renderTo(6);
    bench.session->post({scene, EditKind::Camera | EditKind::SppmParameters});
    bench.renderTo(7);
    const auto begun = bench.control->begunPasses();
    EXPECT_EQ(begun.back().pass, 6u) << "it went on from the five passes";
}

TEST(HeldFilms, WithoutRoomItBeginsAnew) {
    const auto scene = fakeScene(64, 64);
    HoldingBench bench(Film::bytesFor(64, 64) / 2);
    bench.session->post({scene, EditKind::Everything});
    bench.renderTo(3);
    bench.session->post({moved(*scene, 1.0f), EditKind::Camera});
    bench.renderTo(2);
    bench.session->post({scene, EditKind::Camera});
    bench.renderTo(1);
    EXPECT_EQ(bench.session->status().counters.filmRestarts, 3u);
}

TEST(HeldFilms, ADragLeavesNoFilms) {
    const auto scene = fakeScene(8, 8);
    HoldingBench bench;
    bench.session->post({scene, EditKind::Everything});
    bench.renderTo(4);
    bench.ask(&RenderRequest::interacting, true);
    for (int step = 1; step <= 3; ++step) {
        bench.session->post({moved(*scene, static_cast<float>(step)), EditKind::Camera});
        ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    }
    bench.ask(&RenderRequest::interacting, false);
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    const uint64_t restarts = bench.session->status().counters.filmRestarts;
    bench.session->post({moved(*scene, 2.0f), EditKind::Camera});
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    EXPECT_EQ(bench.session->status().counters.filmRestarts, restarts + 1) << "of the midst of the drag";
    bench.session->post({scene, EditKind::Camera});
    ASSERT_EQ(bench.session->wait(kPatience), SessionState::Finished);
    EXPECT_EQ(bench.session->status().counters.filmRestarts, restarts + 1) << "of before the drag";
}

}  // namespace
}  // namespace glint
