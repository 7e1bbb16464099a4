// What the lens does: the aperture, where it focuses, and what is sharp.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/base/units.h"
#include "viewer/model/camera_controller.h"
#include "viewer/model/key_map.h"
#include "viewer/model/lens_settings.h"
#include "viewer/model/scene_document.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

constexpr float kLargestFStop = 1e9f;
constexpr float kStopOfPinhole = 1000.0f;  // where a drag out of it begins
constexpr float kShapeUnits = 26.0f;       // radius
constexpr int kRoundCorners = 48;

void drawFocalLength(Camera* camera, LensSettings* lens) {
    std::vector<std::string_view> names;
    for (const SensorSize& size : sensorSizes()) {
        names.emplace_back(size.name);
    }
    auto sensor = static_cast<int>(lens->sensor);
    if (ui::choice("Sensor", &sensor, names, "Its height makes a focal length of the field of view")) {
        lens->sensor = static_cast<size_t>(sensor);
    }
    if (sensorSizes()[lens->sensor].heightMm <= 0.0f) {
        ui::number("Sensor height", &lens->customHeightMm,
                   {.format = "%.1f mm", .speed = 0.1f, .min = 0.1f, .max = 1000.0f});
    }
    const float sensorMm = lens->sensorHeightMm();
    float focalLength = focalLengthMm(*camera, sensorMm);
    if (ui::number("Focal length", &focalLength,
                   {.format = "%.1f mm",
                    .speed = std::max(focalLength * 0.004f, 0.01f),
                    .min = sensorMm * 0.05f,
                    .max = sensorMm * 50.0f,
                    .tooltip = "Changes the field of view, and the aperture so that the f-stop stays"})) {
        const float stop = fStop(*camera, sensorMm);
        camera->verticalFovDeg = fovDegForFocalLength(focalLength, sensorMm);
        camera->apertureDiameter = apertureForFStop(*camera, stop, sensorMm);
    }
}

void drawAperture(Camera* camera, float sensorMm) {
    float diameterMm = camera->apertureDiameter * 1000.0f;
    if (ui::number("Aperture", &diameterMm,
                   {.format = diameterMm < 10.0f ? "%.2f mm" : "%.1f mm",
                    .speed = std::max(camera->focalDistance * 0.1f, 0.001f),
                    .max = 1e6f,
                    .zeroText = "pinhole",
                    .tooltip = "Diameter of the lens opening. 0: everything is sharp"})) {
        camera->apertureDiameter = diameterMm / 1000.0f;
    }
    if (camera->kind == ProjectionKind::Orthographic) { return; }  // no focal length
    const bool isPinhole = camera->apertureDiameter <= 0.0f;
    float stop = isPinhole ? kStopOfPinhole : std::min(fStop(*camera, sensorMm), kLargestFStop);
    if (ui::number("f-stop", &stop,
                   {.format = isPinhole ? "–" : "f/%.2f",
                    .speed = std::max(stop * 0.01f, 1e-4f),
                    .min = 1e-4f,
                    .max = kLargestFStop,
                    .tooltip = "Focal length over diameter"})) {
        camera->apertureDiameter = apertureForFStop(*camera, stop, sensorMm);
    }
    const float width = ui::buttonWidth(2);
    const auto step = [&](int thirds) {
        // Out of a pinhole, the first step is the usual smallest opening.
        const float next = isPinhole ? 22.0f : fStopInThirds(fStop(*camera, sensorMm), thirds);
        camera->apertureDiameter = apertureForFStop(*camera, next, sensorMm);
    };
    if (ui::button("Open by 1/3", width, "A third of a stop more light: less is sharp")) { step(-1); }
    ImGui::SameLine();
    if (ui::button("Close by 1/3", width, "A third of a stop less light: more is sharp")) { step(1); }
}

