// SPPM on the CUDA back end without a GPU: the kernels that nvcc compiled, run on the host over device-like
// memory, must leave the CPU's statistics and direct light bit for bit, whatever the launches, and a pass
// that fails or stops must leave the statistics alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#if GLINT_HAS_CUDA

#include <cstring>

#include "cuda/sppm_variant.h"
#include "engine/render/pass_params.h"
#include "engine/render/photon_store.h"
#include "engine/render/sppm_integrator.h"
#include "tests/support/host_cuda.h"
#include "tests/support/photon_passes.h"
#include "tests/support/sppm_scenes.h"
#include "tests/support/test_scenes.h"
#include "tests/support/variant_tables.h"

namespace glint {
namespace {

using test::build;
using test::differingPixels;
using test::expectSame;
using test::glassBox;
using test::HostCuda;
using test::Photons;
using test::render;
using test::renderOnCpu;
using test::renderPasses;
using test::ThreadOrder;
using test::whiteRoom;
using testing::HasSubstr;

double photonCountOf(const SppmState& state) {
    double sum = 0.0;
    for (const SppmPixel& pixel : state.pixels) {
        sum += pixel.photonCount;
    }
    return sum;
}

class CudaSppmScenes : public testing::TestWithParam<test::NamedScene> {};

TEST_P(CudaSppmScenes, StatisticsEqualTheCpusBitForBit) {
    SceneDescription description = GetParam().scene;
    description.resolution = {37, 29};
    description.sppm.photonsPerPass = 2500;
    const auto scene = build(description);
    for (const bool sampleDirectLight : {true, false}) {
        description.sppm.sampleDirectLight = sampleDirectLight;
        const SppmParams params = sppmParamsOf(description);
        HostCuda cuda;
        ASSERT_TRUE(cuda.backend->setScene(scene));
        const Photons photons = render(*cuda.backend, params, 2);
        expectSame(photons, renderOnCpu(scene, params, 2));
        // Light that a convex white sphere scatters meets nothing any more.
        const bool lit =
            GetParam().name != "darkness" && !(GetParam().name == "whiteFurnace" && sampleDirectLight);
        if (lit) { EXPECT_GT(photonCountOf(photons.state), 0.0); }
    }
}

INSTANTIATE_TEST_SUITE_P(All, CudaSppmScenes, testing::ValuesIn(test::allTestScenes()),
                         [](const auto& scene) { return scene.param.name; });

struct Settings {
    const char* name;
    int width = 37;
    int height = 29;
    uint32_t photonsPerPass = 3000;
    float radiusWorld = 0.0f;
    float radiusFootprints = 4.0f;
    double alpha = 2.0 / 3.0;
    int maxDepth = 6;
};

class CudaSppmSettings : public testing::TestWithParam<Settings> {};

TEST_P(CudaSppmSettings, StatisticsEqualTheCpusBitForBit) {
    const Settings& settings = GetParam();
    SceneDescription description = glassBox();
    description.resolution = {settings.width, settings.height};
    const auto scene = build(description);
    SppmParams params = sppmParamsOf(description);
    params.photonsPerPass = settings.photonsPerPass;
    params.radiusWorld = settings.radiusWorld;
    params.radiusFootprints = settings.radiusFootprints;
    params.alpha = settings.alpha;
    params.pass.maxDepth = settings.maxDepth;
    HostCuda cuda;
    ASSERT_TRUE(cuda.backend->setScene(scene));
    expectSame(render(*cuda.backend, params, 3), renderOnCpu(scene, params, 3));
}

INSTANTIATE_TEST_SUITE_P(
    All, CudaSppmSettings,
    testing::Values(Settings{.name = "onePixel", .width = 1, .height = 1},
                    Settings{.name = "oneTile", .width = 8, .height = 4},
                    Settings{.name = "wide", .width = 200, .height = 3},
                    Settings{.name = "tall", .width = 3, .height = 200},
                    Settings{.name = "morePixelsThanSlices", .width = 128, .height = 96},
                    Settings{.name = "onePhoton", .photonsPerPass = 1},
                    Settings{.name = "manyLaunches", .photonsPerPass = 60001},
                    Settings{.name = "radiusLargerThanTheScene", .photonsPerPass = 200, .radiusWorld = 50.0f},
                    Settings{.name = "tinyRadius", .radiusWorld = 1e-4f},
                    Settings{.name = "wideFootprints", .radiusFootprints = 40.0f},
                    Settings{.name = "smallAlpha", .alpha = 0.1},
                    Settings{.name = "noScattering", .maxDepth = 1},
                    Settings{.name = "deep", .maxDepth = 30}),
    [](const auto& settings) { return std::string(settings.param.name); });

TEST(CudaSppm, TheOrderOfThreadsDoesNotMatter) {
    SceneDescription description = glassBox();
    description.resolution = {16, 12};
    const auto scene = build(description);
    SppmParams params = sppmParamsOf(description);
    // The box around all radii is so large that the scene's photons share a few of its finest cells, where
    // only their numbers decide their order.
    for (const float radiusWorld : {0.0f, 5000.0f}) {
        params.radiusWorld = radiusWorld;
        const Photons expected = renderOnCpu(scene, params, 2);
        for (const ThreadOrder order : {ThreadOrder::Forwards, ThreadOrder::Backwards, ThreadOrder::AtOnce}) {
            for (const bool sortIntoOther : {false, true}) {
                HostCuda cuda;
                cuda.control->order = order;
                cuda.control->sortIntoOther = sortIntoOther;
                ASSERT_TRUE(cuda.backend->setScene(scene));
                expectSame(render(*cuda.backend, params, 2), expected);
            }
        }
    }
}

TEST(CudaSppm, APassWithMorePhotonsThanRoomIsTracedAgain) {
    const SceneDescription description = whiteRoom();
    const auto scene = build(description);
    const SppmParams params = sppmParamsOf(description);
    HostCuda cuda;
    ASSERT_TRUE(cuda.backend->setScene(scene));
    const Photons first = render(*cuda.backend, params, 1);
    EXPECT_EQ(cuda.control->threadsOf["photons"], 2u * params.photonsPerPass) << "the scene needs more room";
    expectSame(first, renderOnCpu(scene, params, 1));
    const Photons three = render(*cuda.backend, params, 3);
    EXPECT_EQ(cuda.control->threadsOf["photons"], 5u * params.photonsPerPass) << "the room is kept";
    expectSame(three, renderOnCpu(scene, params, 3));
}

TEST(CudaSppm, AStopAtAnyStageLeavesTheStatisticsAlone) {
    const SceneDescription description = glassBox();
    const auto scene = build(description);
    const SppmParams params = sppmParamsOf(description);
    const Photons expected = renderOnCpu(scene, params, 3);
    for (const char* const step : {"camera", "photons", "gather"}) {
        HostCuda cuda;
        ASSERT_TRUE(cuda.backend->setScene(scene));
        Photons photons = render(*cuda.backend, params, 2);
        const SppmState before = photons.state;
        // More threads than one launch takes, so that there is something to stop.
        SppmParams large = params;
        large.pass.pass = 2;
        large.photonsPerPass = 200000;
        SppmState state = before;
        std::atomic<bool> stop{false};
        cuda.control->onLaunch = [&] { stop = stop || cuda.control->lastStep == step; };
        if (std::string_view(step) != "photons") {
            large.photonsPerPass = params.photonsPerPass;
            large.pass.width = 400;
            large.pass.height = 300;
            state = SppmState(400, 300);
            state.passes = 2;
        }
        const SppmState untouched = state;
        const auto done = renderSppmPass(*cuda.backend, large, stop, &state, &photons.direct);
        ASSERT_TRUE(done) << done.error().message;
        EXPECT_FALSE(*done) << step;
        EXPECT_EQ(differingPixels(state, untouched), 0u) << step;
        EXPECT_EQ(state.passes, untouched.passes);
        EXPECT_EQ(state.emittedPhotons, untouched.emittedPhotons);
        cuda.control->onLaunch = {};
        renderPasses(*cuda.backend, params, 1, &photons);
        expectSame(photons, expected);
    }
}

TEST(CudaSppm, AFailureOfAnyLaunchLeavesTheStatisticsAlone) {
    const SceneDescription description = glassBox();
    const auto scene = build(description);
    SppmParams params = sppmParamsOf(description);
    HostCuda cuda;
    ASSERT_TRUE(cuda.backend->setScene(scene));
    Photons photons = render(*cuda.backend, params, 1);
    const SppmState before = photons.state;
    const int launches = cuda.control->launches;
    ASSERT_GE(launches, 13);
    params.pass.pass = 1;
    const std::atomic<bool> stop{false};
    for (int launch = 0; launch < launches; ++launch) {
        cuda.control->failLaunch = launch;
        const auto done = renderSppmPass(*cuda.backend, params, stop, &photons.state, &photons.direct);
        ASSERT_FALSE(done) << launch;
        EXPECT_EQ(done.error().message, "the test device failed");
        EXPECT_EQ(differingPixels(photons.state, before), 0u) << launch;
        EXPECT_EQ(photons.state.passes, 1u);
    }
    cuda.control->failLaunch = -1;
    renderPasses(*cuda.backend, params, 1, &photons);
    expectSame(photons, renderOnCpu(scene, params, 2));
}

TEST(CudaSppm, GoesOnFromTheCpusStatisticsAndBack) {
    const SceneDescription description = glassBox();
    const auto scene = build(description);
    const SppmParams params = sppmParamsOf(description);
    const auto cpu = makeCpuBackend(2);
    ASSERT_TRUE(cpu->setScene(scene));
    HostCuda cuda;
    ASSERT_TRUE(cuda.backend->setScene(scene));
    Photons photons = render(*cpu, params, 2);
    renderPasses(*cuda.backend, params, 2, &photons);
    renderPasses(*cpu, params, 1, &photons);
    expectSame(photons, render(*cpu, params, 5));
    // The host may clear its statistics between passes.
    photons.state.reset(photons.state.width, photons.state.height);
    renderPasses(*cuda.backend, params, 2, &photons);
    expectSame(photons, render(*cpu, params, 2));
}

TEST(CudaSppm, TheSmallestVariantRuns) {
    HostCuda cuda;
    const SceneDescription box = glassBox();
    ASSERT_TRUE(cuda.backend->setScene(build(box)));
    SppmParams params = sppmParamsOf(box);
    std::string variant;
    cuda.control->onLaunch = [&] {
        if (cuda.control->lastStep == "gather") { variant = cuda.control->lastVariant; }
    };
    render(*cuda.backend, params, 1);
    EXPECT_EQ(variant, "smooth shapes");
    params.pass.sampler = SamplerKind::Independent;
    render(*cuda.backend, params, 1);
    EXPECT_EQ(variant, "full");
}

TEST(CudaSppm, EveryVariantHoldsTheOneBefore) { test::expectGrowing(cudaSppmVariants()); }

TEST(CudaSppm, TheTreeIsRefusedByName) {
    HostCuda cuda;
    SceneDescription description = glassBox();
    description.sppm.lookup = PhotonLookupKind::Tree;
    ASSERT_TRUE(cuda.backend->setScene(build(description)));
    Photons photons{SppmState(37, 29)};
    const std::atomic<bool> stop{false};
    const auto done =
        renderSppmPass(*cuda.backend, sppmParamsOf(description), stop, &photons.state, &photons.direct);
    ASSERT_FALSE(done);
    EXPECT_THAT(done.error().message, HasSubstr("choose \"grid\""));
}

}  // namespace
}  // namespace glint

#else
TEST(CudaSppm, NotBuilt) { GTEST_SKIP() << "this build has no CUDA back end (GLINT_CUDA)"; }
#endif
