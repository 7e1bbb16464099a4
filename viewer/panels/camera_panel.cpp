// Where the camera stands, and how much it sees.
#include <algorithm>
#include <string>

#include <imgui.h>

#include "viewer/base/camera_bookmarks.h"
#include "viewer/model/camera_controller.h"
#include "viewer/model/key_map.h"
#include "viewer/model/scene_document.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

void drawBookmarks(SceneDocument* document, CameraBookmarks* bookmarks) {
    Camera* camera = &document->draft().camera;
    const std::string& path = document->draft().path;
    if (ui::button("Bookmark this view", ui::buttonWidth(1), "Kept for this scene, lens and all")) {
        bookmarks->add(path, *camera);
    }
    for (const CameraBookmarks::Bookmark& each : bookmarks->of(path)) {
        const float half = ui::buttonWidth(2);
        if (ui::button(each.name.c_str(), half, "Goes there")) {
            *camera = each.camera;
            document->nameEdit(each.name);
        }
        ImGui::SameLine();
        if (ui::button(("Forget " + each.name).c_str(), half)) { bookmarks->remove(each); }
    }
}

void drawProjection(Camera* camera, float speed) {
    static constexpr ui::KindLabel<ProjectionKind> kProjections[]{
        {ProjectionKind::Perspective, "Perspective"}, {ProjectionKind::Orthographic, "Orthographic"}};
    ProjectionKind kind = camera->kind;
    if (ui::kindChoice("Projection", &kind, kProjections,
                       "Orthographic: parallel rays, nothing is smaller for being far away")) {
        setProjection(camera, kind);
    }
    if (camera->kind == ProjectionKind::Orthographic) {
        ui::number("View height", &camera->viewHeight,
                   {.format = "%.3f m",
                    .speed = speed,
                    .min = 1e-6f,
                    .max = 1e9f,
                    .tooltip = "From the picture's bottom to its top"});
    } else {
        ui::number("Field of view", &camera->verticalFovDeg,
                   {.format = "%.1f°",
                    .speed = 0.1f,
                    .min = 1.0f,
                    .max = 170.0f,
                    .tooltip = "Vertical, full angle"});
    }
    const ui::NumberStyle shift{.format = "%.3f",
                                .speed = 0.002f,
                                .min = -100.0f,
                                .max = 100.0f,
                                .tooltip =
                                    "The picture's middle off the view axis, in heights of the picture: "
                                    "verticals stay upright while a house's top comes into the picture"};
    ui::number("Shift right", &camera->shift.x, shift);
    ui::number("Shift up", &camera->shift.y, shift);
}

void draw(SceneDocument* document, CameraBookmarks* bookmarks, const KeyMap* keys) {
    Camera* camera = &document->draft().camera;
    // Dragging feels alike in a doll's house and in a cathedral.
    const float speed = std::max(targetDistance(*camera) * 0.002f, 1e-6f);
    ui::vector3("Position", &camera->position,
                {.format = "%.3f", .speed = speed, .tooltip = "x, y, z in metres", .unit = "m"});
    ui::vector3("Target", &camera->target,
                {.format = "%.3f",
                 .speed = speed,
                 .tooltip = "What the camera looks at and orbits around, in metres",
                 .unit = "m"});
    Vec3 up = camera->up;
    if (ui::vector3("Up", &up, {.format = "%.3f", .speed = 0.005f, .tooltip = "What is up in the picture"}) &&
        lengthSquared(up) > 0.0f) {
        camera->up = up;
    }
    drawProjection(camera, speed);
    const float width = ui::buttonWidth(2);
    const std::string frames =
        keys->tip("Moves back or closer until everything is in the picture", KeyAction::FrameScene);
    if (ui::button("Frame", width, frames.c_str())) { document->frameScene(); }
    ImGui::SameLine();
    const std::string resets = keys->tip("The scene file's camera", KeyAction::ResetCamera);
    if (ui::button("Reset", width, resets.c_str())) { document->resetCamera(); }
    drawBookmarks(document, bookmarks);
}

}  // namespace

Panel cameraPanel() { return {"Camera", true, OfParts<draw>::call, WithoutScene::Hints}; }

}  // namespace glint
