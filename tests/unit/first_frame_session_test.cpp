// When a session shows a first frame, and that the picture after it is as without.
#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include "engine/builders/scene_builder.h"
#include "tests/support/session_bench.h"
#include "tests/support/test_scenes.h"
#include "tests/support/torus_mesh.h"

namespace glint {
namespace {

using namespace test;

SceneEdit openingOf(const SceneDescription& scene) {
    return {std::make_shared<SceneDescription>(scene), EditKind::Everything};
}

/// A session whose structures are not built before `mayBuild`.
struct HeldSession {
    std::atomic<bool> mayBuild{false};
    std::atomic<int> builds{0}, givenUp{0};
    std::unique_ptr<RenderSession> session;

    explicit HeldSession(bool previews) {
        SessionOptions options;
        options.previews = previews;
        options.heavyTriangles = 1;
        options.build = [this](const SceneEdit& edit, const BuiltScene* previous, int threads,
                               const std::atomic<bool>* stop, BuildReport* report) {
            ++builds;
            while (!mayBuild && !*stop) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            givenUp += *stop;
            return buildScene(edit, previous, threads, stop, report);
        };
        session = std::make_unique<RenderSession>(makeCpuBackend(2), options);
        session->request({.limits = {.passes = 4}});
    }
};

TEST(FirstFrame, IsShownWhileTheSceneIsBuilt) {
    HeldSession held(true);
    SceneDescription scene = meshInstances();
    scene.resolution = {160, 96};
    scene.options.integrator = IntegratorKind::Sppm;
    const EditTicket ticket = held.session->post(openingOf(scene));
    ASSERT_TRUE(SessionBench::waitFor([&] { return held.builds > 0; }));
    const auto frame = held.session->snapshot();
    ASSERT_TRUE(frame);
    EXPECT_TRUE(frame->isFirstFrame);
    EXPECT_EQ(frame->ticket, ticket);
    EXPECT_EQ(frame->width, 80);
    EXPECT_EQ(frame->previewScale, 2) << "not taken for the answer";
    EXPECT_EQ(held.session->status().state, SessionState::Building);
    EXPECT_EQ(held.session->status().integrator, IntegratorKind::Sppm) << "the one to come";
    double least = kInfinity, most = 0.0;
    for (const float value : frame->radiance) {
        least = std::min(least, double{value});
        most = std::max(most, double{value});
    }
    EXPECT_LT(least, most) << "there is something to be seen";
    held.mayBuild = true;
    ASSERT_EQ(held.session->wait(kPatience), SessionState::Finished);
    EXPECT_FALSE(held.session->snapshot()->isFirstFrame);
    EXPECT_EQ(held.session->snapshot()->previewScale, 1);
}

TEST(FirstFrame, ChangesNoBitOfThePicture) {
    SceneDescription scene = meshInstances();
    HeldSession held(true);
    held.mayBuild = true;
    held.session->post(openingOf(scene));
    RenderSession plain(makeCpuBackend(2), {});
    plain.request({.limits = {.passes = 4}});
    plain.post(openingOf(scene));
    ASSERT_EQ(held.session->wait(kPatience), SessionState::Finished);
    ASSERT_EQ(plain.wait(kPatience), SessionState::Finished);
    EXPECT_EQ(held.session->snapshot()->radiance, plain.snapshot()->radiance);
    EXPECT_EQ(held.session->status().counters.meshBuilds, plain.status().counters.meshBuilds);
}

TEST(FirstFrame, BatchesDoWithoutIt) {
    HeldSession held(false);
    held.session->post(openingOf(meshInstances()));
    ASSERT_TRUE(SessionBench::waitFor([&] { return held.builds > 0; }));
    EXPECT_FALSE(held.session->snapshot());
    held.mayBuild = true;
    EXPECT_EQ(held.session->wait(kPatience), SessionState::Finished);
}

TEST(FirstFrame, AnEditLeavesThePictureThatThereIs) {
    HeldSession held(true);
    held.mayBuild = true;
    SceneDescription scene = meshInstances();
    held.session->post(openingOf(scene));
    ASSERT_EQ(held.session->wait(kPatience), SessionState::Finished);
    held.mayBuild = false;
    scene.meshes[0].data = std::make_shared<const MeshData>(torus());
    held.session->post({std::make_shared<SceneDescription>(scene), EditKind::Accelerator});
    ASSERT_TRUE(SessionBench::waitFor([&] { return held.builds > 1; }));
    EXPECT_FALSE(held.session->snapshot()->isFirstFrame);
    EXPECT_TRUE(held.session->builtScene());
    held.mayBuild = true;
    EXPECT_EQ(held.session->wait(kPatience), SessionState::Finished);
}

TEST(FirstFrame, IsGivenUpForAnotherScene) {
    HeldSession held(true);
    held.session->post(openingOf(meshInstances()));
    ASSERT_TRUE(SessionBench::waitFor([&] { return held.builds > 0; }));
    SceneDescription second = meshInstances();
    second.resolution = {48, 32};
    const EditTicket ticket = held.session->post(openingOf(second));
    ASSERT_TRUE(SessionBench::waitFor([&] { return held.builds > 1; }));
    EXPECT_EQ(held.givenUp, 1);
    EXPECT_EQ(held.session->snapshot()->ticket, ticket);
    EXPECT_EQ(held.session->snapshot()->width, 24);
    EXPECT_FALSE(held.session->builtScene()) << "which is not what is seen";
    held.mayBuild = true;
    ASSERT_EQ(held.session->wait(kPatience), SessionState::Finished);
    EXPECT_EQ(held.session->snapshot()->width, 48);
}

}  // namespace
}  // namespace glint
