// The CUDA back end without a GPU: the kernels that nvcc compiled, run on the host over the uploaded
// layout, must give the CPU back end's samples bit for bit, since both compile the same arithmetic
// without contraction.
#include <gtest/gtest.h>

#if GLINT_HAS_CUDA

#include <bit>

#include "cuda/cuda_variant.h"
#include "engine/render/cpu_variants.h"
#include "engine/render/pass_params.h"
#include "engine/render/path_pass.h"
#include "tests/support/host_cuda.h"
#include "tests/support/test_scenes.h"
#include "tests/support/variant_tables.h"

namespace glint {
namespace {

using test::build;
using test::HostCuda;

/// Bits, so that NaN equals itself and -0 does not equal 0.
auto bitsOf(const Vec3& v) {
    return std::array{std::bit_cast<uint32_t>(v.x), std::bit_cast<uint32_t>(v.y),
                      std::bit_cast<uint32_t>(v.z)};
}
auto bitsOf(const PixelSample& s) { return std::tuple(bitsOf(s.radiance), s.fault, s.rays); }
auto bitsOf(const AovSample& s) {
    return std::tuple(bitsOf(s.albedo), bitsOf(s.shadingNormal), bitsOf(s.geometricNormal),
                      std::bit_cast<uint32_t>(s.depth), s.objectId, s.materialId);
}

template <class Sample>
size_t countDifferences(const std::vector<Sample>& a, const std::vector<Sample>& b) {
    EXPECT_EQ(a.size(), b.size());
    size_t differences = 0;
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        differences += bitsOf(a[i]) != bitsOf(b[i]);
    }
    return differences;
}

/// What the CPU's kernels bring when they are compiled for the same mask. The CPU back end itself may choose
/// a smaller variant, which need not round alike: diffuse surfaces alone are evaluated without a local frame.
template <class Sample, class Tile>
std::vector<Sample> cpuSamples(const BuiltScene& scene, const PassParams& params, FeatureMask mask,
                               Tile KernelVariant::*tileOf) {
    const KernelVariant& variant = chooseVariant(kernelVariants(), mask, SamplerKind::Sobol);
    EXPECT_EQ(variant.mask, mask);
    std::vector<Sample> samples(static_cast<size_t>(params.width * params.height));
    (variant.*tileOf)(scene.view(), params, {0, 0, params.width, params.height}, samples.data());
    return samples;
}

class CudaScenes : public testing::TestWithParam<test::NamedScene> {};

TEST_P(CudaScenes, SamplesEqualTheCpusBitForBit) {
    SceneDescription description = GetParam().scene;
    description.resolution = {67, 45};  // no multiple of the launch's tiles
    const auto scene = build(description);
    PassParams params = passParamsOf(description);
    const FeatureMask mask = chooseVariant(cudaVariants(), scene->features, params.sampler).mask;
    HostCuda cuda;
    ASSERT_TRUE(cuda.backend->setScene(scene));

    const std::atomic<bool> stop{false};
    for (params.pass = 0; params.pass < 2; ++params.pass) {
        std::vector<PixelSample> samples;
        ASSERT_TRUE(renderPathPass(*cuda.backend, params, stop, &samples));
        const auto expected = cpuSamples<PixelSample>(*scene, params, mask, &KernelVariant::renderTile);
        EXPECT_EQ(countDifferences(samples, expected), 0u);
        Vec3 sum(0.0f);
        for (const PixelSample& s : samples) {
            sum += s.radiance;
        }
        EXPECT_EQ(maxComponent(sum) > 0.0f, GetParam().name != "darkness");
    }
    std::vector<AovSample> aovs;
    ASSERT_TRUE(cuda.backend->renderAovPass(params, stop, &aovs));
    const auto expected = cpuSamples<AovSample>(*scene, params, mask, &KernelVariant::renderAovTile);
    EXPECT_EQ(countDifferences(aovs, expected), 0u);
}

INSTANTIATE_TEST_SUITE_P(All, CudaScenes, testing::ValuesIn(test::allTestScenes()),
                         [](const auto& scene) { return scene.param.name; });

TEST(CudaBackend, TheTestScenesNeedEveryFeature) {
    FeatureMask needed = 0;
    for (const test::NamedScene& scene : test::allTestScenes()) {
        needed |= neededFeatures(build(scene.scene)->features, scene.scene.options.sampler);
    }
    EXPECT_EQ(needed, kAllFeatures);
}

TEST(CudaBackend, TheSmallestVariantRuns) {
    HostCuda cuda;
    const std::atomic<bool> stop{false};
    std::vector<PixelSample> out;
    const SceneDescription cornell = test::cornellBox();
    ASSERT_TRUE(cuda.backend->setScene(build(cornell)));
    ASSERT_TRUE(renderPathPass(*cuda.backend, passParamsOf(cornell), stop, &out));
    EXPECT_EQ(cuda.control->lastVariant, "diffuse shapes");
    EXPECT_EQ(cuda.backend->kernelName(SamplerKind::Sobol), "diffuse shapes");
    // A setting of the pass can ask for more than the scene.
    PassParams independent = passParamsOf(cornell);
    independent.sampler = SamplerKind::Independent;
    ASSERT_TRUE(renderPathPass(*cuda.backend, independent, stop, &out));
    EXPECT_EQ(cuda.control->lastVariant, "full");
}

TEST(CudaBackend, EveryVariantHoldsTheOneBefore) { test::expectGrowing(cudaVariants()); }

TEST(CudaBackend, AStopDiscardsThePassAfterTheLaunchInFlight) {
    HostCuda cuda;
    SceneDescription description = test::darkness();
    description.resolution = {512, 512};
    ASSERT_TRUE(cuda.backend->setScene(build(description)));
    std::atomic<bool> stop{false};
    cuda.control->onLaunch = [&] { stop = true; };
    std::vector<PixelSample> out;
    const auto finished = renderPathPass(*cuda.backend, passParamsOf(description), stop, &out);
    ASSERT_TRUE(finished);
    EXPECT_FALSE(*finished);
    EXPECT_EQ(cuda.control->launches, 1);
    EXPECT_TRUE(out.empty());
}

TEST(CudaBackend, AFailedLaunchIsAnErrorAndTheNextPassMayWork) {
    HostCuda cuda;
    const SceneDescription description = test::cornellBox();
    const std::atomic<bool> stop{false};
    std::vector<PixelSample> out;
    EXPECT_FALSE(renderPathPass(*cuda.backend, passParamsOf(description), stop, &out)) << "without a scene";
    ASSERT_TRUE(cuda.backend->setScene(build(description)));
    cuda.control->failLaunch = 0;
    const auto failed = renderPathPass(*cuda.backend, passParamsOf(description), stop, &out);
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().message, "the test device failed");
    EXPECT_TRUE(renderPathPass(*cuda.backend, passParamsOf(description), stop, &out));
}

