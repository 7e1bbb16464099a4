#include "viewer/panels/material_model_rows.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "engine/builders/spectrum_table.h"
#include "engine/scene/glasses.h"
#include "engine/scene/metals.h"
#include "viewer/panels/input_words.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

constexpr const char* kOwnMetal = "own constants";
constexpr const char* kOwnGlass = "own index";
constexpr const char* kThreeIndices = "three indices";

/// A choice among measured constants and one's own, whose name is empty. True: another one was chosen.
bool drawMeasured(const char* label, const char* own, const std::vector<std::string_view>& measured,
                  std::string* name, const char* tooltip) {
    std::vector<std::string_view> names{own};
    names.insert(names.end(), measured.begin(), measured.end());
    const auto found = std::find(names.begin() + 1, names.end(), *name);
    int index = found == names.end() ? 0 : static_cast<int>(found - names.begin());
    if (!ui::choice(label, &index, names, tooltip)) { return false; }
    *name = index == 0 ? "" : std::string(names[static_cast<size_t>(index)]);
    return true;
}

void drawMetal(Material* material) {
    const auto shown = findMetal(material->metal);
    std::string metal = material->metal == "aluminum" ? "aluminium" : material->metal;
    if (drawMeasured("Metal", kOwnMetal, listedMetals(), &metal,
                     "Measured constants, or eta and k of one's own")) {
        material->metal = metal;
        if (shown) {
            // One's own constants begin with those of the metal that was shown.
            material->eta.value = shown->eta;
            material->k.value = shown->k;
        }
    }
    if (!material->metal.empty()) { return; }
    ui::vector3("Eta", &material->eta.value,
                {.format = "%.3f",
                 .speed = 0.005f,
                 .min = 0.001f,
                 .max = 20.0f,
                 .tooltip = "Index of refraction at R, G, B"});
    ui::vector3("k", &material->k.value,
                {.format = "%.3f", .speed = 0.005f, .max = 20.0f, .tooltip = "Extinction at R, G, B"});
}

void drawIor(Material* material) {
    ui::number("IOR", &material->ior.value,
               {.format = "%.3f",
                .speed = 0.003f,
                .min = 0.1f,
                .max = 5.0f,
                .tooltip = "Index of refraction, inside over outside"});
}

/// The indices at red, green and blue of what the material is now.
Vec3 channelIndices(const Material& material) {
    GlassConstants glass{material.ior.value, {}};
    if (material.abbeNumber > 0.0f) {
        glass.dispersion = dispersionOfAbbeNumber(material.ior.value, material.abbeNumber);
    }
    glass = findGlass(material.glass).value_or(glass);
    Vec3 indices(glass.ior);
    for (int c = 0; c < 3; ++c) {
        indices[c] += indexShift(glass.dispersion, kChannelWavelengthsNm[c]);
    }
    return indices;
}

/// A measured glass, one's own index, or three of them.
void drawGlassChoice(Material* material) {
    std::vector<std::string_view> names{kOwnGlass, kThreeIndices};
    for (const std::string_view name : glassNames()) {
        names.push_back(name);
    }
    const auto found = std::find(names.begin() + 2, names.end(), material->glass);
    const int own = isZero(material->iorRgb) ? 0 : 1;
    int index = found == names.end() ? own : static_cast<int>(found - names.begin());
    if (!ui::choice(
            "Glass", &index, names,
            "Measured indices, which bend colours apart, or one's own: one with an Abbe number, or one "
            "each at red, green and blue")) {
        return;
    }
    const Vec3 indices = channelIndices(*material);
    if (const auto shown = findGlass(material->glass)) {
        // One's own index begins with that of the glass that was shown.
        material->ior.value = shown->ior;
        material->abbeNumber = abbeNumber(shown->dispersion, shown->ior);
    } else if (own == 1) {
        material->ior.value = material->iorRgb.y;
    }
    material->iorRgb = index == 1 ? indices : Vec3(0.0f);
    material->glass = index < 2 ? "" : std::string(names[static_cast<size_t>(index)]);
}

