#include "engine/builders/material_table.h"

#include <algorithm>
#include <cstring>
#include <string>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "engine/base/nearest_name.h"
#include "engine/builders/coat_rows.h"
#include "engine/builders/spectrum_table.h"
#include "engine/kernels/bsdf/bsdf.h"
#include "engine/scene/glasses.h"
#include "engine/scene/metals.h"
#include "engine/scene/scene_use.h"

namespace glint {
namespace {

Error materialError(const Material& material, const std::string& what) {
    return Error{fmt::format("material '{}': {}", material.name, what), {}};
}

bool isAtLeast(float number, float least) { return std::isfinite(number) && number >= least; }
bool isAtLeast(const Vec3& numbers, float least) {
    return isFinite(numbers) && minComponent(numbers) >= least;
}

bool isMissing(float number) { return number < 0.0f; }
bool isMissing(const Vec3&) { return false; }

Status checkMaterial(const Material& material) {
    if (!isFinite(material.color.value) || !isFinite(material.emission.value) ||
        !std::isfinite(material.emissionStrength)) {
        return materialError(material, "colour and emission must be finite numbers");
    }
    Status status;
    forEachModelInput(
        [&](const InputInfo& info, const auto& input) {
            if (!status || !looksAt(material, info) || isAtLeast(input.value, info.least)) { return; }
            if (info.canBeMissing && isMissing(input.value)) { return; }
            status = materialError(
                material, fmt::format("\"{}\" must be finite and at least {}", info.key, info.least));
        },
        material);
    return status;
}

/// Constants that the model looks at, and the textures that replace them.
void setInputs(const Material& material, const TextureTable& textures, MaterialData* data) {
    forEachModelInput(
        [&](const InputInfo& info, const auto& input, auto& value, TextureSlot& slot) {
            if (!looksAt(material, info)) { return; }
            if (!info.canBeMissing || !isMissing(input.value)) {
                value = glm::clamp(input.value, info.least, info.most);
            }
            slot.index = textures.packed(input.texture);
            if (slot.index != kNone) { data->flags |= kMaterialInputTextures; }
        },
        material, data->inputs, data->textures);
}

Status setMetal(const Material& material, MaterialData* data) {
    if (material.metal.empty()) { return {}; }
    const std::optional<MetalConstants> metal = findMetal(material.metal);
    if (!metal) {
        const std::string hint = didYouMean(material.metal, metalNames());
        return materialError(material, fmt::format("unknown metal '{}'{}", material.metal, hint));
    }
    data->inputs.eta = metal->eta;
    data->inputs.k = metal->k;
    return {};
}

/// Cauchy's formula through the indices of the three channels.
Dispersion dispersionOfChannels(const Vec3& ior) {
    const glm::dvec3 w = 1e-3 * glm::dvec3(kChannelWavelengthsNm);
    const glm::dvec3 x = 1.0 / (w * w), n(ior);
    // Divided differences of n as a polynomial in x.
    const double first = (n.y - n.x) / (x.y - x.x);
    const double second = ((n.z - n.y) / (x.z - x.y) - first) / (x.z - x.x);
    Dispersion glass;
    glass.formula = DispersionFormula::Cauchy;
    glass.b[0] = static_cast<float>(first - second * (x.x + x.y));
    glass.b[1] = static_cast<float>(second);
    return glass;
}

/// The index at the d line, and how it changes. A sheet bends nothing.
Status setGlass(const Material& material, MaterialData* data) {
    if (!material.glass.empty()) {
        const std::optional<GlassConstants> glass = findGlass(material.glass);
        if (!glass) {
            const std::string hint = didYouMean(material.glass, glassNames());
            return materialError(material, fmt::format("unknown glass '{}'{}", material.glass, hint));
        }
        data->inputs.ior = glass->ior;
        data->dispersion = glass->dispersion;
    } else if (!isZero(material.iorRgb)) {
        if (!isAtLeast(material.iorRgb, 1e-2f)) {
            return materialError(material, "\"iorRgb\" must be finite and at least 0.01");
        }
        data->dispersion = dispersionOfChannels(material.iorRgb);
        data->inputs.ior = material.iorRgb.y - indexShift(data->dispersion, kChannelWavelengthsNm.y);
    } else if (material.abbeNumber != 0.0f) {
        data->dispersion = dispersionOfAbbeNumber(material.ior.value, material.abbeNumber);
    }
    if ((data->flags & kMaterialThin) != 0) { data->dispersion = {}; }
    if (data->dispersion.formula != DispersionFormula::None) { data->flags |= kMaterialDisperses; }
    return {};
}

Status checkMixture(const Material& material) {
    const Vec3& weights = material.mixtureWeights.value;
    if (!isZero(weights)) { return {}; }
    return materialError(material, "the mixture's weights are all 0");
}

Status checkCoat(const Material& material) {
    if (material.ior.value >= 1.0f) { return {}; }
    return materialError(
        material, fmt::format("the index of refraction is {}; expected 1 or more", material.ior.value));
}

uint16_t flagsOf(const Material& material) {
    int flags = 0;
    const bool passes = transmits(material);
    flags |= (material.kind == MaterialKind::Dielectric || passes) && material.thin ? kMaterialThin : 0;
    flags |= passes ? kMaterialTransmits : 0;
    flags |= passes && material.rootTint ? kMaterialRootTint : 0;
    flags |= material.emissive() && material.emitsBothSides ? kMaterialEmitsBothSides : 0;
    flags |= material.emissive() ? kMaterialEmissive : 0;
    return static_cast<uint16_t>(flags);
}

void setEmission(const Material& material, const TextureTable& textures, MaterialData* data) {
    data->emissionTexture = textures.packed(material.emission.texture);
    const bool isTexture = data->emissionTexture != kNone;
    if (isTexture) { data->flags |= kMaterialInputTextures; }
    data->emission =
        (isTexture ? Vec3(1.0f) : glm::max(material.emission.value, Vec3(0.0f))) * material.emissionStrength;
}

/// Facets that are not GGX with one alpha.
void setFacets(const Material& material, MaterialData* data) {
    const bool hasTwo =
        material.kind == MaterialKind::Ward || distributionOf(material) != FacetDistribution::Ggx;
    if (hasFacets(material.kind) && hasTwo && !hasCrossRoughness(material)) {
        data->textures.crossRoughness = data->textures.roughness;
    }
    data->distribution = distributionOf(material);
    const bool isGeneral = isAnisotropic(material) || data->distribution != FacetDistribution::Ggx;
    const bool isRough = data->inputs.roughness > 0.0f || data->inputs.crossRoughness > 0.0f ||
                         detail::hasRoughnessTexture(*data);
    const bool isPane = material.kind == MaterialKind::Dielectric && material.thin;
    if (!hasFacets(material.kind) || !isGeneral || !isRough || isPane) { return; }
    data->flags |= kMaterialFacets;
    const float angle = material.anisotropyRotationDeg * (kPi / 180.0f);
    data->facetTurn = Vec2(std::cos(angle), std::sin(angle));
}

bool hasMipmap(const TextureTable& textures, uint32_t texture) {
    return texture != kNone && textures.textures[texture].mips != nullptr;
}

/// What perturbs normals, and what is not there.
void setRelief(const Material& material, const TextureTable& textures, MaterialData* data) {
    data->heightTexture = material.bumpHeight != 0.0f ? textures.packed(material.bump.texture) : kNone;
    data->bumpHeight = material.bumpHeight;
    data->normalTexture = textures.packed(material.normalMap.texture);
    data->normalCode = material.normalMap.value;
    data->normalStrength = material.normalStrength;
    data->opacity = clampf(material.opacity.value, 0.0f, 1.0f);
    data->opacityTexture = textures.packed(material.opacity.texture);
    const bool hasAlpha =
        data->colorTexture != kNone && textures.textures[data->colorTexture].alpha != nullptr;
    data->alphaTexture = material.alphaCutsOut && hasAlpha ? data->colorTexture : kNone;
    if (data->heightTexture != kNone || data->normalTexture != kNone || data->normalCode != kNoTilt) {
        data->flags |= kMaterialBump;
    }
    if (data->opacity < 1.0f || data->opacityTexture != kNone || data->alphaTexture != kNone) {
        data->flags |= kMaterialCutOut;
    }
}

/// Whether any of its textures is read as wide as the pixel: the last step, when all of them are there.
void setMipmaps(const TextureTable& textures, MaterialData* data) {
    bool isMipmapped = false;
    for (const uint32_t texture :
         {data->colorTexture, data->emissionTexture, data->heightTexture, data->normalTexture}) {
        isMipmapped = isMipmapped || hasMipmap(textures, texture);
    }
    forEachModelInput(
        [&](const InputInfo&, const TextureSlot& slot) {
            isMipmapped = isMipmapped || hasMipmap(textures, slot.index);
        },
        data->textures);
    if (isMipmapped) { data->flags |= kMaterialMipmaps; }
}

/// What only one kind of material has. Error: it makes no sense.
Status setOwn(const Material& material, MaterialData* data) {
    switch (material.kind) {
        case MaterialKind::Conductor:
            return setMetal(material, data);
        case MaterialKind::Coated:
            if (Status status = checkCoat(material); !status) { return status; }
            return setMetal(material, data);
        case MaterialKind::Dielectric:
            return setGlass(material, data);
        case MaterialKind::Mixture:
            if (Status status = checkMixture(material); !status) { return status; }
            return setGlass(material, data);
        case MaterialKind::Plastic:
        case MaterialKind::Principled:
            return checkCoat(material);
        case MaterialKind::Diffuse:
        case MaterialKind::Mirror:
        case MaterialKind::Translucent:
        case MaterialKind::Phong:
        case MaterialKind::Ward:
            break;
    }
    return {};
}

Result<MaterialData> makeMaterial(const Material& material, const TextureTable& textures) {
    if (const Status status = checkMaterial(material); !status) { return status.error(); }
    MaterialData data;
    data.kind = material.kind;
    data.wardForm = material.wardForm;
    data.flags = flagsOf(material);
    data.color = glm::clamp(material.color.value, Vec3(0.0f), Vec3(1.0f));
    data.colorTexture = textures.packed(material.color.texture);
    setInputs(material, textures, &data);
    setFacets(material, &data);
    setRelief(material, textures, &data);
    if (material.emissive()) { setEmission(material, textures, &data); }
    setMipmaps(textures, &data);
    data.absorption = absorptionOf(material);
    if (const Status status = setOwn(material, &data); !status) { return status.error(); }
    settleConstants(&data);
    return data;
}

/// Three wavelengths where a material in use gives its index at three.
std::vector<SpectrumStratum> spectrumFor(const SceneDescription& scene,
                                         const std::vector<MaterialData>& materials) {
    const std::vector<bool> used = usedMaterials(scene);
    bool disperses = false, hasChannels = false;
    for (size_t i = 0; i < materials.size(); ++i) {
        const bool counts = used[i] && (materials[i].flags & kMaterialDisperses) != 0;
        disperses = disperses || counts;
        hasChannels =
            hasChannels || (counts && scene.materials[i].glass.empty() && !isZero(scene.materials[i].iorRgb));
    }
    if (!disperses) { return {}; }
    return hasChannels ? tabulateThreeChannels() : tabulateSpectrum();
}

}  // namespace

Result<std::shared_ptr<const MaterialTable>> buildMaterialTable(
    const SceneDescription& scene, const TextureTable& textures,
    const std::shared_ptr<const MaterialTable>& previous) {
    auto table = std::make_shared<MaterialTable>();
    table->materials.reserve(scene.materials.size());
    for (size_t i = 0; i < scene.materials.size(); ++i) {
        Result<MaterialData> data = makeMaterial(scene.materials[i], textures);
        if (!data) { return data.error(); }
        if (hasCoatTable(data->kind)) {
            const bool hasBefore = previous && i < previous->materials.size();
            setCoat(hasBefore ? &previous->materials[i] : nullptr, hasBefore ? &previous->coats : nullptr,
                    &*data, &table->coats);
        }
        table->materials.push_back(*data);
    }
    table->spectrum = spectrumFor(scene, table->materials);
    if (previous && table->materials == previous->materials &&
        table->spectrum.size() == previous->spectrum.size()) {
        return previous;
    }
    return std::shared_ptr<const MaterialTable>(std::move(table));
}

}  // namespace glint