void drawFocus(SceneDocument* document, LensSettings* lens, const KeyMap& keys) {
    Camera* camera = &document->draft().camera;
    if (ui::number("Focal distance", &camera->focalDistance,
                   {.format = "%.3f m",
                    .speed = std::max(camera->focalDistance * 0.004f, 1e-6f),
                    .min = 1e-6f,
                    .max = 1e9f,
                    .tooltip = "Along the view axis, to the plane that is sharp"})) {
        document->focusFollowsTarget = false;
        document->focusObject = -1;
    }
    if (ui::toggle("Focus on target", &document->focusFollowsTarget,
                   "Keeps the target sharp while the camera orbits, flies or comes closer") &&
        document->focusFollowsTarget) {
        document->focusObject = -1;
        camera->focalDistance = targetDistance(*camera);
    }
    const char* label = lens->picksFocus ? "Click on the picture…" : "Click to focus";
    const std::string tip = keys.tip("Ctrl + click on the picture, or a key over it", KeyAction::Focus);
    if (ui::button(label, ui::buttonWidth(1), tip.c_str(), lens->picksFocus)) {
        lens->picksFocus = !lens->picksFocus;
    }
}

std::string distanceText(float metres) {
    return std::isfinite(metres) ? length(static_cast<double>(metres)) : "infinity";
}

void drawSharpness(const SceneDescription& scene, LensSettings* lens) {
    static constexpr ui::KindLabel<FocusOverlayKind> kOverlays[]{
        {FocusOverlayKind::None, "Off"},
        {FocusOverlayKind::Sharp, "What is sharp"},
        {FocusOverlayKind::Blur, "Circles of confusion"}};
    const Camera& camera = scene.camera;
    const SharpRange range = sharpRange(camera, lens->sharpPixels, scene.resolution.height);
    ui::value("Near limit", distanceText(range.nearLimit), "Sharp from here, along the view axis");
    ui::value("Far limit", distanceText(range.farLimit), "Sharp up to here, along the view axis");
    ui::value("Hyperfocal", camera.apertureDiameter > 0.0f ? distanceText(range.hyperfocal) : "–",
              "Focused here, everything from half of it to infinity is sharp");
    ui::kindChoice("Focus overlay", &lens->overlay, kOverlays,
                   "Over the picture, without noise. Sharp: green, and yellow where the plane in focus cuts. "
                   "Circles: blue in front of the focus, orange behind it, stronger up to 64 pixels");
    ui::number("Sharp within", &lens->sharpPixels,
               {.format = "%.1f px",
                .speed = 0.02f,
                .min = 0.1f,
                .max = 64.0f,
                .tooltip = "The largest circle of confusion that counts as sharp, in pixels of the picture"});
}

/// As seen through the lens from behind: what a highlight far out of focus looks like.
void drawApertureShape(const Camera& camera) {
    const float radius = kShapeUnits * ui::scale();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::Dummy({width, 2.4f * radius});
    const ImVec2 middle{corner.x + width * 0.5f, corner.y + 1.2f * radius};
    const int blades = camera.apertureBlades;
    const int corners = blades >= 3 ? blades : kRoundCorners;
    const float turned = camera.bladeRotationDeg * kPi / 180.0f;
    std::vector<ImVec2> points;
    for (int i = 0; i < corners; ++i) {
        const float phi = turned + 2.0f * kPi * static_cast<float>(i) / static_cast<float>(corners);
        points.emplace_back(middle.x + radius * std::cos(phi), middle.y - radius * std::sin(phi));
    }
    ImGui::GetWindowDrawList()->AddConvexPolyFilled(points.data(), corners, IM_COL32(225, 215, 190, 255));
    ui::itemArea("Aperture shape", blades >= 3 ? fmt::format("{} corners", blades) : "round");
}

void drawBlades(Camera* camera) {
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
    if (camera->apertureDiameter > 0.0f) { drawApertureShape(*camera); }
}

void draw(SceneDocument* document, LensSettings* lens, const KeyMap* keys) {
    Camera* camera = &document->draft().camera;
    if (camera->kind == ProjectionKind::Perspective) { drawFocalLength(camera, lens); }
    drawAperture(camera, lens->sensorHeightMm());
    drawFocus(document, lens, *keys);
    drawSharpness(document->draft(), lens);
    drawBlades(camera);
}

}  // namespace

Panel lensPanel() { return {"Lens", true, OfParts<draw>::call, WithoutScene::Hides}; }

}  // namespace glint
