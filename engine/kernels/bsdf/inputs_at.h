// A material's colour and other inputs at a point: its constants, or what textures replace them with. Host
// and device.
#pragma once

#include "engine/kernels/features.h"
#include "engine/kernels/texture.h"

namespace glint {
namespace detail {

/// The texture or else the material's colour, times the vertex colour. Surface: as makeBsdf() says.
template <FeatureMask kMask, class Surface>
GLINT_HD Vec3 surfaceColor(const MaterialData& material, const View<TextureView>& textures,
                           const Surface& surface) {
    Vec3 color = material.color;
    if constexpr (hasFeature<kMask>(kFeatureTextures)) {
        if (material.colorTexture < textures.count) {
            color = glm::clamp(sampleTexture<kMask>(textures[material.colorTexture], surface.uv), Vec3(0.0f),
                               Vec3(1.0f));
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
GLINT_HD inline void setInput(const Vec3& texel, const InputInfo& info, Vec3* input) {
    *input = {clampInput(texel.x, info), clampInput(texel.y, info), clampInput(texel.z, info)};
}
/// The first channel.
GLINT_HD inline void setInput(const Vec3& texel, const InputInfo& info, float* input) {
    *input = clampInput(texel.x, info);
}

/// Sets all inputs but the coat.
template <FeatureMask kMask, class Scene>
GLINT_HD void readInputs(const Scene& scene, const MaterialData& material, Vec2 uv, ShadingInputs* inputs) {
    MaterialInputs<Vec3, float>& values = *inputs;
    values = material.inputs;
    forEachModelInput(
        [&](const InputInfo& info, auto& value, const TextureSlot& slot) {
            if (slot.index >= scene.textures.count) { return; }
            setInput(sampleNumbers<kMask>(scene.textures[slot.index], uv), info, &value);
        },
        values, material.textures);
}

}  // namespace detail
}  // namespace glint
