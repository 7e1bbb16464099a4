// The selected object: its place in numbers, its material, the gizmo; and objects that are added, copied,
// hidden and removed.
#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "engine/scene/shape_forms.h"
#include "viewer/model/camera_controller.h"
#include "viewer/model/key_map.h"
#include "viewer/model/object_edits.h"
#include "viewer/model/placement.h"
#include "viewer/model/scene_files.h"
#include "viewer/panels/gizmo_rows.h"
#include "viewer/panels/input_words.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

constexpr float kLeastScale = 1e-6f;

void drawAdding(SceneDocument* document, SceneFiles* files) {
    struct Addition {
        std::string name;
        std::function<void()> add;
    };
    std::vector<Addition> additions{{"Add…", [] {}}};
    for (const ShapeKind kind : addableShapes()) {
        additions.push_back({inputLabel(shapeForm(kind).name), [=] { addShape(document, kind); }});
    }
    additions.push_back({"Box", [=] { addBox(document); }});
    additions.push_back({"Light", [=] { addLight(document); }});
    additions.push_back({"Mesh file…", [=] {
                             files->dialog.ask({"Add objects of a file", files->opened, false,
                                                [files](const std::string& path) { files->add(path); }});
                         }});
    std::vector<std::string_view> names;
    names.reserve(std::size(additions));
    for (const Addition& addition : additions) {
        names.push_back(addition.name);
    }
    int chosen = 0;
    if (!ui::choice("New", &chosen, names, "At the camera's target")) { return; }
    additions[static_cast<size_t>(chosen)].add();
}

void drawMaterial(const SceneDescription& scene, Object* object) {
    std::vector<std::string> names;
    for (size_t i = 0; i < scene.materials.size(); ++i) {
        const std::string& name = scene.materials[i].name;
        names.push_back(name.empty() ? fmt::format("material {}", i + 1) : name);
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    ui::choice("Material", &object->material, views);
}

void drawPlacement(Object* object, float speed) {
    const PlacementNumbers before = numbersOf(object->objectToWorld);
    PlacementNumbers after = before;
    bool isEdited =
        ui::vector3("Position", &after.position,
                    {.format = "%.3f", .speed = speed, .tooltip = "Of its origin, metres", .unit = "m"});
    isEdited |= ui::vector3("Turned", &after.rotationDeg,
                            {.format = "%.1f°", .speed = 0.5f, .tooltip = "About x, then y, then z"});
    isEdited |= ui::vector3("Size", &after.scale,
                            {.format = "%.3f",
                             .speed = std::max(maxComponent(absVec(before.scale)) * 0.005f, 1e-5f),
                             .tooltip = "Along its own axes; a sphere's radius. A negative one mirrors"});
    if (!isEdited) { return; }
    for (int i = 0; i < 3; ++i) {
        // Nothing flat: it would have no inverse.
        if (std::abs(after.scale[i]) < kLeastScale) { after.scale[i] = before.scale[i]; }
    }
    object->objectToWorld = withNumbers(object->objectToWorld, before, after);
}

void drawActions(SceneDocument* document, const KeyMap& keys) {
    const float third = ui::buttonWidth(3);
    const auto button = [&](const char* label, const char* text, KeyAction action) {
        return ui::button(label, third, keys.tip(text, action).c_str());
    };
    if (button("Duplicate", "Another one beside it", KeyAction::Duplicate)) { duplicateSelection(document); }
    ImGui::SameLine();
    if (button("Hide", "It is out of the picture until it is shown again", KeyAction::Hide)) {
        hideSelection(document);
    }
    ImGui::SameLine();
    if (ui::button("Solo", third, "Hides all others but lamps")) { soloSelection(document); }
    if (button("Delete", "Takes it out of the scene", KeyAction::Delete)) { deleteSelection(document); }
    ImGui::SameLine();
    if (button("Frame", "Moves the camera until it fills the picture", KeyAction::FrameSelection)) {
        document->frameSelection();
    }
    ImGui::SameLine();
    const bool isFocused = document->focusObject >= 0 && document->focusObject == document->selectedObject;
    if (ui::button(isFocused ? "In focus" : "Focus on it", third,
                   "Keeps its middle in focus while it or the camera moves", isFocused)) {
        isFocused ? static_cast<void>(document->focusObject = -1) : document->focusOnSelection();
    }
}

void draw(SceneDocument* document, GizmoSettings* gizmo, SceneFiles* files, const KeyMap* keys) {
    drawAdding(document, files);
    SceneDescription& scene = document->draft();
    const auto index = static_cast<size_t>(document->selectedObject);
    if (document->selectedObject < 0 || index >= scene.objects.size()) {
        ui::hint("No object is selected: click on one in the picture.");
    } else {
        Object* object = &scene.objects[index];
        ui::text("Name", &object->name, "a name");
        drawMaterial(scene, object);
        drawPlacement(object, std::max(targetDistance(scene.camera) * 0.002f, 1e-5f));
        drawGizmoRows(gizmo, *keys);
        drawActions(document, *keys);
    }
    const size_t hidden = scene.hiddenObjects.size();
    if (hidden == 0) { return; }
    const std::string tip = keys->tip("What is hidden comes back", KeyAction::ShowAll);
    if (ui::button("Show all", ui::buttonWidth(1), tip.c_str())) { showAll(document); }
    ui::hint(fmt::format("{} hidden: the outliner lists them", hidden).c_str());
}

}  // namespace

Panel objectPanel() {
    return {"Object", false, OfParts<draw>::call, WithoutScene::Hides, "What is selected, and what is new"};
}

}  // namespace glint
