#include "engine/io/gltf_anisotropy.h"

#include <algorithm>
#include <cmath>

namespace glint {

bool isEvenlyAnisotropic(const Material& material) {
    return isAnisotropic(material) && material.roughness.texture < 0 && material.crossRoughness.texture < 0;
}

float leastAlpha(const Material& material) {
    return isEvenlyAnisotropic(material) ? std::min(material.roughness.value, material.crossRoughness.value)
                                         : material.roughness.value;
}

GltfJson gltfAnisotropy(const Material& material, bool isFlipped) {
    const float along = material.roughness.value, across = material.crossRoughness.value;
    const float least = std::min(along, across), most = std::max(along, across);
    const float turnDeg = material.anisotropyRotationDeg + (across > along ? 90.0f : 0.0f);
    return {{"anisotropyStrength", gltfJson(std::sqrt((most - least) / (1.0f - least)))},
            {"anisotropyRotation", gltfJson((isFlipped ? turnDeg : -turnDeg) * (kPi / 180.0f))}};
}

}  // namespace glint
