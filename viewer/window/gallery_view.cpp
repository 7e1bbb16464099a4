#include "viewer/window/gallery_view.h"

#include <algorithm>
#include <filesystem>

#include <imgui.h>

#include "viewer/ui/theme.h"
#include "viewer/ui/thumbnail_textures.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

constexpr float kCardUnits = 156.0f;
constexpr float kImageUnits = 117.0f;  // of a card's height
constexpr float kGapUnits = 14.0f;

void drawImage(const ExampleScene& example, Vec2 corner, Vec2 size) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled({corner.x, corner.y}, {corner.x + size.x, corner.y + size.y},
                        IM_COL32(20, 20, 20, 255), 4.0f * ui::scale());
    const unsigned int texture = ui::textureOf(example.thumbnail.id);
    if (texture == 0) { return; }
    const Vec2 image(example.thumbnail.width, example.thumbnail.height);
    const Vec2 shown = image * std::min(size.x / image.x, size.y / image.y);
    const Vec2 from = corner + (size - shown) * 0.5f;
    draw->AddImage(reinterpret_cast<ImTextureID>(static_cast<intptr_t>(texture)), {from.x, from.y},
                   {from.x + shown.x, from.y + shown.y});
}

/// True when it was clicked.
bool drawCard(const ExampleScene& example, float width) {
    const std::string name = std::filesystem::path(example.path).stem().string();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float imageHeight = kImageUnits * ui::scale();
    const float line = ImGui::GetTextLineHeight();
    const float height = imageHeight + 2.6f * line;
    const bool isClicked = ImGui::InvisibleButton(name.c_str(), {width, height});
    const bool isHovered = ImGui::IsItemHovered();
    ui::itemArea(("Example " + name).c_str(), example.title);
    drawImage(example, {corner.x, corner.y}, {width, imageHeight});
    ImDrawList* draw = ImGui::GetWindowDrawList();
    if (isHovered) {
        draw->AddRect(corner, {corner.x + width, corner.y + imageHeight}, ImGui::GetColorU32(theme::kAccent),
                      4.0f * ui::scale(), 0, 2.0f * ui::scale());
    }
    const ImVec4 clip{corner.x, corner.y, corner.x + width, corner.y + height};
    draw->AddText(ImGui::GetFont(), ImGui::GetFontSize(), {corner.x, corner.y + imageHeight + 0.2f * line},
                  ImGui::GetColorU32(isHovered ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : theme::kTextDim),
                  example.title.c_str(), nullptr, width, &clip);
    return isClicked;
}

}  // namespace

void drawGallery(Workspace* workspace, Vec2 min, Vec2 max) {
    const std::vector<ExampleScene>& scenes = workspace->examples.scenes;
    const float gap = kGapUnits * ui::scale();
    ImGui::SetCursorScreenPos({min.x + gap, min.y + gap});
    ImGui::PushFont(ui::fonts().heading);
    ImGui::TextUnformatted(scenes.empty()
                               ? "No scene is open. Enter a file on the right, or drop one here."
                               : "Open a file on the right, drop one here, or begin with one of these");
    ImGui::PopFont();
    ImGui::SetCursorScreenPos({min.x + gap, ImGui::GetCursorScreenPos().y + 0.5f * gap});
    ImGui::BeginChild("##gallery", {max.x - min.x - gap, max.y - ImGui::GetCursorScreenPos().y}, false,
                      ImGuiWindowFlags_NavFlattened);
    ui::leaveSection();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, gap));
    const float width = kCardUnits * ui::scale();
    const int columns =
        std::max(1, static_cast<int>((ImGui::GetContentRegionAvail().x + gap) / (width + gap)));
    for (size_t i = 0; i < scenes.size(); ++i) {
        if (i % static_cast<size_t>(columns) != 0) { ImGui::SameLine(); }
        if (drawCard(scenes[i], width)) {
            workspace->sceneFiles.opened = scenes[i].path;
            workspace->sceneFiles.open(scenes[i].path);
        }
    }
    ImGui::PopStyleVar();
    ImGui::EndChild();
}

}  // namespace glint
