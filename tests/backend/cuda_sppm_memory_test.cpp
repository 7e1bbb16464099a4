// The memory of photon mapping on the CUDA back end: what it takes, gives back, and says when there is too
// little. Without a GPU, over device-like host memory.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#if GLINT_HAS_CUDA

#include "engine/render/pass_params.h"
#include "engine/render/path_pass.h"
#include "engine/render/photon_store.h"
#include "engine/render/sppm_integrator.h"
#include "engine/render/sppm_state.h"
#include "tests/support/host_cuda.h"
#include "tests/support/photon_passes.h"
#include "tests/support/sppm_scenes.h"
#include "tests/support/test_scenes.h"

namespace glint {
namespace {

using test::build;
using test::expectSame;
using test::HostCuda;
using test::Photons;
using test::renderOnCpu;
using test::renderPasses;
using testing::HasSubstr;

struct CudaSppmMemory : testing::Test {
    SceneDescription description = test::glassBox();
    HostCuda cuda;
    std::atomic<bool> stop{false};
    Photons photons{SppmState(200, 150)};
    SppmParams params;

    void SetUp() override {
        description.resolution = {200, 150};
        params = sppmParamsOf(description);
        ASSERT_TRUE(cuda.backend->setScene(build(description)));
        // The picture's own samples are the path tracer's business.
        std::vector<PixelSample> out;
        ASSERT_TRUE(renderPathPass(*cuda.backend, params.pass, stop, &out));
    }
    Result<bool> renderPass() {
        params.pass.pass = photons.state.passes;
        return renderSppmPass(*cuda.backend, params, stop, &photons.state, &photons.direct);
    }
};

TEST_F(CudaSppmMemory, PathTracingAloneTakesNothingForPhotons) {
    const size_t pixels = photons.state.pixels.size();
    HostCuda paths;
    ASSERT_TRUE(paths.backend->setScene(build(description)));
    const size_t scene = paths.control->taken();
    std::vector<PixelSample> out;
    ASSERT_TRUE(renderPathPass(*paths.backend, params.pass, stop, &out));
    EXPECT_EQ(paths.control->taken(), scene + pixels * sizeof(PixelSample));
}

TEST_F(CudaSppmMemory, HoldsWhatThePlanSays) {
    const size_t before = cuda.control->taken();
    ASSERT_TRUE(renderPass());
    const double room = 1.0;  // places a photon in the first pass, as on the CPU
    const SppmMemory plan = planSppmMemory(200, 150, params.photonsPerPass, room, 0);
    const size_t held = cuda.control->taken() - before;
    EXPECT_GE(held, plan.total());
    // The counters of emitted photons, the slices, working memory and the grid's tables.
    const size_t tables = size_t{4} * 2 * sizeof(GridSlot) * params.photonsPerPass;
    EXPECT_LE(held, plan.total() + 4 * params.photonsPerPass + 256 * 1024 + tables);
}

TEST_F(CudaSppmMemory, TooLittleIsAnErrorBeforeAnyIsTaken) {
    const size_t before = cuda.control->taken();
    const int allocations = cuda.control->allocations;
    cuda.control->memoryBytes = before + size_t{2} * 1024 * 1024;
    const auto done = renderPass();
    ASSERT_FALSE(done);
    EXPECT_THAT(done.error().message,
                HasSubstr("Photon mapping with 200x150 pixels and 3000 photons a pass needs"));
    EXPECT_THAT(done.error().message, HasSubstr("on host memory, but only 2.0 MiB are free there."));
    EXPECT_EQ(cuda.control->allocations, allocations);
    EXPECT_EQ(photons.state.passes, 0u);
    cuda.control->memoryBytes = size_t{1} << 30;
    ASSERT_TRUE(renderPass());
    expectSame(photons, renderOnCpu(build(description), params, 1));
}

/// Every allocation of a first pass, one after the other.
TEST_F(CudaSppmMemory, AFailedAllocationIsAnErrorAndTheNextPassMayWork) {
    int failures = 0;
    for (int failing = 0;; ++failing) {
        ASSERT_LT(failing, 100);
        HostCuda fresh;
        ASSERT_TRUE(fresh.backend->setScene(build(description)));
        Photons own{SppmState(200, 150)};
        params.pass.pass = 0;
        fresh.control->failAllocation = failing;
        const auto done = renderSppmPass(*fresh.backend, params, stop, &own.state, &own.direct);
        fresh.control->failAllocation = -1;
        if (done) { break; }
        ++failures;
        EXPECT_THAT(done.error().message, HasSubstr("the test device is in pieces"));
        EXPECT_EQ(own.state.passes, 0u);
        renderPasses(*fresh.backend, params, 1, &own);
        expectSame(own, renderOnCpu(build(description), params, 1));
    }
    EXPECT_GE(failures, 10);
}

TEST_F(CudaSppmMemory, ARetraceThatDoesNotFitIsAnErrorAndLessPhotonsWork) {
    const SceneDescription room = test::whiteRoom();
    const auto scene = build(room);
    params = sppmParamsOf(room);
    params.photonsPerPass = 100000;
    photons.state = SppmState(16, 16);
    ASSERT_TRUE(cuda.backend->setScene(scene));
    // Room for one place a photon, and not for the several that it is kept at.
    cuda.control->memoryBytes = cuda.control->taken() + size_t{8} * 1024 * 1024;
    const auto done = renderPass();
    ASSERT_FALSE(done);
    EXPECT_THAT(done.error().message, HasSubstr("100000 photons a pass needs"));
    EXPECT_EQ(photons.state.passes, 0u);
    params.photonsPerPass = 2000;
    ASSERT_TRUE(renderPass());
    expectSame(photons, renderOnCpu(scene, params, 1));
}

TEST_F(CudaSppmMemory, AGridThatDoesNotFitIsAnError) {
    // The first pass takes all but the tables.
    HostCuda probe;
    ASSERT_TRUE(probe.backend->setScene(build(description)));
    std::optional<size_t> beforeTables;
    probe.control->onLaunch = [&] {
        if (probe.control->lastStep == "count cells") { beforeTables = probe.control->taken(); }
    };
    Photons own{SppmState(200, 150)};
    renderPasses(*probe.backend, params, 1, &own);
    ASSERT_TRUE(beforeTables);
    ASSERT_GT(probe.control->taken(), *beforeTables + 100);
    cuda.control->memoryBytes = *beforeTables + 100;
    const auto done = renderPass();
    ASSERT_FALSE(done);
    EXPECT_THAT(done.error().message, HasSubstr("The photon grid needs"));
}

TEST_F(CudaSppmMemory, MorePhotonsThanAnyStoreHoldsIsAnErrorOnBoth) {
    params.photonsPerPass = PhotonStore::kMaxPhotons + 1;
    const auto cpu = makeCpuBackend(2);
    ASSERT_TRUE(cpu->setScene(build(description)));
    for (Backend* const backend : {cpu.get(), cuda.backend.get()}) {
        const auto done = renderSppmPass(*backend, params, stop, &photons.state, &photons.direct);
        ASSERT_FALSE(done) << backend->name();
        EXPECT_THAT(done.error().message, HasSubstr("fewer photons a pass"));
        EXPECT_EQ(photons.state.passes, 0u);
    }
}

TEST_F(CudaSppmMemory, ASceneThatNeedsTheMemoryGetsIt) {
    ASSERT_TRUE(renderPass());
    const auto meshes = build(test::meshInstances());
    HostCuda alone;
    ASSERT_TRUE(alone.backend->setScene(meshes));
    const size_t bytesOfImage = photons.state.pixels.size() * sizeof(PixelSample);
    cuda.control->memoryBytes = alone.control->taken() + bytesOfImage;
    EXPECT_TRUE(cuda.backend->setScene(meshes));
}

TEST_F(CudaSppmMemory, GivesAllMemoryBack) {
    ASSERT_TRUE(renderPass());
    EXPECT_GT(cuda.control->taken(), 0u);
    cuda.backend.reset();
    EXPECT_EQ(cuda.control->taken(), 0u);
}

}  // namespace
}  // namespace glint

#else
TEST(CudaSppmMemory, NotBuilt) { GTEST_SKIP() << "this build has no CUDA back end (GLINT_CUDA)"; }
#endif
