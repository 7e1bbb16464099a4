// A material's colour and other inputs at a point: its constants, or what textures replace them with. Host
// and device.
#pragma once

#include "engine/kernels/features.h"
#include "engine/kernels/texture.h"

namespace glint {
namespace detail {

/// What a pixel covers of u and v at the point, where that is known.
template <class Surface>
GLINT_HD float uvWidthOf(const Surface& surface) {
    if constexpr (requires { surface.uvWidth; }) {
        return surface.uvWidth;
    } else {
        return 0.0f;
    }
}

/// The texture or else the material's colour, times the vertex colour. Surface: as makeBsdf() says.
template <FeatureMask kMask, class Surface>
GLINT_HD Vec3 surfaceColor(const MaterialData& material, const View<TextureView>& textures,
                           const Surface& surface) {
    Vec3 color = material.color;
    if constexpr (hasFeature<kMask>(kFeatureTextures)) {
        if (material.colorTexture < textures.count) {
            color = glm::clamp(
                sampleTexture<kMask>(textures[material.colorTexture], surface.uv, uvWidthOf(surface)),
                Vec3(0.0f), Vec3(1.0f));
        }
    }
    if constexpr (hasFeature<kMask>(kFeatureMeshColors)) {
        color *= glm::clamp(surface.vertexColor, Vec3(0.0f), Vec3(1.0f));
    }
    return color;
}

GLINT_HD inline float clampInput(float x, const InputInfo& info) {
    return minf(maxf(x, info.least), info.most);  // NaN becomes the least
}
template <FeatureMask kMask>
GLINT_HD void readInput(const TextureView& texture, Vec2 uv, float uvWidth, const InputInfo& info,
                        Vec3* input) {
    const Vec3 texel = sampleNumbers<kMask>(texture, uv, uvWidth);
    *input = {clampInput(texel.x, info), clampInput(texel.y, info), clampInput(texel.z, info)};
}
template <FeatureMask kMask>
GLINT_HD void readInput(const TextureView& texture, Vec2 uv, float uvWidth, const InputInfo& info,
                        float* input) {
    *input = clampInput(sampleNumber<kMask>(texture, uv, uvWidth), info);
}

/// Sets all inputs but the coat.
template <FeatureMask kMask, class Scene>
GLINT_HD void readInputs(const Scene& scene, const MaterialData& material, Vec2 uv, float uvWidth,
                         ShadingInputs* inputs) {
    MaterialInputs<Vec3, float>& values = *inputs;
    values = material.inputs;
    forEachModelInput(
        [&](const InputInfo& info, auto& value, const TextureSlot& slot) {
            constexpr uint32_t kOnlyPrincipled = kindBit(MaterialKind::Principled);
            constexpr uint32_t kHighlights = kindBit(MaterialKind::Phong) | kindBit(MaterialKind::Ward);
            if (!hasFeature<kMask>(kFeaturePrincipled) && info.kinds == kOnlyPrincipled) { return; }
            constexpr uint32_t kOnlyCoated = kindBit(MaterialKind::Coated);
            if (!hasFeature<kMask>(kFeatureHighlights) && (info.kinds & ~kHighlights) == 0) { return; }
            if (!hasFeature<kMask>(kFeatureCoated) && info.kinds == kOnlyCoated) { return; }
            if (slot.index >= scene.textures.count) { return; }
            readInput<kMask>(scene.textures[slot.index], uv, uvWidth, info, &value);
        },
        values, material.textures);
}

}  // namespace detail
}  // namespace glint
