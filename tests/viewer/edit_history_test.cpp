// The list of edits: their names, gestures as one step, and what is unsaved.
#include "viewer/model/edit_history.h"

#include <gtest/gtest.h>

#include "engine/scene/scene_diff.h"
#include "viewer/model/edit_name.h"
#include "viewer/model/object_edits.h"

namespace glint {
namespace {

SceneDescription smallScene() {
    SceneDescription scene;
    scene.materials.resize(2);
    scene.materials[1].name = "glass";
    scene.lights.resize(1);
    scene.objects.resize(2);
    scene.objects[0].material = 0;
    scene.objects[1].material = 1;
    return scene;
}

template <class Change>
std::string nameOf(Change change) {
    SceneDescription after = smallScene();
    change(after);
    return editName(smallScene(), after);
}

TEST(EditName, SaysWhatTheEditChanged) {
    using S = SceneDescription&;
    EXPECT_EQ(nameOf([](S s) { s.camera.apertureDiameter = 1.0f; }), "Camera: aperture diameter");
    EXPECT_EQ(nameOf([](S s) {
                  s.camera.position.x = 9.0f;
                  s.camera.target.x = 9.0f;
              }),
              "Camera: position and 1 more");
    EXPECT_EQ(nameOf([](S s) { s.materials[1].color.value.x = 0.9f; }), "Material glass: color");
    EXPECT_EQ(nameOf([](S s) { s.lights[0].strength = 3.0f; }), "Light 1: intensity");
    EXPECT_EQ(nameOf([](S s) { s.lights.resize(2); }), "Light added");
    EXPECT_EQ(nameOf([](S s) { s.objects.clear(); }), "Object: 2 removed");
    EXPECT_EQ(nameOf([](S s) { s.sppm.alpha = 0.5f; }), "SPPM: alpha");
    EXPECT_EQ(nameOf([](S s) { s.environment.rotationDeg = 5.0f; }), "Environment: rotation");
}

class History {
  public:
    History() {
        document_.adopt(smallScene());
        record("Open", 0);
    }
    void aperture(float diameter, uint64_t gesture) {
        document_.draft().camera.apertureDiameter = diameter;
        (void)document_.takeEdits();
        record("aperture", gesture);
    }
    EditHistory edits;

