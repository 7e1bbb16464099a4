// Sessions on the CUDA back end leave what they leave on the CPU. See cuda_sppm_test.cpp.
#include <gtest/gtest.h>

#if GLINT_HAS_CUDA

#include "engine/render/checkpoint.h"
#include "engine/render/render_session.h"
#include "tests/support/host_cuda.h"
#include "tests/support/photon_passes.h"
#include "tests/support/session_render.h"
#include "tests/support/sppm_scenes.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::differingPixels;
using test::glassBox;
using test::HostCuda;

TEST(CudaSession, ASessionResumedFromACheckpointEqualsTheCpusWithoutABreak) {
    SceneDescription scene = glassBox();
    scene.options.integrator = IntegratorKind::Sppm;
    const SessionCapture whole = test::renderSession(makeCpuBackend(2), scene, 4, 2);
    const test::TempFolder folder;
    const std::string path = folder.path("half.checkpoint");
    HostCuda first;
    ASSERT_TRUE(saveCheckpoint(path, test::renderSession(std::move(first.backend), scene, 2, 2)));
    Result<ResumePoint> loaded = loadCheckpoint(path, scene);
    ASSERT_TRUE(loaded) << loaded.error().format();
    HostCuda second;
    const SessionCapture resumed =
        test::renderSession(std::move(second.backend), scene, 4, 2, std::move(*loaded));
    EXPECT_EQ(test::photonsOf(resumed).passes, 4u);
    EXPECT_EQ(differingPixels(test::photonsOf(resumed), test::photonsOf(whole)), 0u);
    for (size_t i = 0; i < whole.film.pixels().size(); ++i) {
        ASSERT_EQ(resumed.film.pixels()[i].mean, whole.film.pixels()[i].mean) << i;
    }
}

TEST(CudaSession, ASwitchOfIntegratorsAndBackLosesNothing) {
    SceneDescription scene = glassBox();
    scene.options.integrator = IntegratorKind::Sppm;
    const SessionCapture whole = test::renderSession(makeCpuBackend(2), scene, 4, 2);
    HostCuda cuda;
    RenderSession session(std::move(cuda.backend), {.previews = false, .snapshots = false, .threads = 2});
    const auto renderTo = [&](IntegratorKind integrator, uint32_t passes, EditKind kinds) {
        scene.options.integrator = integrator;
        session.request({.limits = {.passes = passes}});
        session.post({std::make_shared<SceneDescription>(scene), kinds});
        ASSERT_EQ(session.wait(300.0), SessionState::Finished) << session.status().error;
    };
    renderTo(IntegratorKind::Sppm, 2, EditKind::Everything);
    renderTo(IntegratorKind::PathTracing, 3, EditKind::Integrator);
    renderTo(IntegratorKind::Sppm, 4, EditKind::Integrator);
    const auto capture = session.capture();
    ASSERT_TRUE(capture);
    EXPECT_EQ(test::photonsOf(*capture).passes, 4u);
    EXPECT_EQ(differingPixels(test::photonsOf(*capture), test::photonsOf(whole)), 0u);
}

}  // namespace
}  // namespace glint

#else
TEST(CudaSession, NotBuilt) { GTEST_SKIP() << "this build has no CUDA back end (GLINT_CUDA)"; }
#endif
