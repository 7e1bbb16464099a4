// The materials' list, and every parameter of the one that is selected.
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "engine/scene/kind_names.h"
#include "engine/scene/scene_use.h"
#include "viewer/model/scene_document.h"
#include "viewer/model/scene_files.h"
#include "viewer/panels/asset_state.h"
#include "viewer/panels/input_words.h"
#include "viewer/panels/material_drag.h"
#include "viewer/panels/material_model_rows.h"
#include "viewer/panels/material_patch.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/texture_row.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

/// By the words of scene files.
void drawKind(MaterialKind* kind) {
    struct Labelled {
        MaterialKind kind;
        std::string label;
    };
    static const auto kLabels = [] {
        std::vector<Labelled> labels;
        for (const KindName<MaterialKind>& entry : kindNames<MaterialKind>()) {
            labels.push_back({entry.kind, inputLabel(entry.name)});
        }
        return labels;
    }();
    ui::kindChoice("Kind", kind, kLabels);
}

std::string nameOf(const Material& material, size_t index) {
    return material.name.empty() ? fmt::format("material {}", index) : material.name;
}

void drawList(SceneDocument* document) {
    const std::vector<Material>& materials = document->draft().materials;
    const float rows = std::min(static_cast<float>(materials.size()), 6.0f);
    const float height = rows * ImGui::GetTextLineHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
    ImGui::BeginChild("list", {0.0f, height}, false, ImGuiWindowFlags_NavFlattened);
    for (size_t i = 0; i < materials.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const Vec3 swatch = patchColor(materials[i]);
        if (ui::selectable(nameOf(materials[i], i).c_str(), static_cast<int>(i) == document->selectedMaterial,
                           &swatch)) {
            document->selectedMaterial = static_cast<int>(i);
        }
        offerMaterial({.material = static_cast<int>(i)}, nameOf(materials[i], i));
        ImGui::PopID();
    }
    ImGui::EndChild();
}

/// How the image lies on the surface; shared by all materials that have it.
void drawPlacement(Texture* texture) {
    static constexpr ui::KindLabel<WrapMode> kWraps[]{
        {WrapMode::Repeat, "repeat"}, {WrapMode::Clamp, "clamp"}, {WrapMode::Mirror, "mirror"}};
    static constexpr ui::KindLabel<TexelFilter> kFilters[]{{TexelFilter::Bilinear, "bilinear"},
                                                           {TexelFilter::Nearest, "nearest"},
                                                           {TexelFilter::Mipmap, "mip map"}};
    static constexpr ui::KindLabel<TextureChannel> kChannels[]{{TextureChannel::Red, "red"},
                                                               {TextureChannel::Green, "green"},
                                                               {TextureChannel::Blue, "blue"},
                                                               {TextureChannel::Alpha, "alpha"},
                                                               {TextureChannel::Luminance, "luminance"}};
    static constexpr ui::KindLabel<ColorEncoding> kEncodings[]{{ColorEncoding::Srgb, "sRGB"},
                                                               {ColorEncoding::Linear, "linear"}};
    ui::heading("Texture");
    const ui::NumberStyle free{.format = "%.3f", .speed = 0.005f};
    ui::number("Scale u", &texture->scale.x, free);
    ui::number("Scale v", &texture->scale.y, free);
    ui::number("Offset u", &texture->offset.x, free);
    ui::number("Offset v", &texture->offset.y, free);
    ui::number("Turn", &texture->rotationDeg, {.format = "%.1f°", .speed = 0.25f});
    ui::kindChoice("Wrap u", &texture->wrapU, kWraps, "What is shown left and right of the image");
    ui::kindChoice("Wrap v", &texture->wrapV, kWraps, "What is shown above and below the image");
    ui::kindChoice("Filter", &texture->filter, kFilters, "Between the centres of texels");
    ui::kindChoice("Encoding", &texture->encoding, kEncodings, "How 8-bit files hold colour");
    ui::kindChoice("Channel", &texture->channel, kChannels, "What stands for a single number");
}

