// Everything in the scene by name: objects, lights, materials, textures; to be searched, selected and framed.
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "engine/scene/scene_use.h"
#include "viewer/model/key_map.h"
#include "viewer/model/object_edits.h"
#include "viewer/model/outliner.h"
#include "viewer/model/scene_document.h"
#include "viewer/panels/material_drag.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

constexpr size_t kRowsShown = 10;

/// Null: what is hidden is shown by a click, and selected as an object then.
int* selectionOf(SceneDocument* document, OutlinerEntry::Kind kind) {
    switch (kind) {
        case OutlinerEntry::Kind::Object:
            return &document->selectedObject;
        case OutlinerEntry::Kind::Light:
            return &document->selectedLight;
        case OutlinerEntry::Kind::Material:
            return &document->selectedMaterial;
        case OutlinerEntry::Kind::Texture:
            return &document->selectedTexture;
        case OutlinerEntry::Kind::Hidden:
            break;
    }
    return nullptr;
}

void select(SceneDocument* document, const OutlinerEntry& entry) {
    if (entry.kind == OutlinerEntry::Kind::Hidden) {
        return showHidden(document, static_cast<size_t>(entry.index));
    }
    *selectionOf(document, entry.kind) = entry.index;
    // The handles are the light's.
    if (entry.kind == OutlinerEntry::Kind::Light) { document->selectedObject = -1; }
    if (entry.kind == OutlinerEntry::Kind::Object) {
        document->selectedMaterial = document->draft().objects[static_cast<size_t>(entry.index)].material;
    }
    if (entry.kind != OutlinerEntry::Kind::Texture) { return; }
    // Where it is edited: at the first material that has it.
    const std::vector<Material>& materials = document->draft().materials;
    const auto user = std::ranges::find_if(materials, [&](const Material& material) {
        return std::ranges::count(inputTextures(material), entry.index) > 0;
    });
    if (user != materials.end()) { document->selectedMaterial = static_cast<int>(user - materials.begin()); }
}

void drawEntry(SceneDocument* document, const OutlinerEntry& entry) {
    const int* selection = selectionOf(document, entry.kind);
    const bool isHidden = selection == nullptr;
    if (isHidden) { ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled)); }
    const bool isChosen = ui::selectable(entry.label.c_str(), !isHidden && *selection == entry.index);
    if (entry.kind == OutlinerEntry::Kind::Material) {
        offerMaterial({.material = entry.index}, entry.label);
    }
    if (isHidden) {
        ImGui::PopStyleColor();
        if (ImGui::IsItemHovered()) { ui::tooltip("A click shows it again"); }
    }
    if (isChosen) { select(document, entry); }
}

/// Only the rows that are seen are made.
void drawEntries(SceneDocument* document, const Outliner& outliner) {
    const float row = ImGui::GetTextLineHeightWithSpacing();
    const auto rows = static_cast<float>(std::clamp<size_t>(outliner.size(), 1, kRowsShown));
    ImGui::BeginChild("##entries", {0.0f, rows * row}, false, ImGuiWindowFlags_NavFlattened);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(outliner.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            drawEntry(document, outliner.at(static_cast<size_t>(i)));
        }
    }
    ImGui::EndChild();
}

void draw(SceneDocument* document, Outliner* outliner, const KeyMap* keys) {
    ui::text("Search", &outliner->search, "name",
             "Part of a name, in any case; or object, light, material, texture, hidden");
    outliner->update(*document);
    drawEntries(document, *outliner);
    ui::hint(fmt::format("{} of {}", outliner->size(), outliner->count()).c_str());
    const bool isObject = document->selectedObject >= 0;
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, isObject ? 1.0f : 0.5f);
    const float width = ui::buttonWidth(1);
    const std::string tip =
        keys->tip("Moves the camera until the object fills the picture", KeyAction::FrameSelection);
    const bool isFramed = ui::button("Frame selection", width, tip.c_str());
    ImGui::PopStyleVar();
    if (isFramed) { document->frameSelection(); }
}

}  // namespace

Panel outlinerPanel() {
    return {"Outliner", false, OfParts<draw>::call, WithoutScene::Hides,
            "A click on the picture selects too"};
}

}  // namespace glint
