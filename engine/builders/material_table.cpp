#include "engine/builders/material_table.h"

#include <algorithm>
#include <cstring>
#include <string>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "engine/base/nearest_name.h"
#include "engine/builders/coat_albedo.h"
#include "engine/scene/metals.h"

namespace glint {
namespace {

// Where the indices differ by less than this, a rough boundary's half vectors have no digits left; light
// passes straight.
constexpr float kLeastIndexDifference = 1e-3f;

Error materialError(const Material& material, const std::string& what) {
    return Error{fmt::format("material '{}': {}", material.name, what), {}};
}

Status checkMaterial(const Material& material) {
    const bool finite = isFinite(material.color.value) && isFinite(material.emission.value) &&
                        std::isfinite(material.emissionStrength) && std::isfinite(material.roughness.value);
    if (!finite) { return materialError(material, "colour, roughness and emission must be finite numbers"); }
    if (!(material.ior.value > 0.0f && std::isfinite(material.ior.value))) {
        return materialError(
            material, fmt::format("the index of refraction is {}; expected more than 0", material.ior.value));
    }
    return {};
}

Status setMetal(const Material& material, MaterialData* data) {
    if (material.metal.empty()) {
        if (!isFinite(material.eta.value) || !isFinite(material.k.value) ||
            minComponent(material.eta.value) < 0.0f || minComponent(material.k.value) < 0.0f) {
            return materialError(material, "eta and k must be finite and not negative");
        }
        data->eta = material.eta.value;
        data->k = material.k.value;
        return {};
    }
    const std::optional<MetalConstants> metal = findMetal(material.metal);
    if (!metal) {
        const std::string hint = didYouMean(material.metal, metalNames());
        return materialError(material, fmt::format("unknown metal '{}'{}", material.metal, hint));
    }
    data->eta = metal->eta;
    data->k = metal->k;
    return {};
}

Status setMixture(const Material& material, MaterialData* data) {
    const Vec3& weights = material.mixtureWeights.value;
    const float sum = weights.x + weights.y + weights.z;
    if (!(minComponent(weights) >= 0.0f && sum > 0.0f && std::isfinite(sum))) {
        return materialError(
            material, fmt::format("the mixture weights are {} {} {}; expected none negative, not all 0",
                                  weights.x, weights.y, weights.z));
    }
    data->mixtureProbability = weights / sum;
    return {};
}

Status setCoat(const Material& material, MaterialData* data, const MaterialData* previous) {
    if (material.ior.value < 1.0f) {
        return materialError(material, fmt::format("the coat's index of refraction is {}; expected 1 or more",
                                                   material.ior.value));
    }
    const bool known = previous != nullptr && previous->kind == MaterialKind::Plastic &&
                       previous->ior == data->ior && previous->alpha == data->alpha;
    if (!known) {
        tabulateCoat(data);
        return {};
    }
    data->coatInternalAlbedo = previous->coatInternalAlbedo;
    data->coatAverageAlbedo = previous->coatAverageAlbedo;
    std::copy(std::begin(previous->coatRatio), std::end(previous->coatRatio), data->coatRatio);
    return {};
}

uint8_t flagsOf(const Material& material) {
    int flags = 0;
    flags |= material.kind == MaterialKind::Dielectric && material.thin ? kMaterialThin : 0;
    flags |= material.emitsBothSides ? kMaterialEmitsBothSides : 0;
    flags |= material.emissive() ? kMaterialEmissive : 0;
    return static_cast<uint8_t>(flags);
}

Result<MaterialData> makeMaterial(const Material& material, uint32_t texture, const MaterialData* previous) {
    if (const Status status = checkMaterial(material); !status) { return status.error(); }
    MaterialData data;
    data.kind = material.kind;
    data.flags = flagsOf(material);
    data.color = glm::clamp(material.color.value, Vec3(0.0f), Vec3(1.0f));
    data.colorTexture = texture;
    data.ior = material.ior.value;
    data.alpha = isRough(material) ? std::fmin(material.roughness.value, 1.0f) : 0.0f;
    if (material.emissive()) {
        data.emission = glm::max(material.emission.value, Vec3(0.0f)) * material.emissionStrength;
    }
    Status status;
    switch (material.kind) {
        case MaterialKind::Conductor:
            status = setMetal(material, &data);
            break;
        case MaterialKind::Mixture:
            status = setMixture(material, &data);
            break;
        case MaterialKind::Plastic:
            status = setCoat(material, &data, previous);
            break;
        default:
            break;
    }
    if (!status) { return status.error(); }
    return data;
}

bool sameMaterial(const MaterialData& a, const MaterialData& b) {
    return a.color == b.color && a.colorTexture == b.colorTexture && a.eta == b.eta && a.k == b.k &&
           a.ior == b.ior && a.alpha == b.alpha && a.mixtureProbability == b.mixtureProbability &&
           a.emission == b.emission && a.kind == b.kind && a.flags == b.flags;
}

}  // namespace

bool isRough(const Material& material) {
    if (material.roughness.value < kSmoothAlpha) { return false; }
    switch (material.kind) {
        case MaterialKind::Conductor:
        case MaterialKind::Plastic:
            return true;
        case MaterialKind::Dielectric:
            return !material.thin && std::fabs(material.ior.value - 1.0f) >= kLeastIndexDifference;
        default:
            return false;
    }
}

Result<std::shared_ptr<const MaterialTable>> buildMaterialTable(
    const SceneDescription& scene, const TextureTable& textures,
    const std::shared_ptr<const MaterialTable>& previous) {
    auto table = std::make_shared<MaterialTable>();
    table->materials.reserve(scene.materials.size());
    for (size_t i = 0; i < scene.materials.size(); ++i) {
        const Material& material = scene.materials[i];
        const auto index = static_cast<size_t>(material.color.texture);
        const bool textured = material.color.texture >= 0 && index < textures.packedIndex.size();
        const MaterialData* before =
            previous && i < previous->materials.size() ? &previous->materials[i] : nullptr;
        Result<MaterialData> data =
            makeMaterial(material, textured ? textures.packedIndex[index] : kNone, before);
        if (!data) { return data.error(); }
        table->materials.push_back(*data);
    }
    if (previous && std::equal(table->materials.begin(), table->materials.end(), previous->materials.begin(),
                               previous->materials.end(), sameMaterial)) {
        return previous;
    }
    return std::shared_ptr<const MaterialTable>(std::move(table));
}

}  // namespace glint
