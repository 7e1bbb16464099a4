// Which glasses a path is in, and what they absorb on its way: Beer and Lambert's law. Host and device.
//
// Glass lies behind the fronts of its closed surface: a path enters one where it passes to the back, and
// leaves it where it passes to the front. Of glasses within each other, the one entered last absorbs, and
// clear glass within absorbing glass absorbs nothing; where surfaces overlap, leaving one keeps the others. A
// path that begins within glass learns of it where it meets the back of its surface, and then counts the way
// there. Left out: more than four glasses within each other, and light that begins within glass and meets
// something opaque first.
#pragma once

#include "engine/kernels/scene_view.h"
#include "engine/kernels/surface.h"

namespace glint {

/// Glasses that were entered and not left, by the numbers of their materials; the last one is the innermost.
struct GlassStack {
    static constexpr int kMost = 4;

    GLINT_HD void enter(uint32_t material) {
        if (count < kMost) { materials[count++] = material; }
    }
    GLINT_HD void leave(uint32_t material) {
        int at = count - 1;
        while (at >= 0 && materials[at] != material) {
            --at;
        }
        if (at < 0) { return; }
        --count;
        for (; at < count; ++at) {
            materials[at] = materials[at + 1];
        }
    }

    uint32_t materials[kMost] = {};
    int count = 0;
};

/// Whether there is something of the material behind its surface that light goes through.
GLINT_HD inline bool hasInside(const MaterialData& material) {
    const bool isSheet = (material.flags & kMaterialThin) != 0;
    return (material.kind == MaterialKind::Dielectric && !isSheet) ||
           material.kind == MaterialKind::Mixture || ((material.flags & kMaterialTransmits) != 0 && !isSheet);
}

/// A path passes the surface, to its back or to its front.
GLINT_HD inline void passSurface(const SceneView& view, uint32_t material, bool toBack, GlassStack* glasses) {
    if (!hasInside(view.materials[material])) { return; }
    toBack ? glasses->enter(material) : glasses->leave(material);
}

/// Per metre, where the path is.
GLINT_HD inline Vec3 absorptionIn(const SceneView& view, const GlassStack& glasses) {
    return glasses.count > 0 ? view.materials[glasses.materials[glasses.count - 1]].absorption : Vec3(0.0f);
}

/// Per metre, on the way to a surface that was met from `wo`.
GLINT_HD inline Vec3 absorptionBefore(const SceneView& view, const GlassStack& glasses,
                                      const SurfacePoint& surface, const Vec3& wo) {
    if (glasses.count == 0 && glm::dot(surface.ng, wo) < 0.0f) {
        const MaterialData& material = view.materials[surface.material];
        return hasInside(material) ? material.absorption : Vec3(0.0f);
    }
    return absorptionIn(view, glasses);
}

/// What is left after a way of so many metres, which may be infinite.
GLINT_HD inline Vec3 transmittance(const Vec3& absorption, float distance) {
    Vec3 left(1.0f);
    for (int channel = 0; channel < 3; ++channel) {
        if (absorption[channel] > 0.0f) { left[channel] = std::exp(-absorption[channel] * distance); }
    }
    return left;
}

}  // namespace glint
