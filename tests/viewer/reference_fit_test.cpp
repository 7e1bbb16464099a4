// Which edits make a loaded reference one of another picture, and that undoing them makes it fit again.
#include "viewer/model/reference_fit.h"

#include <chrono>
#include <functional>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/scene/scene_hash.h"

namespace glint {
namespace {

using testing::HasSubstr;

SceneDescription smallScene() {
    SceneDescription scene;
    scene.path = "scene.json";
    scene.resolution = {8, 6};
    scene.materials.resize(2);
    scene.lights.resize(1);
    scene.objects.resize(1);
    return scene;
}

std::shared_ptr<const LoadedReference> referenceOf(const SceneDescription* named) {
    auto reference = std::make_shared<LoadedReference>();
    if (named == nullptr) { return reference; }
    reference->attributes["sceneHash"] = sceneHash(*named).hex();
    for (const Setting& setting : renderSettings(*named)) {
        reference->attributes["setting." + setting.name] = setting.value;
    }
    return reference;
}

/// The answer for the scene, as "fits" or what is different.
std::string answerOf(ReferenceFit* fit, const std::shared_ptr<const LoadedReference>& reference,
                     const SceneDescription& scene) {
    const auto posted = std::make_shared<const SceneDescription>(scene);
    fit->check(reference, posted, true);
    for (int i = 0; i < 20000 && fit->checking(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        fit->check(reference, posted, true);
    }
    EXPECT_FALSE(fit->checking());
    return fit->fits() ? "fits" : fit->difference();
}

struct Edit {
    std::string answer;
    std::function<void(SceneDescription*)> make;
};

const std::vector<Edit>& edits() {
    static const std::vector<Edit> kEdits{
        {"the camera has changed", [](SceneDescription* s) { s->camera.position.x += 1.0f; }},
        {"the camera has changed", [](SceneDescription* s) { s->camera.apertureDiameter = 0.1f; }},
        {"the materials have changed", [](SceneDescription* s) { s->materials[0].color.value = Vec3(0.1f); }},
        {"the lights have changed", [](SceneDescription* s) { s->environment.strength = 3.0f; }},
        {"the objects have changed",
         [](SceneDescription* s) { s->objects[0].objectToWorld.translation.y = 2.0f; }},
        {"the max depth has changed", [](SceneDescription* s) { s->options.maxDepth = 3; }},
        {"the size and the filter have changed",
         [](SceneDescription* s) { s->resolution.width = 9, s->options.filterRadius = 2.0f; }},
        {"fits", [](SceneDescription* s) { s->options.seed = 9; }},
        {"fits", [](SceneDescription* s) { s->options.integrator = IntegratorKind::Sppm; }},
        {"fits", [](SceneDescription* s) { s->sppm.alpha = 0.6f; }},
    };
    return kEdits;
}

TEST(ReferenceFit, AImageThatNamesNothingIsOfTheSceneItWasLoadedFor) {
    const SceneDescription scene = smallScene();
    const auto reference = referenceOf(nullptr);
    for (const Edit& edit : edits()) {
        ReferenceFit fit;
        EXPECT_EQ(answerOf(&fit, reference, scene), "fits");
        SceneDescription edited = scene;
        edit.make(&edited);
        EXPECT_EQ(answerOf(&fit, reference, edited), edit.answer);
        EXPECT_EQ(answerOf(&fit, reference, scene), "fits") << "undone";
    }
}

TEST(ReferenceFit, AImageThatNamesItsSceneIsHeldAgainstTheName) {
    const SceneDescription scene = smallScene();
    const auto reference = referenceOf(&scene);
    for (const Edit& edit : edits()) {
        ReferenceFit fit;
        SceneDescription edited = scene;
        edit.make(&edited);
        const bool isNoise = edit.answer == "fits";
        EXPECT_EQ(answerOf(&fit, reference, edited) == "fits", isNoise) << edit.answer;
        EXPECT_EQ(answerOf(&fit, reference, scene), "fits") << "undone";
        EXPECT_EQ(answerOf(&fit, reference, edited), edit.answer) << "by now it is known what it shows";
    }
}

TEST(ReferenceFit, AReloadedSceneIsToldByItsContent) {
    SceneDescription scene = smallScene();
    MeshData mesh;
    mesh.positions = {Vec3(0.0f), Vec3(1.0f, 0.0f, 0.0f), Vec3(0.0f, 1.0f, 0.0f)};
    scene.meshes.resize(1);
    scene.meshes[0].data = std::make_shared<const MeshData>(mesh);
    Object placed;
    placed.shape = ShapeKind::Mesh;
    placed.mesh = 0;
    placed.material = 0;
    scene.objects.push_back(placed);
    SceneDescription reloaded = scene;
    reloaded.meshes[0].data = std::make_shared<const MeshData>(mesh);
    SceneDescription another = scene;
    mesh.positions[0].z = 0.5f;
    another.meshes[0].data = std::make_shared<const MeshData>(mesh);
    for (const auto& reference : {referenceOf(nullptr), referenceOf(&scene)}) {
        ReferenceFit fit;
        EXPECT_EQ(answerOf(&fit, reference, scene), "fits");
        EXPECT_EQ(answerOf(&fit, reference, reloaded), "fits");
        EXPECT_THAT(answerOf(&fit, reference, another),
                    testing::AnyOf("the geometry has changed", "it shows another scene"));
    }
}

TEST(ReferenceFit, WhatTheUserVouchedForIsForgottenWithTheReference) {
    ReferenceFit fit;
    answerOf(&fit, referenceOf(nullptr), smallScene());
    fit.useAnyway = true;
    const auto another = referenceOf(nullptr);
    answerOf(&fit, another, smallScene());
    EXPECT_FALSE(fit.useAnyway);
    fit.check(nullptr, nullptr, true);
    EXPECT_FALSE(fit.fits());
    EXPECT_FALSE(fit.checking());
}

}  // namespace
}  // namespace glint
