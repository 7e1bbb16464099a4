// Edits of objects, and the library of materials: without a window.
#include "viewer/model/object_edits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "viewer/model/copy_name.h"
#include "viewer/model/material_presets.h"

namespace glint {
namespace {

using testing::HasSubstr;

SceneDocument documentOf(int objects) {
    SceneDescription scene;
    scene.materials.resize(2);
    scene.materials[1].emission.value = Vec3(1.0f);
    for (int i = 0; i < objects; ++i) {
        scene.objects.emplace_back().name = "ball " + std::to_string(i);
    }
    scene.objects.back().material = 1;
    SceneDocument document;
    document.adopt(scene);
    return document;
}

TEST(ObjectEdits, SoloLeavesLampsAndUndoBringsBackWhatIsHidden) {
    SceneDocument document = documentOf(5);
    const auto before = document.version();
    document.selectedObject = 2;
    soloSelection(&document);
    document.takeEdits();
    ASSERT_EQ(document.draft().objects.size(), 2u);
    EXPECT_EQ(document.draft().objects[0].name, "ball 2");
    EXPECT_EQ(document.selectedObject, 0);
    EXPECT_EQ(document.draft().hiddenObjects.size(), 3u);
    const auto solo = document.version();
    document.show(before);
    EXPECT_EQ(document.draft().objects.size(), 5u);
    EXPECT_TRUE(document.draft().hiddenObjects.empty());
    document.show(solo);
    EXPECT_EQ(document.draft().hiddenObjects.size(), 3u);
    showAll(&document);
    EXPECT_EQ(document.draft().objects.size(), 5u);
    EXPECT_TRUE(document.draft().hiddenObjects.empty());
}

TEST(ObjectEdits, ShapesAreAddedAtTheTargetAndFlatOnesFaceUp) {
    SceneDocument document = documentOf(1);
    document.draft().camera.target = {1, 2, 3};
    document.selectedMaterial = 1;
    EXPECT_THAT(addableShapes(), testing::UnorderedElementsAre(ShapeKind::Sphere, ShapeKind::Plane,
                                                               ShapeKind::Rectangle, ShapeKind::Disc));
    for (const ShapeKind kind : addableShapes()) {
        addShape(&document, kind);
        const Object& object = document.draft().objects.back();
        SCOPED_TRACE(object.name);
        EXPECT_EQ(object.shape, kind);
        EXPECT_EQ(object.material, 1);
        EXPECT_EQ(document.selectedObject, static_cast<int>(document.draft().objects.size()) - 1);
        EXPECT_EQ(object.objectToWorld.translation, Vec3(1, 2, 3));
        const Vec3 front = glm::normalize(object.objectToWorld.linear[2]);
        if (kind != ShapeKind::Sphere) { EXPECT_NEAR(front.y, 1.0f, 1e-6f); }
    }
    addBox(&document);
    EXPECT_EQ(document.draft().objects.back().name, "box");
    EXPECT_EQ(document.draft().objects.back().mesh, 0);
    addBox(&document);
    EXPECT_EQ(document.draft().meshes.size(), 1u);
}

TEST(ObjectEdits, CopiesAreCounted) {
    EXPECT_EQ(copyName("ball", {"ball"}), "ball copy");
    EXPECT_EQ(copyName("ball", {"ball", "ball copy", "ball copy 4", "balloon copy 9"}), "ball copy 5");
    EXPECT_EQ(copyName("ball copy", {"ball copy"}), "ball copy 2");
    EXPECT_EQ(copyName("ball copy 3", {}), "ball copy 4");
    EXPECT_EQ(copyName("hard copy x", {}), "hard copy x copy");
    EXPECT_EQ(copyName(" copy", {}), " copy copy");
    EXPECT_EQ(copyName("球", {}), "球 copy");
    SceneDocument document = documentOf(1);
    document.selectedObject = 0;
    for (int i = 0; i < 1000; ++i) {
        duplicateSelection(&document);
    }
    EXPECT_EQ(document.draft().objects.back().name, "ball 0 copy 1000");
}

TEST(ObjectEdits, OneOfSeveralHiddenObjectsComesBack) {
    SceneDocument document = documentOf(4);
    document.selectedObject = 0;
    hideSelection(&document);
    document.selectedObject = 0;
    hideSelection(&document);
    document.takeEdits();
    showHidden(&document, 5);
    EXPECT_EQ(document.takeEdits().kinds, EditKind::None);
    showHidden(&document, 0);
    EXPECT_NE(document.takeEdits().kinds, EditKind::None);
    ASSERT_EQ(document.draft().objects.size(), 3u);
    EXPECT_EQ(document.draft().objects[2].name, "ball 0");
    EXPECT_EQ(document.selectedObject, 2);
    ASSERT_EQ(document.draft().hiddenObjects.size(), 1u);
    EXPECT_EQ(document.draft().hiddenObjects[0].name, "ball 1");
}

TEST(ObjectEdits, WhatIsHiddenAloneIsAnUnsavedEditToo) {
    SceneDocument document = documentOf(3);
    document.selectedObject = 0;
    hideSelection(&document);
    document.takeEdits();
    document.noteSaved(document.posted());
    EXPECT_FALSE(document.hasUnsavedEdits());
    showHidden(&document, 0);
    document.takeEdits();
    deleteSelection(&document);
    document.takeEdits();
    EXPECT_TRUE(document.hasUnsavedEdits()) << "the picture is that of the file";
}

TEST(ObjectEdits, TheFocusFollowsItsObject) {
    SceneDocument document = documentOf(3);
    document.draft().camera.position = {0, 0, 10};
    document.draft().camera.target = {0, 0, 0};
    document.selectedObject = 1;
    document.focusOnSelection();
    document.takeEdits();
    EXPECT_FLOAT_EQ(document.draft().camera.focalDistance, 10.0f);
    document.draft().objects[1].objectToWorld.translation = {3, 0, 4};
    document.takeEdits();
    EXPECT_FLOAT_EQ(document.draft().camera.focalDistance, 6.0f);
    document.selectedObject = 0;
    deleteSelection(&document);
    document.draft().objects[0].objectToWorld.translation = {0, 0, 5};
    document.takeEdits();
    EXPECT_FLOAT_EQ(document.draft().camera.focalDistance, 5.0f) << "it has another number now";
    document.selectedObject = 0;
    deleteSelection(&document);
    document.takeEdits();
    EXPECT_FLOAT_EQ(document.draft().camera.focalDistance, 5.0f);
}

TEST(ObjectEdits, AnotherScenesObjectsKeepTheirMaterialsAndTextures) {
    SceneDescription scene = documentOf(2).draft();
    scene.textures.resize(3);
    SceneDescription other = documentOf(1).draft();
    other.path = "elsewhere/model.obj";
    other.textures.emplace_back().name = "wood";
    other.textures[0].image.source = FileSource{"wood.png"};
    other.materials[1].color.texture = 0;
    other.objects[0].objectToWorld = translate({50, 0, 0}) * scale(Vec3(10));
    EXPECT_EQ(addScene(other, {0, 1, 0}, 2.0f, &scene), 1u);
    ASSERT_EQ(scene.objects.size(), 3u);
    const Object& added = scene.objects[2];
    EXPECT_EQ(added.material, 3);
    EXPECT_EQ(scene.materials[3].color.texture, 3);
    EXPECT_EQ(scene.textures[3].name, "wood");
    EXPECT_THAT(pathOf(scene.textures[3].image.source), HasSubstr("/elsewhere/wood.png"));
    EXPECT_LT(glm::length(added.objectToWorld.translation - Vec3(0, 2, 0)), 1e-5f) << "stands on the place";
    EXPECT_NEAR(added.objectToWorld.linear[0].x, 1.0f, 1e-5f);
}

TEST(MaterialPresets, HaveNamesOfTheirOwnAndKeepTheMaterials) {
    size_t count = 0;
    for (const MaterialPresetGroup& group : materialPresets()) {
        count += group.presets.size();
        for (const MaterialPreset& preset : group.presets) {
            EXPECT_FALSE(preset.name.empty());
            EXPECT_LE(maxComponent(preset.material.color.value), 1.0f) << preset.name;
        }
    }
    EXPECT_GT(count, 40u);
    Material mine;
    mine.name = "mine";
    takeMaterial(materialPresets()[0].presets[0].material, &mine);
    EXPECT_EQ(mine.name, "mine");
    EXPECT_EQ(mine.kind, MaterialKind::Conductor);
}

}  // namespace
}  // namespace glint