void drawGlass(Material* material) {
    drawGlassChoice(material);
    if (!material->glass.empty()) { return; }
    if (!isZero(material->iorRgb)) {
        ui::vector3("IOR RGB", &material->iorRgb,
                    {.format = "%.4f",
                     .speed = 0.001f,
                     .min = 0.1f,
                     .max = 5.0f,
                     .tooltip = "Indices at red, green and blue: the picture has three wavelengths"});
        return;
    }
    drawIor(material);
    ui::number("Abbe number", &material->abbeNumber,
               {.format = "%.1f",
                .max = 100.0f,
                .zeroText = "no dispersion",
                .slider = true,
                .tooltip = "The lower, the further colours are bent apart: flint glass 25, crown glass 64"});
}

void drawAttenuation(Material* material) {
    ui::color("Attenuation", &material->attenuationColor, 1.0f,
              "What is left of light after the attenuation distance inside. White: all of it");
    if (material->attenuationColor == Vec3(1.0f)) { return; }
    ui::number("Attenuation distance", &material->attenuationDistance,
               {.format = "%.4f m",
                .speed = std::max(material->attenuationDistance * 0.01f, 1e-6f),
                .min = 1e-6f,
                .max = 1e6f,
                .tooltip = "The way inside the glass that leaves the attenuation colour"});
}

void drawShare(const char* label, NumberInput* input, const char* tooltip, const char* zeroText = "none") {
    ui::number(label, &input->value,
               {.format = "%.3f", .max = 1.0f, .zeroText = zeroText, .slider = true, .tooltip = tooltip});
}

void drawAnisotropy(Material* material) {
    bool isBrushed = hasCrossRoughness(*material);
    if (ui::toggle("Anisotropic", &isBrushed, "Another roughness across, as of brushed metal")) {
        material->crossRoughness = isBrushed ? NumberInput{material->roughness.value} : NumberInput{-1.0f};
    }
    if (!isBrushed) { return; }
    drawShare("Roughness across", &material->crossRoughness, "Alpha of the facets across their direction",
              "smooth");
    ui::number("Direction", &material->anisotropyRotationDeg,
               {.format = "%.1f°",
                .speed = 0.5f,
                .min = -360.0f,
                .max = 360.0f,
                .tooltip = "Turns the direction of the roughness from u towards v"});
}

void drawRoughness(Material* material) {
    drawShare("Roughness", &material->roughness, "Alpha of the facets; along u where it is anisotropic",
              "smooth");
    if (material->kind == MaterialKind::Dielectric && material->thin) { return; }
    drawAnisotropy(material);
    if (material->kind == MaterialKind::Principled || material->kind == MaterialKind::Ward) { return; }
    static constexpr ui::KindLabel<FacetDistribution> kDistributions[]{
        {FacetDistribution::Ggx, "GGX"}, {FacetDistribution::Beckmann, "Beckmann"}};
    ui::kindChoice("Facets", &material->distribution, kDistributions,
                   "How their normals are distributed: GGX has long tails, Beckmann has none");
}

void drawPassing(Material* material) {
    drawShare("Transmission", &material->specularTransmission,
              "Share of what enters plastic that passes it instead of being scattered");
    if (!transmits(*material)) { return; }
    ui::toggle("Thin", &material->thin, "A sheet without thickness: light passes straight");
    ui::toggle("Root tint", &material->rootTint,
               "What passes is tinted by the root of the colour: in and out by the colour");
    if (!material->thin) { drawAttenuation(material); }
}

void drawInput(const char* label, NumberInput* input, const char* tooltip) {
    drawShare(label, input, tooltip);
}

void drawInput(const char* label, ColorInput* input, const char* tooltip) {
    ui::color(label, &input->value, 1.0f, tooltip);
}

/// A row of its own is drawn where the others would be of no use, or say too little.
bool hasOwnRow(std::string_view key) {
    static constexpr std::string_view kKeys[]{"clearcoat", "clearcoatRoughness", "sheenColor",
                                              "sheenRoughness"};
    return std::ranges::find(kKeys, key) != std::end(kKeys);
}

