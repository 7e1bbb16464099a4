// A session that renders both integrators in turn: what is shown of each, when, and when it stops. With a
// fake backend whose passes take as long as a test says.
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "engine/render/sppm_state.h"
#include "tests/support/fake_backend.h"

namespace glint {
namespace {

using namespace test;

constexpr double kPatience = 60.0;

struct AskingBench {
    std::shared_ptr<FakeControl> control = std::make_shared<FakeControl>();
    std::shared_ptr<SceneDescription> scene;
    RenderSession session;
    RenderRequest request;

    AskingBench(int side, bool previews)
        : scene(fakeScene(side, side)),
          session(makeFakeBackend(control), withPreviews(fakeOptions(control), previews)) {}

    static SessionOptions withPreviews(SessionOptions options, bool previews) {
        options.previews = previews;
        return options;
    }
    void post(EditKind kinds) { session.post({std::make_shared<SceneDescription>(*scene), kinds}); }
    /// Changes one thing of what is asked for.
    template <class Value>
    void ask(Value RenderRequest::*what, Value value) {
        request.*what = std::move(value);
        session.request(request);
    }
    void compare() { ask(&RenderRequest::compare, {IntegratorKind::PathTracing, IntegratorKind::Sppm}); }
    /// The newest picture of the integrator that is not shown.
    std::shared_ptr<const FilmSnapshot> otherSnapshot() const {
        const auto main = session.snapshot();
        if (!main) { return nullptr; }
        return session.snapshot(main->integrator == IntegratorKind::Sppm ? IntegratorKind::PathTracing
                                                                         : IntegratorKind::Sppm);
    }
};

struct Bench : AskingBench {
    Bench() : AskingBench(8, false) {}