/// The texture whose placement is shown: the first that the material has.
Texture* placedTexture(const Material& material, std::vector<Texture>* textures) {
    for (const int index : inputTextures(material)) {
        if (index >= 0 && static_cast<size_t>(index) < textures->size()) {
            return &(*textures)[static_cast<size_t>(index)];
        }
    }
    return nullptr;
}

void drawRelief(const TextureRows& rows, Material* material) {
    ui::heading("Relief and opacity");
    drawTextureRow(rows, "Bump map", "An image of heights, over which the shading leans",
                   &material->bump.texture);
    if (material->bump.texture >= 0) {
        ui::number("Bump height", &material->bumpHeight,
                   {.format = "%.4f m",
                    .speed = std::max(std::abs(material->bumpHeight) * 0.01f, 1e-5f),
                    .zeroText = "flat",
                    .tooltip = "What white stands for; negative: valleys"});
    }
    drawTextureRow(rows, "Normal map", "An image of tangent-space normals", &material->normalMap.texture);
    if (material->normalMap.texture >= 0) {
        ui::number("Normal strength", &material->normalStrength,
                   {.format = "× %.2f", .speed = 0.01f, .tooltip = "1 as the image says"});
    }
    drawTextureRow(rows, "Opacity map", "An image that cuts out: its alpha, or else its channel",
                   &material->opacity.texture);
    if (material->opacity.texture < 0) {
        ui::number(
            "Opacity", &material->opacity.value,
            {.format = "%.3f", .max = 1.0f, .slider = true, .tooltip = "Share of the surface that is there"});
    }
    if (material->color.texture >= 0) {
        ui::toggle("Alpha cuts out", &material->alphaCutsOut, "Where the colour's image is transparent");
    }
}

void drawScattering(const TextureRows& rows, AssetReader* assets, Material* material) {
    ui::color("Colour", &material->color.value, 1.0f, "Linear Rec.709. Click the patch for a picker");
    drawTextureRow(rows, "Texture", "An image that replaces the colour", &material->color.texture);
    drawAssetState(assets);
    drawModelInputs(material);
    drawModelTextures(rows);
}

void drawEmission(Material* material) {
    ui::heading("Emission");
    ui::color("Emission", &material->emission.value, 1e6f, "Radiance, linear Rec.709, W/(sr m²)");
    ui::number(
        "Strength", &material->emissionStrength,
        {.format = "× %.3f", .speed = std::max(material->emissionStrength * 0.01f, 0.01f), .max = 1e6f});
    ui::toggle("Both sides", &material->emitsBothSides, "Otherwise only the front shines");
}

/// Ray casting alone looks at it.
void drawHighlight(Material* material) {
    ui::heading("Highlight");
    ui::color("Specular", &material->phongSpecular, 1e6f, "Of Phong's highlights in ray casting");
    ui::number("Shininess", &material->phongExponent,
               {.format = "%.1f", .speed = 0.2f, .max = 1e6f, .tooltip = "Larger: smaller highlights"});
}

void draw(SceneDocument* document, AssetReader* assets, SceneFiles* files) {
    std::vector<Material>& materials = document->draft().materials;
    if (materials.empty()) {
        ui::hint("The scene has no materials.");
        return;
    }
    int& selected = document->selectedMaterial;
    selected = std::clamp(selected, 0, static_cast<int>(materials.size()) - 1);
    drawList(document);
    Material& material = materials[static_cast<size_t>(selected)];
    ImGui::PushID(selected);
    drawKind(&material.kind);
    const TextureRows rows(document, files, static_cast<size_t>(selected));
    drawScattering(rows, assets, &material);
    if (Texture* texture = placedTexture(material, &document->draft().textures)) { drawPlacement(texture); }
    drawRelief(rows, &material);
    drawEmission(&material);
    if (document->draft().options.integrator == IntegratorKind::RayCast) { drawHighlight(&material); }
    ImGui::PopID();
}

}  // namespace

Panel materialsPanel() {
    return {"Materials", false, OfParts<draw>::call, WithoutScene::Draws,
            "A material that is dragged to the picture is given to the object there"};
}

}  // namespace glint
