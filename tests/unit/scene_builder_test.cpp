// The edit table with real parts: what each edit rebuilds and what it shares, and what is refused.
#include "engine/builders/scene_builder.h"

#include <limits>

#include <gtest/gtest.h>

#include "engine/builders/light_table.h"
#include "tests/support/test_scenes.h"

namespace glint {
namespace {

using Built = std::shared_ptr<const BuiltScene>;

struct Edited {
    Built scene;
    BuildReport report;
};

class SceneBuilder : public testing::Test {
  protected:
    SceneBuilder() {
        description = test::meshInstances();
        description.materials.push_back({});
        description.materials.back().name = "spare";
        // The scene's own materials may share one mesh; a lamp makes light tables matter.
        description.materials.back().emission.value = Vec3(1.0f);
        Object emitter;
        emitter.name = "lamp";
        emitter.shape = ShapeKind::Sphere;
        emitter.material = static_cast<int>(description.materials.size()) - 1;
        emitter.objectToWorld.translation = {0, 5, 0};
        description.objects.push_back(emitter);
        const Edited first = edit(EditKind::Everything, nullptr);
        before = first.scene;
    }

    Edited edit(EditKind kinds, const Built& previous) {
        Edited out;
        auto result = buildScene({std::make_shared<SceneDescription>(description), kinds}, previous.get(), 1,
                                 nullptr, &out.report);
        EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().format());
        if (result.ok()) { out.scene = *result; }
        return out;
    }

    std::string refusal(EditKind kinds = EditKind::Everything) {
        const auto result = buildScene({std::make_shared<SceneDescription>(description), kinds}, before.get(),
                                       1, nullptr, nullptr);
        return result.ok() ? "" : result.error().format();
    }

