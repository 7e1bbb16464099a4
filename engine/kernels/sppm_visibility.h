// Which surfaces hold visible points and photons, and which ones camera paths and photons merely pass on
// their way.
//
// One rule for both sides: what a photon leaves out, the camera path has to find, and nothing may be
// counted twice.
#pragma once

#include "engine/kernels/bsdf.h"
#include "engine/kernels/sppm_view.h"

namespace glint {

/// The values of sample()'s uLobe that choose a lobe which holds visible points: [begin, end), empty
/// for surfaces that only reflect or refract sharply. The other values choose specular lobes, which a
/// path follows.
struct LobeRange {
    float begin = 0.0f;
    float end = 0.0f;

    GLINT_HD float probability() const { return end - begin; }
    GLINT_HD bool contains(float u) const { return u >= begin && u < end; }
};

/// Metal and glass store from a GGX alpha of storeAlpha on; everything with a diffuse base stores always.
template <FeatureMask kMask>
GLINT_HD LobeRange storedLobes(const Bsdf<kMask>& bsdf, float storeAlpha) {
    const MaterialData& material = *bsdf.material;
    switch (detail::kindOf<kMask>(material)) {
        case MaterialKind::Diffuse:
            return {0.0f, 1.0f};
        case MaterialKind::Conductor:
        case MaterialKind::Dielectric:
            return isSpecularOnly(bsdf) || material.alpha < storeAlpha ? LobeRange{} : LobeRange{0.0f, 1.0f};
        case MaterialKind::Plastic:
            if constexpr (hasFeature<kMask>(kFeaturePlastic)) {
                if (detail::isSmooth(material)) {
                    return {detail::plasticChoice(material, bsdf.color, bsdf.woLocal).coatProbability, 1.0f};
                }
            }
            return {0.0f, 1.0f};
        case MaterialKind::Mixture:
            return {0.0f, material.mixtureProbability.x};
        case MaterialKind::Mirror:
            break;
    }
    return {};
}

}  // namespace glint
