// Where the camera stands and what its lens does.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/model/camera_controller.h"
#include "viewer/model/scene_document.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

constexpr float kLargestFStop = 1000.0f;

void drawView(SceneDocument* document) {
    Camera* camera = &document->draft().camera;
    // Dragging feels alike in a doll's house and in a cathedral.
    const float speed = std::max(targetDistance(*camera) * 0.002f, 1e-6f);
    ui::vector3("Position", &camera->position,
                {.format = "%.3f", .speed = speed, .tooltip = "x, y, z in metres"});
    ui::vector3("Target", &camera->target,
                {.format = "%.3f",
                 .speed = speed,
                 .tooltip = "What the camera looks at and orbits around, in metres"});
    Vec3 up = camera->up;
    if (ui::vector3("Up", &up, {.format = "%.3f", .speed = 0.005f, .tooltip = "What is up in the picture"}) &&
        lengthSquared(up) > 0.0f) {
        camera->up = up;
    }
    ui::number(
        "Field of view", &camera->verticalFovDeg,
        {.format = "%.1f°", .speed = 0.1f, .min = 1.0f, .max = 170.0f, .tooltip = "Vertical, full angle"});
    const float width = ui::buttonWidth(2);
    if (ui::button("Frame", width, "Moves back or closer until everything is in the picture (F)")) {
        document->frameScene();
    }
    ImGui::SameLine();
    if (ui::button("Reset", width, "The scene file's camera (Home)")) { document->resetCamera(); }
}

void drawLens(SceneDocument* document) {
    Camera* camera = &document->draft().camera;
    ui::heading("Lens");
    float diameterMm = camera->apertureDiameter * 1000.0f;
    const float speed = std::max(camera->focalDistance * 0.1f, 0.001f);
    if (ui::number("Aperture", &diameterMm,
                   {.format = diameterMm < 10.0f ? "%.2f mm" : "%.1f mm",
                    .speed = speed,
                    .max = 1e6f,
                    .zeroText = "pinhole",
                    .tooltip = "Diameter of the lens opening. 0: everything is sharp"})) {
        camera->apertureDiameter = diameterMm / 1000.0f;
    }
    float stop = std::min(fStop(*camera), kLargestFStop);
    const bool pinhole = camera->apertureDiameter <= 0.0f;
    if (ui::number("f-stop", &stop,
                   {.format = pinhole ? "–" : "f/%.2f",
                    .speed = std::max(stop * 0.01f, 1e-4f),
                    .min = 1e-4f,
                    .max = kLargestFStop,
                    .tooltip = "Focal length over diameter, for a full-frame sensor"})) {
        camera->apertureDiameter = apertureForFStop(*camera, stop);
    }
    if (ui::number("Focal distance", &camera->focalDistance,
                   {.format = "%.3f m",
                    .speed = std::max(camera->focalDistance * 0.004f, 1e-6f),
                    .min = 1e-6f,
                    .max = 1e9f,
                    .tooltip = "Along the view axis, to the plane that is sharp"})) {
        document->focusFollowsTarget = false;
    }
    if (ui::toggle("Focus on target", &document->focusFollowsTarget,
                   "Keeps the target sharp while the camera orbits, flies or comes closer") &&
        document->focusFollowsTarget) {
        camera->focalDistance = targetDistance(*camera);
    }
    int blades = camera->apertureBlades;
    if (ui::integer("Blades", &blades,
                    {.format = "%d",
                     .speed = 0.05f,
                     .max = 32.0f,
                     .zeroText = "round",
                     .tooltip = "Corners of the opening; 0: a circle"})) {
        // One and two blades have no area.
        camera->apertureBlades = blades >= 3 ? blades : (blades > camera->apertureBlades ? 3 : 0);
    }
    ui::number("Blade rotation", &camera->bladeRotationDeg,
               {.format = "%.1f°",
                .speed = 0.5f,
                .min = -360.0f,
                .max = 360.0f,
                .tooltip = "Turns the corners of the opening"});
}

void draw(SceneDocument* document) {
    drawView(document);
    drawLens(document);
}

}  // namespace

Panel cameraPanel() { return {"Camera", true, OfParts<draw>::call, WithoutScene::Hints}; }

}  // namespace glint
