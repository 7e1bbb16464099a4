// Every kernel variant that can render a scene gives the same bits as the full one: the path tracer's
// samples, first-hit pictures and SPPM's statistics, over all scenes of scenes/ and all that tests make
// in code.
#include <algorithm>
#include <atomic>
#include <cstring>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "engine/builders/power_distribution.h"
#include "engine/io/scene_loader.h"
#include "engine/render/cpu_sppm.h"
#include "engine/render/pass_params.h"
#include "tests/support/render_scene.h"
#include "tests/support/test_scenes.h"
#include "tests/support/variant_tables.h"

namespace glint {
namespace {

constexpr int kSize = 40;
constexpr uint32_t kPasses = 2;
constexpr uint32_t kPhotons = 3000;
const std::atomic<bool> kNever{false};

struct VariantScene {
    std::string name;
    SceneDescription description;
    std::shared_ptr<const BuiltScene> built;
};

/// Two coloured meshes where they were made, one of them a lamp, a point light and a sky: what a model from a
/// file needs.
SceneDescription plainMeshes() {
    SceneDescription scene = emptyScene({0.0f, 0.5f, 4.0f}, {0.0f, 0.0f, 0.0f}, 50.0f, kSize);
    scene.environment.color = Vec3(0.2f, 0.3f, 0.4f);
    addMeshObject(&scene, *test::bumpySphere(12, 24, true), Affine(), diffuseMaterial(0.7f));
    auto above = std::make_shared<MeshData>(*test::bumpySphere(3, 5, false));
    for (Vec3& p : above->positions) {
        p = 0.3f * p + Vec3(0.5f, 1.8f, 0.5f);
    }
    Material emitter = diffuseMaterial(0.5f);
    emitter.emission.value = Vec3(6.0f);
    addMeshObject(&scene, *above, Affine(), emitter);
    Light light;
    light.position = {2.0f, 2.0f, 2.0f};
    light.color = Vec3(4.0f);
    scene.lights.push_back(light);
    return scene;
}

/// The program's own scenes and those made in code, small; built once.
const std::vector<VariantScene>& scenes() {
    static const std::vector<VariantScene> all = [] {
        std::vector<VariantScene> list;
        for (const auto& entry : std::filesystem::directory_iterator(GLINT_SOURCE_DIR "/scenes")) {
            const std::string file = entry.path().string();
            if (!file.ends_with(".json") || file.ends_with(".schema.json")) { continue; }
            Result<SceneDescription> scene = loadScene(file, {});
            EXPECT_TRUE(scene.ok()) << file;
            list.push_back({entry.path().stem().string(), std::move(*scene), nullptr});
        }
        for (test::NamedScene& made : test::allTestScenes()) {
            list.push_back({made.name, std::move(made.scene), nullptr});
        }
        list.push_back({"plain meshes", plainMeshes(), nullptr});
        for (VariantScene& scene : list) {
            scene.description.resolution = {kSize, kSize};
            scene.description.sppm.photonsPerPass = kPhotons;
            scene.built = test::buildAll(scene.description);
        }
        return list;
    }();
    return all;
}

/// Structures without padding between the fields that are compared.
bool same(const Vec3& a, const Vec3& b) { return std::memcmp(&a, &b, sizeof(Vec3)) == 0; }
bool same(const PixelSample& a, const PixelSample& b) {
    return same(a.radiance, b.radiance) && a.fault == b.fault && a.rays == b.rays;
}
bool same(const AovSample& a, const AovSample& b) {
    return same(a.albedo, b.albedo) && same(a.shadingNormal, b.shadingNormal) &&
           same(a.geometricNormal, b.geometricNormal) && a.depth == b.depth && a.objectId == b.objectId &&
           a.materialId == b.materialId && a.boxesTested == b.boxesTested &&
           a.primitivesTested == b.primitivesTested && a.newtonSteps == b.newtonSteps;
}
bool same(const SppmPixel& a, const SppmPixel& b) {
    return a.radiusSquared == b.radiusSquared && a.photonCount == b.photonCount &&
           std::ranges::equal(a.flux, b.flux) && a.bias == b.bias && a.passM2 == b.passM2;
}

template <class Item>
size_t countDifferent(const std::vector<Item>& a, const std::vector<Item>& b) {
    size_t count = a.size() == b.size() ? 0 : std::max(a.size(), b.size());
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        count += same(a[i], b[i]) ? 0 : 1;
    }
    return count;
}

struct PathImages {
    std::vector<PixelSample> samples;
    std::vector<AovSample> aovs;
};

PathImages renderPaths(const VariantScene& scene, const KernelVariant& variant) {
    PathImages out;
    PassParams params = passParamsOf(scene.description);
    const SceneView view = scene.built->view();
    constexpr size_t kPixels = size_t{kSize} * kSize;
    std::vector<PixelSample> pass(kPixels);
    out.aovs.resize(kPixels);
    for (params.pass = 0; params.pass < kPasses; ++params.pass) {
        variant.renderTile(view, params, {0, 0, kSize, kSize}, pass.data());
        out.samples.insert(out.samples.end(), pass.begin(), pass.end());
    }
    params.pass = 0;
    variant.renderAovTile(view, params, {0, 0, kSize, kSize}, out.aovs.data());
    return out;
}

struct SppmImages {
    std::vector<PixelSample> direct;
    SppmState state{kSize, kSize};
};

SppmImages renderSppm(const VariantScene& scene, FeatureMask features) {
    SppmImages out;
    const SceneView view = scene.built->view();
    const PowerDistribution power = buildPowerDistribution(view);
    SppmParams params = sppmParamsOf(scene.description);
    CpuSppm sppm(2);
    std::vector<PixelSample> pass;
    for (params.pass.pass = 0; params.pass.pass < kPasses; ++params.pass.pass) {
        const auto done = sppm.renderPass(view, features, power.view(), params, kNever, &out.state, &pass);
        EXPECT_TRUE(done.ok() && *done);
        out.direct.insert(out.direct.end(), pass.begin(), pass.end());
    }
    return out;
}

bool serves(FeatureMask compiled, const VariantScene& scene) {
    const FeatureMask needed = neededFeatures(scene.built->features, scene.description.options.sampler);
    return (needed & ~compiled) == 0;
}

bool isLit(const std::vector<PixelSample>& samples) {
    return std::ranges::any_of(samples, [](const PixelSample& s) { return !isZero(s.radiance); });
}

TEST(VariantIdentity, PathTracing) {
    std::set<std::string> compared;
    for (const VariantScene& scene : scenes()) {
        const PathImages full = renderPaths(scene, kernelVariants().back());
        EXPECT_EQ(isLit(full.samples), scene.name != "darkness") << scene.name;
        for (const KernelVariant& variant : kernelVariants().first(kernelVariants().size() - 1)) {
            if (!serves(variant.mask, scene)) { continue; }
            compared.insert(variant.name);
            const PathImages own = renderPaths(scene, variant);
            EXPECT_EQ(countDifferent(own.samples, full.samples), 0u) << scene.name << ", " << variant.name;
            EXPECT_EQ(countDifferent(own.aovs, full.aovs), 0u) << scene.name << ", " << variant.name;
        }
    }
    // Not the full one itself. A variant that no scene here can run is not tested.
    EXPECT_EQ(compared.size(), kernelVariants().size() - 1);
}

TEST(VariantIdentity, Sppm) {
    std::set<std::string> compared;
    for (const VariantScene& scene : scenes()) {
        const SppmImages full = renderSppm(scene, kAllFeatures);
        for (const SppmVariant& variant : sppmVariants().first(sppmVariants().size() - 1)) {
            if (!serves(variant.mask, scene)) { continue; }
            compared.insert(variant.name);
            ASSERT_STREQ(chooseVariant(sppmVariants(), variant.mask, SamplerKind::Sobol).name, variant.name);
            const SppmImages own = renderSppm(scene, variant.mask);
            EXPECT_EQ(countDifferent(own.direct, full.direct), 0u) << scene.name << ", " << variant.name;
            EXPECT_EQ(countDifferent(own.state.pixels, full.state.pixels), 0u)
                << scene.name << ", " << variant.name;
            EXPECT_EQ(own.state.emittedPhotons, full.state.emittedPhotons);
        }
    }
    EXPECT_EQ(compared.size(), sppmVariants().size() - 1);
}

TEST(VariantIdentity, NoVariantIsHiddenByAnEarlierOne) {
    test::expectNoneHidden(kernelVariants());
    test::expectNoneHidden(sppmVariants());
}

}  // namespace
}  // namespace glint
