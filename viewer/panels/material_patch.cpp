#include "viewer/panels/material_patch.h"

#include "engine/scene/metals.h"

namespace glint {

Vec3 patchColor(const Material& material) {
    if (material.emissive()) { return material.emission.value; }
    if (!hasMetal(material)) { return material.color.value; }
    const auto named = findMetal(material.metal);
    const Vec3 eta = named ? named->eta : material.eta.value;
    const Vec3 k = named ? named->k : material.k.value;
    const Vec3 k2 = k * k;
    const Vec3 less = eta - Vec3(1.0f);
    const Vec3 more = eta + Vec3(1.0f);
    return material.color.value * ((less * less + k2) / (more * more + k2));
}

}  // namespace glint
