// Places in numbers, and handles on the screen: without a window.
#include "viewer/model/gizmo.h"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/builders/camera_builder.h"
#include "engine/kernels/camera_ray.h"
#include "viewer/model/placement.h"

namespace glint {
namespace {

void expectNear(const Affine& a, const Affine& b, float tolerance) {
    for (int i = 0; i < 3; ++i) {
        EXPECT_LT(glm::length(a.linear[i] - b.linear[i]), tolerance);
    }
    EXPECT_LT(glm::length(a.translation - b.translation), tolerance);
}

TEST(Placement, NumbersMakeThePlaceAgain) {
    for (const Vec3 turn : {Vec3(0.0f), Vec3(30, -50, 140), Vec3(-170, 10, 5), Vec3(0, 90, 0)}) {
        for (const Vec3 size : {Vec3(1, 2, 3), Vec3(-0.5f, 0.5f, 0.5f)}) {
            const Affine placed{rotationFromDegrees(turn) * scale(size).linear, {4, 5, 6}};
            const PlacementNumbers numbers = numbersOf(placed);
            const Affine again{rotationFromDegrees(numbers.rotationDeg) * scale(numbers.scale).linear,
                               numbers.position};
            expectNear(again, placed, 1e-5f);
        }
    }
}

TEST(Placement, EditsKeepShears) {
    Affine sheared{Mat3({1, 0, 0}, {0.7f, 1, 0}, {0, 0.2f, 2}), {0, 0, 0}};
    const PlacementNumbers before = numbersOf(sheared);
    expectNear(withNumbers(sheared, before, before), sheared, 1e-6f);
    PlacementNumbers after = before;
    after.rotationDeg = before.rotationDeg + Vec3(0, 0, 90);
    const Affine turned = withNumbers(sheared, before, after);
    EXPECT_NEAR(glm::dot(turned.linear[0], turned.linear[1]), glm::dot(sheared.linear[0], sheared.linear[1]),
                1e-5f);
    EXPECT_NEAR(turned.determinant(), sheared.determinant(), 1e-4f);
}

struct OnScreen {
    Camera camera;
    PlacedImage placed{{0, 0}, {800, 600}, 1.0f, 1.0f};
    OnScreen() {
        camera.position = {0, 1, 4};
        camera.target = {0, 1, 0};
    }
    ScreenView view() const { return {camera, {800, 600}, placed}; }
};

TEST(Gizmo, ProjectsAsTheCameraSees) {
    const OnScreen screen;
    const auto middle = screen.view().project({0, 1, 0});
    ASSERT_TRUE(middle);
    EXPECT_NEAR(middle->x, 400, 1e-3f);
    EXPECT_NEAR(middle->y, 300, 1e-3f);
    EXPECT_FALSE(screen.view().project({0, 1, 5}));
    for (const Vec3 point : {Vec3(1, 2, -1), Vec3(-0.4f, 0.3f, 1)}) {
        const auto at = screen.view().project(point);
        const Vec3 towards = glm::normalize(point - screen.camera.position);
        EXPECT_LT(glm::length(screen.view().rayAt(*at).direction - towards), 1e-5f);
    }
}

/// A point's place on the screen is where the picture shows it: the camera's ray through that place meets it.
TEST(Gizmo, ProjectsAsTheRendererSees) {
    OnScreen screen;
    Camera& camera = screen.camera;
    camera.target = {0.3f, 0.2f, -1};
    camera.horizontalScale = 1.2f;
    camera.viewHeight = 3.0f;
    for (const ProjectionKind kind : {ProjectionKind::Perspective, ProjectionKind::Orthographic}) {
        for (const Vec3 up : {Vec3(0.2f, 1, 0), camera.position - camera.target}) {
            for (const Vec2 shift : {Vec2(0.0f), Vec2(0.25f, -0.6f)}) {
                camera.kind = kind;
                camera.up = up;
                camera.shift = shift;
                const CameraData data = *buildCamera(camera, 800.0f / 600.0f);
                for (const Vec3 point : {Vec3(1, 2, -1), Vec3(-0.4f, 0.3f, 1)}) {
                    const Vec2 at = *screen.view().project(point);
                    const Vec2 ndc(at.x / 400.0f - 1.0f, 1.0f - at.y / 300.0f);
                    const Ray ray = cameraRay<kFeatureCameraArea>(data, ndc, Vec2(0.0f));
                    const float t = glm::dot(point - ray.origin, ray.direction);
                    EXPECT_LT(glm::length(ray.at(t) - point), 2e-5f);
                    const Ray own = screen.view().rayAt(at);
                    EXPECT_LT(glm::length(own.origin - ray.origin), 1e-5f);
                    EXPECT_LT(glm::length(own.direction - ray.direction), 1e-5f);
                }
            }
        }
    }
}

TEST(Gizmo, HandlesFollowTheMouseUnderParallelRays) {
    OnScreen screen;
    screen.camera.kind = ProjectionKind::Orthographic;
    screen.camera.shift = {0.1f, 0.2f};
    const Affine placed = translate({0.2f, 1, 0});
    GizmoSettings settings{.mode = GizmoMode::Move};
    Gizmo gizmo;
    const auto handles = gizmo.handles(placed, settings, screen.view(), 80.0f);
    EXPECT_NEAR(glm::length(handles[0].line.back() - handles[0].line.front()), 80.0f, 0.1f);
    for (const GizmoHandle& handle : {handles[1], handles[3]}) {
        const Vec2 from = handle.line.back();
        gizmo.begin(handle, placed, settings, screen.view(), from);
        const Affine moved = gizmo.drag(settings, screen.view(), from + Vec2(0, 60), false);
        EXPECT_NEAR(moved.translation.y, 1.0f - 60.0f / 600.0f * screen.camera.viewHeight, 1e-5f);
        EXPECT_NEAR(moved.translation.x, 0.2f, 1e-5f);
    }
}

TEST(Gizmo, AnAxisFollowsTheMouse) {
    const OnScreen screen;
    const Affine placed = translate({0.2f, 1, 0}) * scale(Vec3(0.5f));
    GizmoSettings settings{.mode = GizmoMode::Move};
    Gizmo gizmo;
    const auto handles = gizmo.handles(placed, settings, screen.view(), 80.0f);
    ASSERT_EQ(handles.size(), 4u);
    const Vec2 tip = handles[0].line.back();
    EXPECT_NEAR(tip.x - handles[0].line.front().x, 80.0f, 0.5f);
    const auto meant = Gizmo::nearest(handles, tip + Vec2(2, 3), 6.0f);
    ASSERT_TRUE(meant);
    EXPECT_EQ(meant->axis, 0);
    EXPECT_FALSE(Gizmo::nearest(handles, tip + Vec2(20, 20), 6.0f));
    gizmo.begin(*meant, placed, settings, screen.view(), tip);
    expectNear(gizmo.drag(settings, screen.view(), tip, false), placed, 0.0f + 1e-9f);
    // The point of the axis that was under the mouse stays under it.
    const Affine moved = gizmo.drag(settings, screen.view(), tip + Vec2(90, 40), false);
    const auto then = gizmo.handles(moved, settings, screen.view(), 80.0f);
    EXPECT_NEAR(then[0].line.back().x, tip.x + 90.0f, 0.5f);
    EXPECT_EQ(moved.translation.y, placed.translation.y);
    const Affine snapped = gizmo.drag(settings, screen.view(), tip + Vec2(90, 40), true);
    const float steps = (snapped.translation.x - 0.2f) / settings.moveStep;
    EXPECT_NEAR(steps, std::round(steps), 1e-4f);
}

/// A step and the one back are nothing; where it snaps, steps are the settings'.
TEST(Gizmo, KeysMoveTurnAndStretch) {
    const Affine placed = translate(Vec3(1, 2, 3)) * rotate(Vec3(0, 0, 1), 0.5f * kPi);
    GizmoSettings settings{
        .mode = GizmoMode::Move, .moveStep = 0.25f, .turnStepDeg = 90.0f, .scaleStep = 1.0f};
    const auto origin = [&](const GizmoNudge& by) {
        return Gizmo::nudged(placed, settings, by, 2.0f).translation;
    };
    EXPECT_NEAR(glm::length(origin({.axis = 0}) - Vec3(1.2f, 2, 3)), 0.0f, 1e-6f);
    EXPECT_NEAR(glm::length(origin({.axis = 1, .direction = -1.0f, .isFine = true}) - Vec3(1, 1.98f, 3)),
                0.0f, 1e-6f);
    EXPECT_EQ(origin({}), placed.translation) << "as a whole there is no way";
    settings.snaps = settings.isLocal = true;
    EXPECT_NEAR(glm::length(origin({.axis = 0}) - Vec3(1, 2.25f, 3)), 0.0f, 1e-6f) << "its own X is up";
    for (const GizmoMode mode : {GizmoMode::Move, GizmoMode::Rotate, GizmoMode::Scale}) {
        settings.mode = mode;
        for (const bool snaps : {false, true}) {
            settings.snaps = snaps;
            const Affine there = Gizmo::nudged(placed, settings, {.axis = 2}, 2.0f);
            EXPECT_GT(glm::length(there.translation - placed.translation) +
                          glm::length(there.linear[0] - placed.linear[0]) +
                          glm::length(there.linear[2] - placed.linear[2]),
                      0.04f);
            expectNear(Gizmo::nudged(there, settings, {.axis = 2, .direction = -1.0f}, 2.0f), placed, 1e-5f);
        }
    }
    const Affine larger = Gizmo::nudged(placed, settings, {}, 2.0f);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(glm::length(larger.linear[i]), 2.0f, 1e-5f);
    }
}

TEST(Gizmo, ARingTurnsAndABoxStretches) {
    const OnScreen screen;
    const Affine placed = translate({0, 1, 0}) * scale(Vec3(1, 2, 1));
    GizmoSettings settings{.mode = GizmoMode::Rotate};
    Gizmo gizmo;
    auto handles = gizmo.handles(placed, settings, screen.view(), 80.0f);
    ASSERT_EQ(handles.size(), 3u);
    // The ring about z faces the camera: a quarter of it, from right to top.
    gizmo.begin(handles[2], placed, settings, screen.view(), {480, 300});
    const Affine turned = gizmo.drag(settings, screen.view(), {400, 220}, false);
    EXPECT_LT(glm::length(turned.linear[0] - Vec3(0, 1, 0)), 1e-4f);
    EXPECT_EQ(turned.translation, placed.translation);
    settings.mode = GizmoMode::Scale;
    handles = gizmo.handles(placed, settings, screen.view(), 80.0f);
    const Vec2 tip = handles[1].line.back();
    gizmo.begin(handles[1], placed, settings, screen.view(), tip);
    const Affine stretched = gizmo.drag(settings, screen.view(), {400, 300 + 2 * (tip.y - 300)}, false);
    EXPECT_NEAR(glm::length(stretched.linear[1]), 4.0f, 1e-3f);
    EXPECT_EQ(stretched.linear[0], placed.linear[0]);
    EXPECT_TRUE(isInvertible(gizmo.drag(settings, screen.view(), {400, 900}, false))) << "never flat";
}

}  // namespace
}  // namespace glint
