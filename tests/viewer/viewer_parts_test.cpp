// The viewer's parts that draw nothing: which edit a change is, camera moves, and what scripts may say.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "engine/scene/scene_diff.h"
#include "tests/support/temp_folder.h"
#include "viewer/base/camera_bookmarks.h"
#include "viewer/model/camera_controller.h"
#include "viewer/model/display_settings.h"
#include "viewer/model/scene_document.h"
#include "viewer/window/script.h"

namespace glint {
namespace {

SceneDescription smallScene() {
    SceneDescription scene;
    scene.materials.resize(2);
    scene.lights.resize(1);
    scene.objects.resize(2);
    scene.objects[0].material = 0;
    scene.objects[1].material = 1;
    scene.textures.resize(1);
    return scene;
}

template <class Change>
EditKind kindOf(Change change) {
    const SceneDescription before = smallScene();
    SceneDescription after = before;
    change(after);
    return differences(before, after);
}

TEST(SceneDiff, EachChangeIsTheSmallestEdit) {
    using S = SceneDescription;
    EXPECT_EQ(kindOf([](S&) {}), EditKind::None);
    EXPECT_EQ(kindOf([](S& s) { s.title = "x"; }), EditKind::None);
    EXPECT_EQ(kindOf([](S& s) { s.camera.apertureDiameter = 0.1f; }), EditKind::Camera);
    EXPECT_EQ(kindOf([](S& s) { s.camera.apertureBlades = 6; }), EditKind::Camera);
    EXPECT_EQ(kindOf([](S& s) { s.camera.bladeRotationDeg = 5.0f; }), EditKind::Camera);
    EXPECT_EQ(kindOf([](S& s) { s.resolution.width = 100; }), EditKind::Resolution);
    EXPECT_EQ(kindOf([](S& s) { s.options.maxDepth = 3; }), EditKind::Options);
    EXPECT_EQ(kindOf([](S& s) { s.options.fireflyClamp = 3.0f; }), EditKind::Options);
    EXPECT_EQ(kindOf([](S& s) { s.options.integrator = IntegratorKind::Sppm; }), EditKind::Integrator);
    EXPECT_EQ(kindOf([](S& s) {
                  s.options.integrator = IntegratorKind::Sppm;
                  s.options.seed = 3;
              }),
              EditKind::Integrator | EditKind::Options);
    EXPECT_EQ(kindOf([](S& s) { s.sppm.radiusWorld = 0.1f; }), EditKind::SppmParameters);
    EXPECT_EQ(kindOf([](S& s) { s.sppm.lookup = PhotonLookupKind::Tree; }), EditKind::SppmParameters);
    EXPECT_EQ(kindOf([](S& s) { s.materials[1].color.value = Vec3(0.1f); }), EditKind::MaterialParameters);
    EXPECT_EQ(kindOf([](S& s) { s.materials[1].emission.value = Vec3(1.0f); }), EditKind::MaterialParameters);
    EXPECT_EQ(kindOf([](S& s) { s.materials[0].roughness.value = 0.3f; }), EditKind::MaterialParameters);
    EXPECT_EQ(kindOf([](S& s) { s.materials[1].kind = MaterialKind::Mirror; }), EditKind::MaterialKind);
    EXPECT_EQ(kindOf([](S& s) { s.materials[1].color.texture = 0; }), EditKind::MaterialKind);
    EXPECT_EQ(kindOf([](S& s) { s.lights[0].strength = 2.0f; }), EditKind::Lights);
    EXPECT_EQ(kindOf([](S& s) { s.environment.rotationDeg = 2.0f; }), EditKind::Lights);
    EXPECT_EQ(kindOf([](S& s) { s.objects[0].objectToWorld.translation.x = 1.0f; }),
              EditKind::ObjectTransform);
    EXPECT_EQ(kindOf([](S& s) { s.objects.pop_back(); }), EditKind::Everything);
    EXPECT_EQ(kindOf([](S& s) {
                  s.camera.position.x = 1.0f;
                  s.lights[0].color.x = 3.0f;
              }),
              EditKind::Camera | EditKind::Lights);
}

TEST(SceneDiff, WhatNothingUsesIsNoEdit) {
    using S = SceneDescription;
    SceneDescription before = smallScene();
    before.materials.resize(4);
    before.textures.resize(2);
    before.meshes.resize(1);
    const auto kindFrom = [&](auto change) {
        SceneDescription after = before;
        change(after);
        return differences(before, after);
    };
    EXPECT_EQ(kindFrom([](S& s) { s.materials[3].kind = MaterialKind::Mirror; }), EditKind::None);
    EXPECT_EQ(kindFrom([](S& s) { s.materials[3].emission.value = Vec3(1.0f); }), EditKind::None);
    EXPECT_EQ(kindFrom([](S& s) { s.textures[1].scale = Vec2(2.0f); }), EditKind::None);
    EXPECT_EQ(kindFrom([](S& s) { s.meshes[0].data = std::make_shared<MeshData>(); }), EditKind::None);
    EXPECT_EQ(kindFrom([](S& s) { s.objects[0].material = 3; }), EditKind::Everything);
    EXPECT_EQ(kindFrom([](S& s) { s.materials[0].color.texture = 1; }), EditKind::MaterialKind);
}

TEST(SceneDocument, HandsOverEachEditOnce) {
    SceneDocument document;
    EXPECT_FALSE(document.isOpen());
    document.adopt(smallScene());
    EXPECT_EQ(document.takeEdits().kinds, EditKind::None);
    document.draft().lights[0].strength = 2.0f;
    document.draft().materials[0].roughness.value = 0.3f;
    const auto before = document.posted();
    EXPECT_EQ(document.takeEdits().kinds, EditKind::Lights | EditKind::MaterialParameters);
    EXPECT_EQ(document.posted()->lights[0].strength, 2.0f);
    EXPECT_NE(before->lights[0].strength, 2.0f) << "posted versions are immutable";
    EXPECT_EQ(document.takeEdits().kinds, EditKind::None);
}

TEST(SceneDocument, FocusFollowsTheTargetWhereItWasOnIt) {
    SceneDescription scene = smallScene();
    scene.camera.position = {0, 0, 4};
    scene.camera.target = {0, 0, 0};
    scene.camera.apertureDiameter = 0.1f;
    scene.camera.focalDistance = 4.0f;
    SceneDocument document;
    document.adopt(scene);
    document.draft().camera.position.z = 3.0f;
    EXPECT_EQ(document.takeEdits().kinds, EditKind::Camera);
    EXPECT_EQ(document.posted()->camera.focalDistance, 3.0f);
    scene.camera.focalDistance = 2.0f;
    document.adopt(scene);
    document.draft().camera.position.z = 3.0f;
    (void)document.takeEdits();
    EXPECT_EQ(document.posted()->camera.focalDistance, 2.0f) << "its author focused elsewhere";
}

TEST(DisplaySettings, AnyTwoIntegratorsAreCompared) {
    DisplaySettings display;
    for (const IntegratorInfo& own : kIntegratorTable) {
        EXPECT_NE(display.otherOf(own.kind), own.kind);
        for (const IntegratorInfo& other : kIntegratorTable) {
            if (other.kind == own.kind) { continue; }
            display.comparedWith = other.kind;
            EXPECT_EQ(display.otherOf(own.kind), other.kind);
            const auto [left, right] = display.pairOf(own.kind);
            EXPECT_LT(left, right) << "sides do not change with the scene's integrator";
        }
        display.comparedWith.reset();
    }
}

TEST(CameraController, OrbitKeepsTheDistanceAndStopsShortOfThePoles) {
    Camera camera;
    const float distance = targetDistance(camera);
    for (int i = 0; i < 50; ++i) {
        orbit(&camera, {13.0f, 40.0f}, 500.0f);
    }
    EXPECT_NEAR(targetDistance(camera), distance, 1e-3f * distance);
    const Vec3 direction = glm::normalize(camera.position - camera.target);
    EXPECT_LT(std::fabs(direction.y), 0.99999f);
    EXPECT_GT(direction.y, 0.9f);
}

TEST(CameraController, PanKeepsWhatIsUnderTheMouse) {
    Camera camera;
    const float height = 400.0f;
    const Vec3 target = camera.target;
    pan(&camera, {100.0f, 0.0f}, height);
    const float shown = 2.0f * 5.0f * std::tan(20.0f * kPi / 180.0f);  // metres over the picture's height
    EXPECT_NEAR(camera.target.x - target.x, -100.0f / height * shown, 1e-4f);
    EXPECT_NEAR(targetDistance(camera), 5.0f, 1e-4f);
}

TEST(CameraController, DollyNeverReachesTheTarget) {
    Camera camera;
    for (int i = 0; i < 100; ++i) {
        dolly(&camera, 3.0f);
    }
    EXPECT_GT(targetDistance(camera), 0.0f);
    Camera other;
    dolly(&other, 1.0f);
    dolly(&other, -1.0f);
    EXPECT_NEAR(targetDistance(other), 5.0f, 1e-4f);
}

TEST(CameraController, ProjectionsShowAsMuchOfTheTarget) {
    Camera camera;
    camera.shift = {0.3f, 0.1f};
    const float height = heightOfView(camera, 5.0f);
    setProjection(&camera, ProjectionKind::Orthographic);
    EXPECT_FLOAT_EQ(camera.viewHeight, height);
    EXPECT_EQ(heightOfView(camera, 50.0f), camera.viewHeight);
    dolly(&camera, 1.0f);
    EXPECT_LT(camera.viewHeight, 0.95f * height);
    EXPECT_EQ(targetDistance(camera), 5.0f);
    dolly(&camera, -1.0f);
    const Vec3 target = camera.target;
    pan(&camera, {0.0f, 40.0f}, 400.0f);
    EXPECT_NEAR(camera.target.y - target.y, 0.1f * height, 1e-5f);
    setProjection(&camera, ProjectionKind::Perspective);
    EXPECT_NEAR(camera.verticalFovDeg, 40.0f, 1e-3f);
    setProjection(&camera, ProjectionKind::Orthographic);
    frameBounds(&camera, {Vec3(9.0f), Vec3(11.0f)}, 0.5f);
    EXPECT_GE(0.5f * camera.viewHeight, 2.0f * std::sqrt(3.0f));
    EXPECT_LE(camera.viewHeight, 4.8f * std::sqrt(3.0f));
    EXPECT_GT(targetDistance(camera), std::sqrt(3.0f)) << "nothing is behind it";
    EXPECT_EQ(camera.shift, Vec2(0.0f));
}

TEST(CameraBookmarks, KeepProjectionsAndReadOlderFiles) {
    const test::TempFolder folder;
    const std::string file = folder.write("views", "/s.json\nView 1\n1 2 3 0 0 0 0 1 0 35 1 0.1 4 6 20 \n");
    CameraBookmarks old;
    old.begin(file);
    ASSERT_EQ(old.of("/s.json").size(), 1u);
    EXPECT_EQ(old.of("/s.json")[0].camera.kind, ProjectionKind::Perspective);
    EXPECT_EQ(old.of("/s.json")[0].camera.bladeRotationDeg, 20.0f);
    Camera camera;
    camera.kind = ProjectionKind::Orthographic;
    camera.viewHeight = 7.5f;
    camera.shift = {0.25f, -0.5f};
    old.add("/s.json", camera);
    CameraBookmarks read;
    read.begin(file);
    ASSERT_EQ(read.of("/s.json").size(), 2u);
    const Camera& kept = read.of("/s.json")[1].camera;
    EXPECT_EQ(kept.kind, ProjectionKind::Orthographic);
    EXPECT_EQ(kept.viewHeight, 7.5f);
    EXPECT_EQ(kept.shift, Vec2(0.25f, -0.5f));
}

TEST(CameraController, FramePutsTheWholeSphereInTheImage) {
    Camera camera;
    frameBounds(&camera, {Vec3(9.0f), Vec3(11.0f)}, 1.0f);
    EXPECT_EQ(camera.target, Vec3(10.0f));
    EXPECT_GE(targetDistance(camera) * std::sin(20.0f * kPi / 180.0f), std::sqrt(3.0f));
    EXPECT_LE(targetDistance(camera) * std::sin(20.0f * kPi / 180.0f), 1.2f * std::sqrt(3.0f));
}

TEST(Script, ReadsStatementsCommentsAndQuotes) {
    const auto script =
        parseScript("# nothing\n  set \"Field of view\" 35 # wide\n\nwait passes 3\nquit\n", "s.txt");
    ASSERT_TRUE(script) << script.error().format();
    ASSERT_EQ(script->size(), 3u);
    EXPECT_EQ((*script)[0].words[0].text, "Field of view");
    EXPECT_EQ((*script)[0].place.line, 2);
    EXPECT_EQ((*script)[0].place.column, 3);
    EXPECT_EQ((*script)[1].number(1), 3.0f);
}

TEST(Script, ErrorsNameTheirPlace) {
    const struct {
        const char* text;
        const char* beginning;
        const char* part;
    } cases[] = {
        {"wait picture\nclik 3 4\n", "s.txt:2:1:", "click"},
        {"move 3 x\n", "s.txt:1:8:", "move X Y"},
        {"move 3\n", "s.txt:1:7:", "incomplete"},
        {"wait passes\n", "s.txt:1:12:", "wait passes"},
        {"set \"Aperture 3\n", "s.txt:1:5:", "closing"},
        {"press sideways\n", "s.txt:1:7:", "left|right|middle"},
        {"key hyperspace\n", "s.txt:1:5:", "key NAME"},
        {"quit now\n", "s.txt:1:6:", "now"},
        {"wait passes -1\n", "s.txt:1:13:", "wait passes"},
        {"wait frames 1e30\n", "s.txt:1:13:", "wait passes|frames"},
        {"wait frames 2.5\n", "s.txt:1:13:", "wait passes|frames"},
        {"wait seconds nan\n", "s.txt:1:14:", "wait seconds"},
        {"wait seconds -1\n", "s.txt:1:14:", "wait seconds"},
        {"expect restarts nan\n", "s.txt:1:17:", "expect COUNTER N"},
        {"expect passes-at-least nan\n", "s.txt:1:24:", "expect passes-at-least N"},
        {"move inf 0\n", "s.txt:1:6:", "move X Y"},
        {"drag Exposure 30\n", "s.txt:1:17:", "incomplete"},
    };
    for (const auto& c : cases) {
        const auto script = parseScript(c.text, "s.txt");
        ASSERT_FALSE(script) << c.text;
        EXPECT_THAT(script.error().format(), testing::StartsWith(c.beginning)) << c.text;
        EXPECT_THAT(script.error().format(), testing::HasSubstr(c.part)) << c.text;
    }
}

TEST(Script, AFileThatIsNoneIsRefusedAtOnce) {
    std::remove("script.pipe");
    ASSERT_EQ(mkfifo("script.pipe", 0600), 0);
    for (const char* name : {"script.pipe", ".", "no-such-script.txt"}) {
        const auto script = loadScript(name);
        ASSERT_FALSE(script) << name;
        EXPECT_THAT(script.error().format(), testing::StartsWith(std::string(name) + ": "));
    }
}

}  // namespace
}  // namespace glint
