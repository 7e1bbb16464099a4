// Pictures that were kept, and how they are compared with each other and with the live one.
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/model/key_map.h"
#include "viewer/model/scene_document.h"
#include "viewer/model/snapshots.h"
#include "viewer/panels/compare_view.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/thumbnail_textures.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

constexpr float kThumbnailUnits = 64.0f;

void drawThumbnail(const KeptRender& kept) {
    const float side = kThumbnailUnits * ui::scale();
    const auto [width, height] =
        std::pair(static_cast<float>(kept.thumbnail.width), static_cast<float>(kept.thumbnail.height));
    const float scale = side / std::max(width, height);
    if (const unsigned int texture = ui::textureOf(kept.thumbnail.id); texture != 0) {
        ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<intptr_t>(texture)),
                     {width * scale, height * scale});
    } else {
        ImGui::Dummy({width * scale, height * scale});
    }
    ImGui::SameLine(side + 2.0f * ImGui::GetStyle().ItemSpacing.x);
}

void drawKept(const KeptRender& kept, const SceneDocument& document, Snapshots* snapshots) {
    ImGui::PushID(kept.number);
    drawThumbnail(kept);
    ImGui::BeginGroup();
    if (ui::selectable(kept.name().c_str(), snapshots->left == kept.number)) {
        snapshots->left = snapshots->left == kept.number ? 0 : kept.number;
        if (snapshots->right == snapshots->left) { snapshots->right = 0; }
    }
    ui::hint(kept.summary.c_str());
    const bool isPresent = kept.scene == document.posted();
    if (!isPresent) {
        const size_t count = snapshots->differences(kept, document.posted());
        const std::string differs =
            count == 1 ? "1 setting differs" : fmt::format("{} settings differ", count);
        ui::hint(fmt::format("{:+.2f} stops, {} from the scene as it is now", kept.look.exposureStops,
                             count == 0 ? "nothing differs" : differs)
                     .c_str());
    }
    ImGui::EndGroup();
    ImGui::PopID();
}

void drawRight(Snapshots* snapshots) {
    std::vector<std::string> names{"Live picture"};
    std::vector<int> numbers{0};
    int index = 0;
    for (const KeptRender& kept : snapshots->kept()) {
        if (kept.number == snapshots->left) { continue; }
        if (kept.number == snapshots->right) { index = static_cast<int>(numbers.size()); }
        names.push_back(kept.name());
        numbers.push_back(kept.number);
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    if (ui::choice("Against", &index, views, "Right in the comparison")) {
        snapshots->right = numbers[static_cast<size_t>(index)];
    }
}

void drawActions(Snapshots* snapshots) {
    const float half = ui::buttonWidth(2);
    if (ui::button("Its scene", half, "Goes back to the settings that it was rendered with")) {
        snapshots->askForScene(snapshots->left);
    }
    ImGui::SameLine();
    if (ui::button("Remove", half)) { snapshots->remove(snapshots->left); }
}

void draw(Snapshots* snapshots, const SceneDocument* document, DisplaySettings* display, const KeyMap* keys) {
    const std::string tip = keys->tip("With its settings and its error", KeyAction::Keep);
    if (ui::button("Keep this picture", ui::buttonWidth(1), tip.c_str())) { snapshots->askToKeep(); }
    for (const KeptRender& kept : snapshots->kept()) {
        drawKept(kept, *document, snapshots);
    }
    if (snapshots->kept().empty()) { return; }
    if (!snapshots->isComparing()) { return ui::hint("Click one to compare it with the live picture."); }
    drawRight(snapshots);
    drawCompareView(display, *keys);
    drawActions(snapshots);
}

}  // namespace

Panel snapshotsPanel() { return {"Snapshots", false, OfParts<draw>::call, WithoutScene::Hides}; }

}  // namespace glint