/// What needs no more than its description.
void drawDescribed(Material* material) {
    const auto draw = [&](const auto& described) {
        const InputInfo& info = described.info;
        if (!looksAt(*material, info) || hasOwnRow(info.key)) { return; }
        drawInput(inputLabel(info.key).c_str(), &(material->*described.memberIn(TypeTag<Material>())),
                  inputTooltip(info.help).c_str());
    };
    withDescribedInputs([&](const auto&... described) { (draw(described), ...); });
}

void drawCoatAndSheen(Material* material) {
    drawShare("Clear coat", &material->clearcoat, "Share of the surface that is coated");
    if (material->clearcoat.value > 0.0f || material->clearcoat.texture >= 0) {
        drawShare("Coat roughness", &material->clearcoatRoughness, "GGX alpha", "smooth");
    }
    ui::color("Sheen", &material->sheenColor.value, 1.0f, "Of fibres at grazing incidence. Black: none");
    if (!isZero(material->sheenColor.value) || material->sheenColor.texture >= 0) {
        drawShare("Sheen roughness", &material->sheenRoughness, "The smaller, the more at edges alone",
                  "narrow");
    }
}

void drawPhong(Material* material) {
    ui::color("Specular reflectance", &material->specularReflectance.value, 1.0f, "Of the highlight");
    ui::number("Exponent", &material->exponent.value,
               {.format = "%.1f",
                .speed = std::max(material->exponent.value * 0.01f, 0.1f),
                .max = 1e8f,
                .tooltip = "Of the highlight: larger is narrower"});
}

void drawWard(Material* material) {
    static constexpr ui::KindLabel<WardForm> kForms[]{
        {WardForm::Ward, "Ward 1992"}, {WardForm::Duer, "Dür 2006"}, {WardForm::Balanced, "balanced, 2010"}};
    ui::color("Specular reflectance", &material->specularReflectance.value, 1.0f, "Of the highlight");
    ui::kindChoice("Form", &material->wardForm, kForms, "How bright highlights are at grazing incidence");
    drawRoughness(material);
}

void drawCoat(Material* material) {
    drawShare("Coat roughness", &material->clearcoatRoughness, "GGX alpha", "smooth");
    ui::color("Coat absorption", &material->coatAbsorption.value, 1e6f,
              "Optical depth straight through the coat. Black: it is clear");
}

}  // namespace

void drawModelInputs(Material* material) {
    const MaterialKind kind = material->kind;
    const bool mixture = kind == MaterialKind::Mixture;
    const bool coated = kind == MaterialKind::Coated;
    const bool dielectric = kind == MaterialKind::Dielectric;
    const bool plastic = kind == MaterialKind::Plastic;
    const bool principled = kind == MaterialKind::Principled;
    if (hasMetal(*material)) { drawMetal(material); }
    if (dielectric || mixture) { drawGlass(material); }
    if (plastic || principled || coated) { drawIor(material); }
    if (hasFacets(kind) && kind != MaterialKind::Ward) { drawRoughness(material); }
    if (coated) { drawCoat(material); }
    if (dielectric) {
        ui::toggle("Thin", &material->thin, "A sheet without thickness: light passes straight");
        if (!material->thin) { drawAttenuation(material); }
    }
    if (principled) {
        drawShare("Metallic", &material->metallic, "0: plastic over the colour; 1: metal that reflects it");
        drawPassing(material);
    }
    drawDescribed(material);
    if (principled) { drawCoatAndSheen(material); }
    if (kind == MaterialKind::Phong) { drawPhong(material); }
    if (kind == MaterialKind::Ward) { drawWard(material); }
    if (kind == MaterialKind::Translucent) {
        ui::color("Transmission", &material->transmission.value, 1.0f,
                  "What passes; with the colour at most 1");
    }
    if (!mixture) { return; }
    Vec3 weights = material->mixtureWeights.value;
    if (ui::vector3("Weights", &weights,
                    {.format = "%.2f",
                     .speed = 0.005f,
                     .max = 1.0f,
                     .tooltip = "Diffuse, mirror, refractive; their ratio counts"}) &&
        maxComponent(weights) > 0.0f) {
        material->mixtureWeights.value = weights;
    }
}

}  // namespace glint