TEST(CudaBackend, AImageThatDoesNotFitIsAnErrorBeforeItIsTaken) {
    HostCuda cuda;
    SceneDescription description = test::cornellBox();
    description.resolution = {1024, 1024};
    ASSERT_TRUE(cuda.backend->setScene(build(description)));
    cuda.control->memoryBytes = cuda.control->taken() + 1024 * 1024;
    const int allocations = cuda.control->allocations;
    const std::atomic<bool> stop{false};
    std::vector<PixelSample> out;
    const auto failed = renderPathPass(*cuda.backend, passParamsOf(description), stop, &out);
    ASSERT_FALSE(failed);
    EXPECT_NE(failed.error().message.find("picture needs"), std::string::npos) << failed.error().message;
    EXPECT_EQ(cuda.control->allocations, allocations);
}

/// Two passes by the back end's integrator, one after the other.
std::vector<PixelSample> previewSamples(Backend& backend, const SceneDescription& scene,
                                        IntegratorKind kind) {
    const std::atomic<bool> stop{false};
    std::vector<PixelSample> all;
    EXPECT_TRUE(backend.setScene(build(scene)));
    Integrator* integrator = backend.integrator(kind).value();
    integrator->prepare(scene);
    PassParams params = passParamsOf(scene);
    for (params.pass = 0; params.pass < 2; ++params.pass) {
        std::vector<PixelSample> samples;
        const auto done = integrator->renderPass(params, stop, nullptr, &samples);
        EXPECT_TRUE(done && *done);
        all.insert(all.end(), samples.begin(), samples.end());
    }
    return all;
}

TEST_P(CudaScenes, PreviewsEqualTheCpusBitForBit) {
    SceneDescription description = GetParam().scene;
    description.resolution = {67, 45};
    for (Material& material : description.materials) {
        material.phongSpecular = Vec3(0.5f, 0.4f, 0.3f);
        material.phongExponent = 12.5f;
    }
    description.rayCast.ambient = Vec3(0.1f, 0.2f, 0.3f);
    for (const IntegratorKind kind : {IntegratorKind::AmbientOcclusion, IntegratorKind::RayCast}) {
        HostCuda cuda;
        const auto cpu = makeCpuBackend(2);
        const std::vector<PixelSample> samples = previewSamples(*cuda.backend, description, kind);
        EXPECT_EQ(countDifferences(samples, previewSamples(*cpu, description, kind)), 0u)
            << integratorInfo(kind).key;
    }
}

TEST(CudaBackend, RayCastingTakesTheMaterialsOfEachPreparation) {
    HostCuda cuda;
    SceneDescription scene = test::cornellBox();
    const auto dull = previewSamples(*cuda.backend, scene, IntegratorKind::RayCast);
    for (Material& material : scene.materials) {
        material.phongSpecular = Vec3(0.9f);
        material.phongExponent = 2.0f;
    }
    const auto shiny = previewSamples(*cuda.backend, scene, IntegratorKind::RayCast);
    EXPECT_GT(countDifferences(dull, shiny), 0u);
    EXPECT_EQ(countDifferences(shiny, previewSamples(*makeCpuBackend(2), scene, IntegratorKind::RayCast)),
              0u);
}

TEST(CudaBackend, GivesAllMemoryBack) {
    HostCuda cuda;
    const SceneDescription description = test::meshInstances();
    const std::atomic<bool> stop{false};
    std::vector<PixelSample> out;
    ASSERT_TRUE(cuda.backend->setScene(build(description)));
    ASSERT_TRUE(renderPathPass(*cuda.backend, passParamsOf(description), stop, &out));
    EXPECT_GT(cuda.control->taken(), 0u);
    cuda.backend.reset();
    EXPECT_EQ(cuda.control->taken(), 0u);
}

}  // namespace
}  // namespace glint

#else
TEST(CudaBackend, NotBuilt) { GTEST_SKIP() << "this build has no CUDA back end (GLINT_CUDA)"; }
#endif
