// The lights without a shape, and the environment. Shapes shine through their material.
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "engine/io/studio.h"
#include "viewer/model/image_choice.h"
#include "viewer/model/scene_document.h"
#include "viewer/model/scene_files.h"
#include "viewer/panels/asset_state.h"
#include "viewer/panels/gizmo_rows.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/portal_rows.h"
#include "viewer/panels/texture_row.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

constexpr ui::KindLabel<LightKind> kKinds[]{{LightKind::Point, "Point"},
                                            {LightKind::Spot, "Spot"},
                                            {LightKind::Directional, "Directional"},
                                            {LightKind::Projector, "Projector"},
                                            {LightKind::Goniometric, "Goniometric"}};

/// One colour, an image of the scene, a sky that is made, or a file.
void drawImage(SceneDocument* document, SceneFiles* files) {
    const std::vector<SceneImage>& images = document->draft().environmentImages;
    std::vector<std::string> names{"none"};
    for (size_t i = 0; i < images.size(); ++i) {
        const std::string path = pathOf(images[i].source);
        names.push_back(path.empty() ? fmt::format("image {}", i) : path);
    }
    names.emplace_back("Sky");
    names.emplace_back("From a file…");
    const std::vector<std::string_view> views(names.begin(), names.end());
    int& shown = document->draft().environment.image;
    int index = shown + 1;
    if (!ui::choice("Image", &index, views, "Latitude and longitude")) { return; }
    const size_t chosen = static_cast<size_t>(index);
    if (chosen <= images.size()) {
        shown = index - 1;
    } else if (chosen == images.size() + 1) {
        chooseSky(document);
    } else {
        files->dialog.ask({"Choose an environment", files->opened, false,
                           [document](const std::string& path) { chooseEnvironmentFile(document, path); }});
    }
}

void drawEnvironment(SceneDocument* document, SceneFiles* files, AssetReader* assets) {
    Environment* environment = &document->draft().environment;
    ui::heading("Environment");
    ui::color("Radiance", &environment->color, 1e6f, "W/(sr m²); multiplies the image where there is one");
    ui::number("Env. strength", &environment->strength, {.format = "× %.3f", .speed = 0.01f, .max = 1e6f});
    drawImage(document, files);
    drawAssetState(assets);
    drawPortalRows(document);
    ui::toggle("Background only", &environment->seenOnly, "The camera sees it, and it lights nothing");
    ui::number("Rotation", &environment->rotationDeg,
               {.format = "%.1f°",
                .speed = 0.5f,
                .min = -360.0f,
                .max = 360.0f,
                .tooltip = "About the vertical axis"});
}

/// None, one of the scene's textures, or a file.
void drawImageChoice(SceneDocument* document, SceneFiles* files, size_t number) {
    const std::vector<std::string> names = textureChoices(document->draft().textures);
    const std::vector<std::string_view> views(names.begin(), names.end());
    Light& light = document->draft().lights[number];
    int index = light.image.texture + 1;
    const char* tooltip =
        light.kind == LightKind::Projector
            ? "What is projected"
            : "The intensity by directions: a square of equal areas, the light's direction in "
              "its middle";
    if (!ui::choice("Picture", &index, views, tooltip)) { return; }
    if (static_cast<size_t>(index) + 1 < views.size()) {
        light.image.texture = index - 1;
        return;
    }
    files->dialog.ask({"Choose a picture", files->opened, false, [document, number](const std::string& path) {
                           chooseImageFile(document, number, path);
                       }});
}

void drawUp(Light* light) {
    Vec3 up = light->up;
    if (ui::vector3("Up", &up, {.format = "%.3f", .speed = 0.005f, .tooltip = "Upwards in the picture"}) &&
        lengthSquared(up) > 0.0f) {
        light->up = up;
    }
}

void drawProjection(Light* light) {
    ui::number("Width", &light->fovDeg,
               {.format = "%.1f°",
                .speed = 0.1f,
                .min = 0.1f,
                .max = 179.0f,
                .tooltip = "Full angle across the picture"});
    ui::number(
        "Aspect", &light->aspect,
        {.format = "%.3f", .speed = 0.01f, .min = 0.01f, .max = 100.0f, .tooltip = "Width over height"});
}