  private:
    void record(const char* name, uint64_t gesture) {
        edits.record({name, document_.version(), edits.take()}, gesture);
    }
    SceneDocument document_;
};

TEST(EditHistory, AGestureIsOneStep) {
    History history;
    for (int step = 1; step <= 5; ++step) {
        history.aperture(static_cast<float>(step), 7);
    }
    ASSERT_EQ(history.edits.size(), 2u);
    EXPECT_EQ(history.edits.state(1).version.scene->camera.apertureDiameter, 5.0f);
    history.aperture(0.2f, 8);
    history.aperture(0.3f, 0);
    history.aperture(0.4f, 0);
    EXPECT_EQ(history.edits.size(), 5u);
}

TEST(EditHistory, AGestureThatComesBackIsNoStep) {
    History history;
    history.aperture(0.1f, 7);
    history.aperture(0.0f, 7);
    EXPECT_EQ(history.edits.size(), 1u);
    history.aperture(0.2f, 7);
    history.aperture(0.3f, 7);
    EXPECT_EQ(history.edits.size(), 2u);
}

TEST(EditHistory, AnEditAfterUndoForgetsWhatWasUndone) {
    History history;
    history.aperture(0.1f, 7);
    history.aperture(0.2f, 8);
    EXPECT_FALSE(history.edits.canRedo());
    EXPECT_EQ(history.edits.goTo(1).version.scene->camera.apertureDiameter, 0.1f);
    EXPECT_TRUE(history.edits.canRedo());
    history.aperture(0.3f, 8);
    ASSERT_EQ(history.edits.size(), 3u) << "a gesture does not go on behind an undo";
    EXPECT_EQ(history.edits.state(2).version.scene->camera.apertureDiameter, 0.3f);
    EXPECT_FALSE(history.edits.canRedo());
}

TEST(EditHistory, AsksForStatesThatAreThere) {
    History history;
    history.edits.askUndo();
    history.edits.askRedo();
    history.edits.ask(7);
    EXPECT_FALSE(history.edits.takeAsked());
    history.aperture(0.1f, 0);
    history.edits.askUndo();
    EXPECT_EQ(history.edits.takeAsked(), 0u);
    EXPECT_FALSE(history.edits.takeAsked());
}

TEST(EditHistory, ForgetsTheOldestOfTooMany) {
    History history;
    for (size_t i = 1; i <= EditHistory::kMostStates; ++i) {
        history.aperture(static_cast<float>(i), 0);
    }
    EXPECT_EQ(history.edits.size(), EditHistory::kMostStates);
    EXPECT_EQ(history.edits.present(), EditHistory::kMostStates - 1);
    EXPECT_EQ(history.edits.state(0).version.scene->camera.apertureDiameter, 1.0f);
}

/// Each version of the scene is copied once a piece, not once a step.
TEST(EditHistory, AStepOfAThousandObjectsCostsNotAThousandObjects) {
    constexpr int kObjects = 1000, kCopies = 400;
    SceneDocument document;
    SceneDescription scene = smallScene();
    scene.objects.resize(kObjects);
    document.adopt(scene);
    EditHistory edits;
    edits.record({"Open", document.version()}, 0);
    const uint64_t atFirst = edits.itemsCopied();
    document.selectedObject = 7;
    for (int copy = 0; copy < kCopies; ++copy) {
        duplicateSelection(&document);
        (void)document.takeEdits();
        edits.record({"Duplicate", document.version()}, 0);
    }
    EXPECT_LE(edits.itemsCopied() - atFirst, 64u * kCopies);
    for (int undone = 1; undone <= 350; ++undone) {
        edits.askUndo();
        (void)document.show(edits.goTo(*edits.takeAsked()).version);
        EXPECT_EQ(document.draft().objects.size(), static_cast<size_t>(kObjects + kCopies - undone));
    }
    for (int redone = 1; redone <= 350; ++redone) {
        edits.askRedo();
        (void)document.show(edits.goTo(*edits.takeAsked()).version);
    }
    EXPECT_EQ(document.draft().objects.size(), static_cast<size_t>(kObjects + kCopies));
    EXPECT_EQ(document.draft().objects.back().name, "object 8 copy 400");
    EXPECT_LE(edits.itemsCopied() - atFirst, 64u * kCopies) << "going back and forth records nothing";
    const uint64_t before = edits.itemsCopied();
    for (int removed = 0; removed < 300; ++removed) {
        document.selectedObject = (removed * 131) % (kObjects - 300);
        deleteSelection(&document);
        (void)document.takeEdits();
        edits.record({"Delete", document.version()}, 0);
    }
    EXPECT_LE(edits.itemsCopied() - before, 2u * 64u * 300u);
}

/// What a state had is there again when nobody holds its scene any more: every field, and heavy parts
/// by identity.
TEST(EditHistory, AStateThatNobodyHoldsIsTheSame) {
    SceneDocument document;
    SceneDescription scene = smallScene();
    scene.description = "two things";
    scene.warnings = {"a", "b"};
    scene.meshes.push_back({"mesh", FileSource{"a.ply", 2}, std::make_shared<const MeshData>()});
    scene.hiddenObjects.resize(1);
    scene.hiddenObjects[0].name = "unseen";
    scene.objects[0].profile = {{1.0f, 2.0f}};
    document.adopt(scene);
    EditHistory edits;
    edits.record({"Open", document.version()}, 0);
    for (int step = 1; step < 4; ++step) {
        document.draft().objects[0].name = "step " + std::to_string(step);
        document.draft().materials[0].color.value.x = 0.1f * static_cast<float>(step);
        (void)document.takeEdits();
        edits.record({"Edit", document.version()}, 0);
    }
    const auto first = edits.state(0).version.scene;
    EXPECT_EQ(differences(*first, scene), EditKind::None);
    EXPECT_TRUE(sameUnseen(*first, scene));
    EXPECT_EQ(first->meshes[0].data, scene.meshes[0].data);
    EXPECT_EQ(first, edits.state(0).version.scene) << "as long as anyone has it";
    EXPECT_EQ(edits.state(2).version.scene->objects[0].name, "step 2");
    EXPECT_EQ(edits.state(3).version.scene, document.posted());
}

TEST(SceneDocument, TellsViewsFromEdits) {
    SceneDocument document;
    document.adopt(smallScene());
    EXPECT_EQ(document.unsaved(), SceneDocument::Unsaved::Nothing);
    const SceneDocument::Version opened = document.version();
    document.draft().camera.position.x = 2.0f;
    (void)document.takeEdits();
    EXPECT_EQ(document.unsaved(), SceneDocument::Unsaved::View) << "the focus follows";
    document.draft().lights[0].strength = 3.0f;
    (void)document.takeEdits();
    EXPECT_EQ(document.unsaved(), SceneDocument::Unsaved::Edits);
    document.noteSaved(document.posted());
    EXPECT_EQ(document.unsaved(), SceneDocument::Unsaved::Nothing);
    EXPECT_EQ(document.show(opened), EditKind::Camera | EditKind::Lights);
    EXPECT_EQ(document.unsaved(), SceneDocument::Unsaved::Edits) << "the file has the newer version";
    document.adopt(smallScene(), false);
    EXPECT_EQ(document.unsaved(), SceneDocument::Unsaved::Edits);
    EXPECT_EQ(document.show(opened), EditKind::Everything);
}

}  // namespace
}  // namespace glint
