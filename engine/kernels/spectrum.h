// A path's wavelength. Host and device.
//
// Pictures are red, green and blue, and so is all that paths carry. Only where glass bends colours apart does
// a path, or a photon, draw one wavelength, which it keeps to its end: what it carries is weighted by what
// that wavelength adds to each channel. The weights average to one, so that white stays white. Where a
// photon's wavelength meets a camera path's, spectralOverlap() decides.
#pragma once

#include "engine/kernels/sampler.h"
#include "engine/kernels/scene_view.h"

namespace glint {

/// Parts of the spectrum that stored photons tell apart.
constexpr uint32_t kMostWavelengthBands = 15;

struct Wavelength {
    float nm = 0.0f;  ///< 0: none, all of the spectrum
    Vec3 weight{1.0f};
    uint32_t band = 0;  ///< 0: none; otherwise 1 to spectrumBands()
};

/// Of how many equally likely bands photons are. `strata`: of SceneView::spectrum.
GLINT_HD constexpr uint32_t spectrumBands(uint32_t strata) {
    return strata < kMostWavelengthBands ? strata : kMostWavelengthBands;
}

/// The wavelength at u in [0, 1) of a spectrum that is not empty.
GLINT_HD inline Wavelength wavelengthAt(const View<SpectrumStratum>& spectrum, float u) {
    const float scaled = u * static_cast<float>(spectrum.count);
    const uint32_t index = static_cast<uint32_t>(minf(scaled, static_cast<float>(spectrum.count - 1u)));
    const SpectrumStratum& stratum = spectrum[index];
    const float along = minf(scaled - static_cast<float>(index), 1.0f);
    Wavelength wavelength;
    wavelength.nm = stratum.beginNm + along * (stratum.endNm - stratum.beginNm);
    wavelength.weight = stratum.weight;
    const auto bands = static_cast<float>(spectrumBands(spectrum.count));
    wavelength.band = 1u + static_cast<uint32_t>(minf(u * bands, bands - 1.0f));
    return wavelength;
}

/// The wavelength of the sampler's path, drawn or not.
template <FeatureMask kMask>
GLINT_HD Wavelength wavelengthOf(const SceneView& view, const Sampler& sampler) {
    return wavelengthAt(view.spectrum, get1D<kMask>(sampler, dimension(SpectrumDimension::Wavelength)));
}

/// Where a path without a wavelength meets a material that disperses light, draws one and weights `carried`.
template <FeatureMask kMask>
GLINT_HD void disperse(const SceneView& view, const Sampler& sampler, uint32_t material,
                       Wavelength* wavelength, Vec3* carried) {
    if constexpr (hasFeature<kMask>(kFeatureDispersion)) {
        const bool isDispersive = (view.materials[material].flags & kMaterialDisperses) != 0;
        if (!isDispersive || wavelength->nm > 0.0f) { return; }
        *wavelength = wavelengthOf<kMask>(view, sampler);
        *carried *= wavelength->weight;
    }
}

/// What is left of a camera path's throughput times a photon's flux, each with the weight of its wavelength.
/// Where both have one, they count for each other within a band, and with one weight: 0 elsewhere.
GLINT_HD inline Vec3 spectralOverlap(const Wavelength& ofPoint, uint32_t photonBand, uint32_t bands) {
    if (ofPoint.band == 0 || photonBand == 0) { return Vec3(1.0f); }
    if (ofPoint.band != photonBand) { return Vec3(0.0f); }
    const auto share = [&](float weight) {
        return weight > 0.0f ? static_cast<float>(bands) / weight : 0.0f;
    };
    return {share(ofPoint.weight.x), share(ofPoint.weight.y), share(ofPoint.weight.z)};
}

}  // namespace glint