void drawLight(SceneDocument* document, SceneFiles* files, size_t number, float speed) {
    Light* light = &document->draft().lights[number];
    ui::kindChoice("Kind", &light->kind, kKinds);
    const bool directional = light->kind == LightKind::Directional;
    const bool projects = light->kind == LightKind::Projector;
    ui::color(directional || projects ? "Irradiance" : "Intensity", &light->color, 1e6f,
              directional ? "W/m² on a surface that faces it"
              : projects  ? "W/m² on a surface that faces it, 1 m away; multiplies the picture"
                          : "W/sr");
    ui::number("Strength", &light->strength,
               {.format = "× %.3f", .speed = std::max(light->strength * 0.01f, 0.01f), .max = 1e6f});
    if (!directional) {
        ui::vector3("Position", &light->position,
                    {.format = "%.3f", .speed = speed, .tooltip = "Metres", .unit = "m"});
    }
    if (light->kind != LightKind::Point) {
        Vec3 direction = light->direction;
        if (ui::vector3("Direction", &direction,
                        {.format = "%.3f", .speed = 0.005f, .tooltip = "Where the light travels"}) &&
            lengthSquared(direction) > 0.0f) {
            light->direction = direction;
        }
    }
    if (hasImage(light->kind)) {
        drawImageChoice(document, files, number);
        drawUp(light);
    }
    if (projects) { drawProjection(light); }
    if (light->kind != LightKind::Spot) { return; }
    ui::number("Cone", &light->coneAngleDeg,
               {.format = "%.1f°",
                .speed = 0.1f,
                .min = 0.1f,
                .max = 90.0f,
                .tooltip = "Half angle where the light ends"});
    ui::number(
        "Falloff from", &light->coneFalloffStartDeg,
        {.format = "%.1f°", .speed = 0.1f, .max = 90.0f, .tooltip = "Half angle where it begins to fade"});
    light->coneFalloffStartDeg = std::min(light->coneFalloffStartDeg, light->coneAngleDeg);
}

void drawLights(SceneDocument* document, SceneFiles* files, GizmoSettings* gizmo, const KeyMap& keys) {
    std::vector<Light>& lights = document->draft().lights;
    if (lights.empty()) {
        ui::hint("No point, spot or directional lights.");
        return;
    }
    std::vector<std::string> names;
    for (size_t i = 0; i < lights.size(); ++i) {
        names.push_back(lights[i].name.empty() ? fmt::format("light {}", i) : lights[i].name);
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    document->selectedLight = std::clamp(document->selectedLight, 0, static_cast<int>(lights.size()) - 1);
    if (ui::choice("Light", &document->selectedLight, views)) { document->selectedObject = -1; }
    ImGui::PushID(document->selectedLight);
    const float speed = std::max(maxComponent(document->bounds().extent()) * 0.002f, 1e-4f);
    drawLight(document, files, static_cast<size_t>(document->selectedLight),
              std::isfinite(speed) ? speed : 0.01f);
    ImGui::PopID();
    if (document->selectedObject < 0) { return drawGizmoRows(gizmo, keys); }
    if (ui::button("Handles", ui::buttonWidth(1), "Moves and turns the light in the picture")) {
        document->selectedObject = -1;
        gizmo->mode = GizmoMode::Move;
    }
}

/// For models that have no light but the studio's, or none any more.
void drawStudio(SceneDescription* scene) {
    bool isOn = hasStudio(*scene);
    if (!isOn && (!scene->lights.empty() || scene->environment.image >= 0)) { return; }
    if (!ui::toggle("Studio", &isOn,
                    "A soft key light, fill from all around, and a ground that catches the shadow")) {
        return;
    }
    if (isOn) {
        addStudio(scene);
    } else {
        removeStudio(scene);
    }
}

void draw(SceneDocument* document, SceneFiles* files, AssetReader* assets, GizmoSettings* gizmo,
          const KeyMap* keys) {
    drawStudio(&document->draft());
    drawLights(document, files, gizmo, *keys);
    drawEnvironment(document, files, assets);
}

}  // namespace

Panel lightsPanel() { return {"Lights", false, OfParts<draw>::call, WithoutScene::Hints}; }

}  // namespace glint
