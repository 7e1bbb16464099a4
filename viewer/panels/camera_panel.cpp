// Where the camera stands, and how much it sees.
#include <algorithm>
#include <string>

#include <imgui.h>

#include "viewer/base/camera_bookmarks.h"
#include "viewer/model/camera_controller.h"
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

void draw(SceneDocument* document, CameraBookmarks* bookmarks) {
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
    ui::number(
        "Field of view", &camera->verticalFovDeg,
        {.format = "%.1f°", .speed = 0.1f, .min = 1.0f, .max = 170.0f, .tooltip = "Vertical, full angle"});
    const float width = ui::buttonWidth(2);
    if (ui::button("Frame", width, "Moves back or closer until everything is in the picture (Shift + F)")) {
        document->frameScene();
    }
    ImGui::SameLine();
    if (ui::button("Reset", width, "The scene file's camera (Home)")) { document->resetCamera(); }
    drawBookmarks(document, bookmarks);
}

}  // namespace

Panel cameraPanel() { return {"Camera", true, OfParts<draw>::call, WithoutScene::Hints}; }

}  // namespace glint