    void choose(IntegratorKind kind) {
        scene->options.integrator = kind;
        post(EditKind::Integrator);
    }
    static bool waitFor(const std::function<bool()>& condition) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(kPatience);
        while (!condition()) {
            if (std::chrono::steady_clock::now() > end) { return false; }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return true;
    }
    /// Both have pictures, and a pass is in flight that never ends by itself.
    bool reachEndlessPass() {
        compare();
        post(EditKind::Everything);
        if (!waitFor([&] { return otherSnapshot() != nullptr; })) { return false; }
        control->secondsPerPass = 1e6;
        return waitFor([&] {
            const int passes = control->passes;
            std::this_thread::sleep_for(std::chrono::milliseconds(500));
            const int begun = static_cast<int>(control->begunPasses().size());
            return passes == control->passes && begun > control->passes + control->stopped;
        });
    }
};

TEST(ComparingSession, ASwitchShowsBothKeptImagesBeforeAnyFurtherPass) {
    Bench bench;
    ASSERT_TRUE(bench.reachEndlessPass());
    const int passes = bench.control->passes;
    bench.choose(IntegratorKind::Sppm);
    EXPECT_TRUE(Bench::waitFor([&] {
        const auto main = bench.session.snapshot();
        const auto other = bench.otherSnapshot();
        return main && other && main->integrator == IntegratorKind::Sppm &&
               other->integrator == IntegratorKind::PathTracing && other->ticket == main->ticket;
    }));
    EXPECT_TRUE(Bench::waitFor([&] {
        const SessionStatus status = bench.session.status();
        return status.integrator == IntegratorKind::Sppm && status.passes == bench.session.snapshot()->passes;
    })) << "its figures come with it";
    EXPECT_EQ(bench.control->passes, passes);
}

TEST(ComparingSession, TheOtherImageCarriesWhatIsAskedForToo) {
    Bench bench;
    bench.compare();
    bench.ask(&RenderRequest::limits, StopLimits{.passes = 3});
    bench.post(EditKind::Everything);
    ASSERT_EQ(bench.session.wait(kPatience), SessionState::Finished);
    ASSERT_NE(bench.otherSnapshot(), nullptr);
    EXPECT_TRUE(bench.otherSnapshot()->maps.empty());
    bench.ask(&RenderRequest::integratorMaps, true);
    bench.ask(&RenderRequest::aovs, uint32_t{kAovDepth});
    bench.ask(&RenderRequest::standardError, true);
    ASSERT_EQ(bench.session.wait(kPatience), SessionState::Finished);
    const auto other = bench.otherSnapshot();
    ASSERT_NE(other, nullptr);
    EXPECT_EQ(other->integrator, IntegratorKind::Sppm);
    EXPECT_EQ(other->map(kRadiusMap), std::vector<float>(64, 1.0f));
    EXPECT_EQ(other->map(kPhotonCountMap).size(), 64u);
    EXPECT_EQ(other->standardError.size(), 64u);
    ASSERT_NE(other->aovs, nullptr);
    EXPECT_EQ(other->aovs->passes(), kAovPasses);
    EXPECT_TRUE(bench.session.snapshot()->maps.empty()) << "path tracing has no photons";
}

TEST(ComparingSession, WhatTheImageLacksComesBeforeAnyFurtherPass) {
    Bench bench;
    ASSERT_TRUE(bench.reachEndlessPass());
    const int passes = bench.control->passes;
    bench.ask(&RenderRequest::integratorMaps, true);
    EXPECT_TRUE(Bench::waitFor([&] {
        const auto other = bench.otherSnapshot();
        return other && !other->maps.empty();
    }));
    bench.ask(&RenderRequest::standardError, true);
    EXPECT_TRUE(Bench::waitFor([&] { return !bench.session.snapshot()->standardError.empty(); }));
    EXPECT_EQ(bench.control->passes, passes);
}

TEST(ComparingSession, AFinishedImageIsComparedWithOneOfAsMuchTime) {
    Bench bench;
    bench.ask(&RenderRequest::limits, StopLimits{.passes = 4});
    bench.control->secondsPerPass = 0.002;
    bench.post(EditKind::Everything);
    ASSERT_EQ(bench.session.wait(kPatience), SessionState::Finished);
    EXPECT_EQ(bench.otherSnapshot(), nullptr);
    bench.compare();
    ASSERT_EQ(bench.session.wait(kPatience), SessionState::Finished);
    const auto main = bench.session.snapshot();
    const auto other = bench.otherSnapshot();
    ASSERT_NE(other, nullptr);
    EXPECT_EQ(main->passes, 4u) << "the limit holds for the one that is shown";
    EXPECT_GE(other->renderSeconds, main->renderSeconds);
}

TEST(ComparingSession, PausedBothShowOnePassAfterAnEdit) {
    Bench bench;
    bench.compare();
    bench.ask(&RenderRequest::paused, true);
    for (int edit = 0; edit < 2; ++edit) {
        bench.post(edit == 0 ? EditKind::Everything : EditKind::Camera);
        ASSERT_EQ(bench.session.wait(kPatience), SessionState::Paused);
        ASSERT_NE(bench.otherSnapshot(), nullptr);
        EXPECT_EQ(bench.otherSnapshot()->passes, 1u);
        EXPECT_EQ(bench.session.snapshot()->passes, 1u);
    }
}

/// With previews: a whole pass takes a fifth of a second.
struct PreviewBench : AskingBench {
    PreviewBench() : AskingBench(256, true) { control->secondsPerPath = 3e-6; }
    bool waitForOther(const std::function<bool(const FilmSnapshot&, const FilmSnapshot&)>& condition) {
        return Bench::waitFor([&] {
            const auto main = session.snapshot();
            const auto other = otherSnapshot();
            return main && other && main->ticket == session.status().ticket &&
                   other->ticket == main->ticket && condition(*main, *other);
        });
    }
};

TEST(ComparingSession, WhileTheCameraMovesBothSidesArePreviewed) {
    PreviewBench bench;
    bench.compare();
    bench.post(EditKind::Everything);
    EXPECT_TRUE(bench.waitForOther([](const FilmSnapshot& main, const FilmSnapshot& other) {
        return main.previewScale == 1 && other.previewScale == 1;
    }));
    for (int edit = 0; edit < 3; ++edit) {
        bench.ask(&RenderRequest::interacting, true);
        bench.post(EditKind::Camera);
        EXPECT_TRUE(bench.waitForOther([](const FilmSnapshot& main, const FilmSnapshot& other) {
            return other.previewScale > 1 && other.previewScale == main.previewScale &&
                   other.width == main.width && other.integrator != main.integrator;
        })) << edit;
    }
    bench.ask(&RenderRequest::interacting, false);
    EXPECT_TRUE(bench.waitForOther([](const FilmSnapshot& main, const FilmSnapshot& other) {
        return main.previewScale == 1 && other.previewScale == 1;
    }));
}

TEST(ComparingSession, AnEditOfThePhotonsKeepsThePathTracedImage) {
    for (const IntegratorKind shown : {IntegratorKind::PathTracing, IntegratorKind::Sppm}) {
        PreviewBench bench;
        bench.scene->options.integrator = shown;
        bench.compare();
        bench.post(EditKind::Everything);
        ASSERT_TRUE(bench.waitForOther([](const FilmSnapshot& main, const FilmSnapshot& other) {
            return main.previewScale == 1 && other.previewScale == 1;
        }));
        bench.ask(&RenderRequest::interacting, true);
        bench.scene->sppm.alpha = 0.6f;
        bench.post(EditKind::SppmParameters);
        EXPECT_TRUE(bench.waitForOther([&](const FilmSnapshot& main, const FilmSnapshot& other) {
            const bool isPath = main.integrator == IntegratorKind::PathTracing;
            const FilmSnapshot& path = isPath ? main : other;
            const FilmSnapshot& sppm = isPath ? other : main;
            return path.previewScale == 1 && path.passes > 0 && sppm.previewScale > 1;
        }));
    }
}

TEST(ComparingSession, SpeedIsThatOfTheIntegratorThatIsShown) {
    Bench bench;
    bench.compare();
    bench.ask(&RenderRequest::limits, StopLimits{.passes = 3});
    bench.post(EditKind::Everything);
    ASSERT_EQ(bench.session.wait(kPatience), SessionState::Finished);
    const double path = bench.session.status().passesPerSecond;
    EXPECT_GT(path, 0.0);
    EXPECT_DOUBLE_EQ(bench.session.status().pathsPerSecond, path * 64.0);
    EXPECT_DOUBLE_EQ(bench.session.status().raysPerSecond, path * 64.0 * 3.0);
    bench.control->secondsPerPass = 0.05;
    bench.choose(IntegratorKind::Sppm);
    bench.session.restart();
    ASSERT_EQ(bench.session.wait(kPatience), SessionState::Finished);
    EXPECT_GT(bench.session.status().passesPerSecond, 0.0);
    EXPECT_LE(bench.session.status().passesPerSecond, 20.0) << "no pass took less than 0.05 s";
}

}  // namespace
}  // namespace glint
