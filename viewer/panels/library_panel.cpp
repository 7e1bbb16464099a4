// Materials by name, and copies of materials: each replaces the one that is selected.
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "viewer/model/copy_name.h"
#include "viewer/model/material_presets.h"
#include "viewer/model/preset_images.h"
#include "viewer/model/scene_document.h"
#include "viewer/panels/material_drag.h"
#include "viewer/panels/material_patch.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/thumbnail_textures.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

constexpr float kMostRows = 6.0f;
constexpr float kRowUnits = 30.0f;

void drawPresets(PresetImages* images, size_t shown, SceneDocument* document, Material* selected) {
    const MaterialPresetGroup& group = materialPresets()[shown];
    const PresetSheet& sheet = images->sheets[shown];
    images->ask(shown);
    const unsigned int texture = ui::textureOf(sheet.thumbnail.id);
    const float row = kRowUnits * ui::scale() + ImGui::GetStyle().ItemSpacing.y;
    const float rows = std::min(static_cast<float>(group.presets.size()), kMostRows);
    ImGui::BeginChild("presets", {0.0f, rows * row}, false, ImGuiWindowFlags_NavFlattened);
    for (size_t i = 0; i < group.presets.size(); ++i) {
        const MaterialPreset& preset = group.presets[i];
        const Vec2 corner = sheet.cornerOf(i);
        if (ui::imageLine(preset.name.c_str(), {texture, corner, corner + sheet.cellSize()},
                          patchColor(preset.material), kRowUnits)) {
            takeMaterial(preset.material, selected);
            document->nameEdit("Material " + preset.name);
        }
        offerMaterial({.preset = &preset}, preset.name);
    }
    ImGui::EndChild();
}

std::vector<std::string_view> namesOf(const std::vector<Material>& materials) {
    std::vector<std::string_view> names;
    names.reserve(std::size(materials));
    for (const Material& material : materials) {
        names.push_back(material.name);
    }
    return names;
}

void drawCopying(MaterialLibrary* library, SceneDocument* document, Material* selected) {
    const float third = ui::buttonWidth(3);
    if (ui::button("Copy", third, "Remembers the selected material")) { library->copied = *selected; }
    ImGui::SameLine();
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, library->copied ? 1.0f : 0.5f);
    if (ui::button("Paste", third, "Gives the selected one all that the copied one has but its name") &&
        library->copied) {
        takeMaterial(*library->copied, selected);
        document->nameEdit("Paste a material");
    }
    ImGui::PopStyleVar();
    ImGui::SameLine();
    if (ui::button("New", third, "A copy of the selected one, for the selected object")) {
        SceneDescription& scene = document->draft();
        Material made = *selected;
        if (!made.name.empty()) { made.name = copyName(made.name, namesOf(scene.materials)); }
        scene.materials.push_back(std::move(made));
        document->selectedMaterial = static_cast<int>(scene.materials.size()) - 1;
        const auto object = static_cast<size_t>(document->selectedObject);
        if (document->selectedObject >= 0 && object < scene.objects.size()) {
            scene.objects[object].material = document->selectedMaterial;
        }
        document->nameEdit("New material");
    }
}

void draw(SceneDocument* document, MaterialLibrary* library, PresetImages* images) {
    std::vector<Material>& materials = document->draft().materials;
    if (materials.empty()) { return ui::hint("The scene has no materials."); }
    const int last = static_cast<int>(materials.size()) - 1;
    const int selected = std::clamp(document->selectedMaterial, 0, last);
    Material* material = &materials[static_cast<size_t>(selected)];
    std::vector<std::string_view> names;
    for (const MaterialPresetGroup& group : materialPresets()) {
        names.emplace_back(group.name);
    }
    ui::choice(
        "Group", &library->group, names,
        "A click on one makes the selected material such a one; dragged to the picture, an object has it");
    drawPresets(images, static_cast<size_t>(library->group), document, material);
    drawCopying(library, document, material);
}

}  // namespace

Panel libraryPanel() { return {"Library", false, OfParts<draw>::call, WithoutScene::Hides}; }

}  // namespace glint
