// The list of edits: their names, gestures as one step, and what is unsaved.
#include "viewer/model/edit_history.h"

#include <gtest/gtest.h>

#include "viewer/model/edit_name.h"

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
    ASSERT_EQ(history.edits.states().size(), 2u);
    EXPECT_EQ(history.edits.states()[1].version.scene->camera.apertureDiameter, 5.0f);
    history.aperture(0.2f, 8);
    history.aperture(0.3f, 0);
    history.aperture(0.4f, 0);
    EXPECT_EQ(history.edits.states().size(), 5u);
}

TEST(EditHistory, AGestureThatComesBackIsNoStep) {
    History history;
    history.aperture(0.1f, 7);
    history.aperture(0.0f, 7);
    EXPECT_EQ(history.edits.states().size(), 1u);
    history.aperture(0.2f, 7);
    history.aperture(0.3f, 7);
    EXPECT_EQ(history.edits.states().size(), 2u);
}

TEST(EditHistory, AnEditAfterUndoForgetsWhatWasUndone) {
    History history;
    history.aperture(0.1f, 7);
    history.aperture(0.2f, 8);
    EXPECT_FALSE(history.edits.canRedo());
    EXPECT_EQ(history.edits.goTo(1).version.scene->camera.apertureDiameter, 0.1f);
    EXPECT_TRUE(history.edits.canRedo());
    history.aperture(0.3f, 8);
    ASSERT_EQ(history.edits.states().size(), 3u) << "a gesture does not go on behind an undo";
    EXPECT_EQ(history.edits.states()[2].version.scene->camera.apertureDiameter, 0.3f);
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
    EXPECT_EQ(history.edits.states().size(), EditHistory::kMostStates);
    EXPECT_EQ(history.edits.present(), EditHistory::kMostStates - 1);
    EXPECT_EQ(history.edits.states().front().version.scene->camera.apertureDiameter, 1.0f);
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