    SceneDescription description;
    Built before;
};

TEST_F(SceneBuilder, AnotherAcceleratorRebuildsMeshesAndTheTopLevelAndIsNoLongerNeededAfterwards) {
    description.options.accelerator = AcceleratorKind::KdTree;
    const Edited after = edit(EditKind::Accelerator, before);
    EXPECT_EQ(after.report.meshesBuilt, 2);
    EXPECT_TRUE(after.report.topLevelBuilt);
    EXPECT_EQ(after.scene->materials, before->materials);
    EXPECT_EQ(after.scene->lights, before->lights);
    EXPECT_EQ(after.scene->view().geometry.topLevel.kind, AcceleratorKind::KdTree);
    EXPECT_EQ(after.scene->view().geometry.meshes[0].accelerator.kind, AcceleratorKind::KdTree);
    EXPECT_EQ(after.scene->features, before->features | kFeatureAccelerators);
    EXPECT_EQ(edit(EditKind::Everything, after.scene).report.meshesBuilt, 0) << "they are of that kind";

    description.options.accelerator = AcceleratorKind::Bvh;
    const Edited back = edit(EditKind::Accelerator, after.scene);
    EXPECT_EQ(back.report.meshesBuilt, 2);
    EXPECT_EQ(back.scene->features, before->features) << "the smaller kernels run again";
}

TEST_F(SceneBuilder, CameraAndSizeRebuildNothing) {
    description.camera.position.x += 1.0f;
    description.resolution.width *= 2;
    const Edited after = edit(EditKind::Camera | EditKind::Resolution, before);
    EXPECT_EQ(after.scene->instances, before->instances);
    EXPECT_EQ(after.scene->materials, before->materials);
    EXPECT_EQ(after.scene->textures, before->textures);
    EXPECT_EQ(after.scene->lights, before->lights);
    EXPECT_EQ(after.scene->meshes, before->meshes);
    EXPECT_NE(after.scene->camera.position, before->camera.position);
    EXPECT_NE(after.scene->camera.halfWidth, before->camera.halfWidth);
    EXPECT_FALSE(after.report.featuresScanned);
}

TEST_F(SceneBuilder, AColourRebuildsTheMaterialTableOnly) {
    description.materials[0].color.value = Vec3(0.123f);
    const Edited after = edit(EditKind::MaterialParameters, before);
    EXPECT_TRUE(after.report.materialsBuilt);
    EXPECT_NE(after.scene->materials, before->materials);
    EXPECT_EQ(after.scene->lights, before->lights);
    EXPECT_EQ(after.scene->instances, before->instances);
    EXPECT_EQ(after.scene->textures, before->textures);
}

TEST_F(SceneBuilder, FeaturesAreScannedOnlyWhenAMaterialsKindOrRoughnessBegins) {
    Material& metal = description.materials[0];
    metal.kind = MaterialKind::Conductor;
    metal.roughness.value = 0.3f;
    const Edited rough = edit(EditKind::MaterialKind, before);
    EXPECT_TRUE(rough.report.featuresScanned);
    EXPECT_TRUE(rough.scene->features & kFeatureGlossy);
    metal.roughness.value = 0.4f;
    metal.eta.value *= 1.5f;
    metal.metal.clear();
    const Edited numbers = edit(EditKind::MaterialParameters | EditKind::MaterialKind, rough.scene);
    EXPECT_TRUE(numbers.report.materialsBuilt);
    EXPECT_FALSE(numbers.report.featuresScanned);
    metal.roughness.value = 0.0f;
    const Edited smooth = edit(EditKind::MaterialParameters, numbers.scene);
    EXPECT_TRUE(smooth.report.featuresScanned);
    EXPECT_TRUE(smooth.scene->features & kFeatureSpecular);
    EXPECT_TRUE(smooth.scene->features & kFeatureGlossy) << "the mask never shrinks while a scene is edited";
}

TEST_F(SceneBuilder, AnEmissionRebuildsTheLightTableToo) {
    description.materials.back().emission.value = Vec3(2.0f);
    const Edited brighter = edit(EditKind::MaterialParameters, before);
    EXPECT_TRUE(brighter.report.lightsBuilt);
    EXPECT_EQ(brighter.scene->instances, before->instances) << "the same emitters, only brighter";
    description.materials[0].emission.value = Vec3(1.0f);
    const Edited more = edit(EditKind::MaterialParameters, brighter.scene);
    EXPECT_TRUE(more.report.topLevelBuilt) << "instances hold the numbers of their emitters";
}

/// What lights are chosen by is taken over from the scene before, and only from one with the same lights.
TEST_F(SceneBuilder, AmongManyLampsEachMoveGivesTheTablesOfANewScene) {
    const Object lamp = description.objects.back();
    for (uint32_t i = 0; i < 3 * kFewLights; ++i) {
        description.objects.push_back(lamp);
        description.objects.back().objectToWorld.translation.x = 3.0f * static_cast<float>(i + 1);
    }
    Built scene = edit(EditKind::Everything, nullptr).scene;
    for (const size_t moved : {size_t{0}, description.objects.size() - 1}) {
        description.objects[moved].objectToWorld.translation.z += 1.0f;
        const Edited after = edit(EditKind::ObjectTransform, scene);
        EXPECT_EQ(after.report.lightsBuilt, moved != 0);
        const Built fresh = edit(EditKind::Everything, nullptr).scene;
        EXPECT_TRUE(after.scene->lights->usesTree);
        EXPECT_TRUE(after.scene->lights->nodes == fresh->lights->nodes);
        EXPECT_TRUE(after.scene->lights->emitterNodes == fresh->lights->emitterNodes);
        scene = after.scene;
    }
}

TEST_F(SceneBuilder, ALightRebuildsTheLightTableOnly) {
    description.environment.strength = 0.5f;
    const Edited after = edit(EditKind::Lights, before);
    EXPECT_TRUE(after.report.lightsBuilt);
    EXPECT_FALSE(after.report.materialsBuilt);
    EXPECT_FALSE(after.report.topLevelBuilt);
    EXPECT_EQ(after.scene->materials, before->materials);
    EXPECT_EQ(after.scene->instances, before->instances);
}

TEST_F(SceneBuilder, WhatNoPictureShowsChangesNothing) {
    const SceneDescription untouched = description;
    ASSERT_EQ(untouched.camera.apertureDiameter, 0.0f);
    ASSERT_FALSE(untouched.materials[0].emissive());
    description.environment.image = -1;
    description.lights.push_back({});
    description.lights.back().strength = 0.0f;
    before = edit(EditKind::Everything, nullptr).scene;
    const SceneDescription start = description;
    const auto looksTheSame = [&](EditKind kinds, const auto& change) {
        description = start;
        change(&description);
        return edit(kinds, before).scene->looksLike(*before);
    };
    using S = SceneDescription;
    EXPECT_TRUE(looksTheSame(EditKind::Camera, [](S* s) { s->camera.focalDistance *= 2.0f; }));
    EXPECT_TRUE(looksTheSame(EditKind::Camera, [](S* s) { s->camera.apertureBlades = 5; }));
    EXPECT_TRUE(looksTheSame(EditKind::Camera, [](S* s) { s->camera.bladeRotationDeg = 5.0f; }));
    EXPECT_TRUE(looksTheSame(EditKind::Lights, [](S* s) { s->environment.rotationDeg = 90.0f; }));
    EXPECT_TRUE(looksTheSame(EditKind::Lights, [](S* s) { s->lights[0].color = Vec3(0.1f); }));
    constexpr EditKind kParameters = EditKind::MaterialParameters;
    EXPECT_TRUE(looksTheSame(kParameters, [](S* s) { s->materials[0].emissionStrength = 3.0f; }));
    EXPECT_TRUE(looksTheSame(kParameters, [](S* s) { s->materials[0].emitsBothSides ^= true; }));
    EXPECT_FALSE(looksTheSame(kParameters, [](S* s) { s->materials.back().emissionStrength = 3.0f; }));
    EXPECT_FALSE(looksTheSame(kParameters, [](S* s) { s->materials.back().emitsBothSides ^= true; }));
    EXPECT_FALSE(looksTheSame(EditKind::Lights, [](S* s) { s->lights[0].strength = 1.0f; }));
    EXPECT_FALSE(looksTheSame(EditKind::Camera, [](S* s) { s->camera.apertureDiameter = 0.1f; }));
    EXPECT_FALSE(looksTheSame(EditKind::ObjectTransform,
                              [](S* s) { s->objects[0].objectToWorld.translation.x += 1.0f; }));
    description = start;
    description.camera.apertureDiameter = 0.1f;
    before = edit(EditKind::Camera, before).scene;
    description.camera.focalDistance *= 2.0f;
    EXPECT_FALSE(edit(EditKind::Camera, before).scene->looksLike(*before));
}

TEST_F(SceneBuilder, AMovedObjectRebuildsTheTopLevelAndNoMesh) {
    description.objects[0].objectToWorld.translation.x += 0.5f;
    const Edited after = edit(EditKind::ObjectTransform, before);
    EXPECT_TRUE(after.report.topLevelBuilt);
    EXPECT_EQ(after.report.meshesBuilt, 0);
    EXPECT_EQ(after.scene->meshes, before->meshes);
    EXPECT_EQ(after.scene->materials, before->materials);
}

TEST_F(SceneBuilder, AnotherSceneSharesTheMeshesThatStay) {
    const Edited after = edit(EditKind::Everything, before);
    EXPECT_EQ(after.report.meshesBuilt, 0);
    EXPECT_EQ(after.scene->meshes, before->meshes);
    const Edited fresh = edit(EditKind::Everything, nullptr);
    EXPECT_GT(fresh.report.meshesBuilt, 0);
}

TEST_F(SceneBuilder, FeaturesGrowWithEditsAndShrinkWithAnotherScene) {
    const FeatureMask atFirst = before->features;
    ASSERT_EQ(atFirst & kFeatureMixture, FeatureMask{0});
    const MaterialKind kind = description.materials[0].kind;
    description.materials[0].kind = MaterialKind::Mixture;
    const Edited grown = edit(EditKind::MaterialKind, before);
    EXPECT_NE(grown.scene->features & kFeatureMixture, FeatureMask{0});
    description.materials[0].kind = kind;
    const Edited kept = edit(EditKind::MaterialKind, grown.scene);
    EXPECT_NE(kept.scene->features & kFeatureMixture, FeatureMask{0});
    EXPECT_EQ(edit(EditKind::Everything, kept.scene).scene->features, atFirst);
}

TEST_F(SceneBuilder, AnEditThatForgetsToSayThatObjectsAppearedIsMadeGood) {
    description.objects.push_back(description.objects.front());
    const Edited after = edit(EditKind::Camera, before);
    EXPECT_EQ(after.scene->view().geometry.instances.count, before->view().geometry.instances.count + 1);
}

TEST_F(SceneBuilder, FaultsNameWhatTheyAreIn) {
    const SceneDescription good = description;
    const auto expect = [&](const char* part, const std::function<void()>& spoil) {
        description = good;
        spoil();
        EXPECT_NE(refusal().find(part), std::string::npos) << part << " is not in: " << refusal();
    };
    description.objects.back().name = "lamp";
    expect("object 'lamp'", [&] { description.objects.back().material = 99; });
    expect("object 'lamp'", [&] { description.objects.back().objectToWorld.linear = Mat3(0.0f); });
    expect("object 'lamp'", [&] { description.objects.back().objectToWorld.translation.x = kInfinity; });
    expect("material 'spare'", [&] { description.materials.back().roughness.value = 2.0f; });
    expect("material 'spare'",
           [&] { description.materials.back().emission.value.x = std::numeric_limits<float>::quiet_NaN(); });
    expect("material 'spare'", [&] { description.materials.back().color.texture = 77; });
    expect("material 'spare'", [&] { description.materials.back().emission.texture = 77; });
    expect("camera", [&] { description.camera.target = description.camera.position; });
    expect("camera", [&] { description.camera.apertureBlades = 2; });
    expect("resolution", [&] { description.resolution.width = 0; });
    expect("environment", [&] { description.environment.image = 5; });
    expect("mesh", [&] { description.meshes[0].data.reset(); });
    expect("light", [&] {
        Light light;
        light.kind = LightKind::Spot;
        light.direction = Vec3(0.0f);
        description.lights.push_back(light);
    });
}

TEST_F(SceneBuilder, AStopIsHeeded) {
    const std::atomic<bool> stop{true};
    const auto result = buildScene({std::make_shared<SceneDescription>(description), EditKind::Everything},
                                   nullptr, 1, &stop, nullptr);
    EXPECT_FALSE(result.ok());
}

}  // namespace
}  // namespace glint
