// What a stored photon remembers beside its power, and whose photons count for a visible point. Host
// and device.
//
// Photons are found by their place, so that those of a second surface within the radius are found, too. Next
// to opaque surfaces that does no harm: what arrives on the other side of the second one reflects nothing on
// the first. A surface that lets stored photons through (rough glass) keeps a photon that the floor under it
// keeps again, and each of the two would count both. So in scenes with such surfaces a photon remembers a
// number of its surface, for which it gives up digits of its directions; elsewhere nothing changes. In scenes
// that disperse light it also remembers the band of its wavelength.
//
// The rule: sharePhotons().
#pragma once

#include "engine/kernels/bsdf/bsdf.h"
#include "engine/kernels/scene_view.h"
#include "engine/kernels/spectrum.h"
#include "engine/kernels/sppm_view.h"
#include "engine/math/octahedral.h"

namespace glint {

/// All opaque surfaces have this number. Another one is that of an instance, plus 1; numbers repeat beyond
/// mostSurfaces() instances.
constexpr uint32_t kOpaqueSurface = 0;

/// What the 64 bits of Photon::packed hold: direction in 32 bits, normal in 24, depth in 8; or, where photons
/// know their surface, direction in 24, depth in 8, normal in 16, surface in 16. Where they know their band,
/// it takes 4 bits of the surface, or else of the normal.
struct PhotonLayout {
    bool knowsSurface = false, knowsBand = false;  ///< the same for all photons of a pass

    GLINT_HD void pack(const Vec3& wi, const Vec3& ng, uint32_t depth, uint32_t surface, uint32_t band,
                       Photon* photon) const {
        if (knowsSurface) {
            photon->packed[0] = packUnitVector<12>(wi) | depth << 24;
            photon->packed[1] = packUnitVector<8>(ng) | surface << 16;
        } else {
            photon->packed[0] = packUnitVector<16>(wi);
            photon->packed[1] = (knowsBand ? packUnitVector<10>(ng) : packUnitVector<12>(ng)) | depth << 24;
        }
        if (knowsBand) { photon->packed[1] |= band << bandShift(); }
    }

    GLINT_HD Vec3 wi(const Photon& photon) const {
        return knowsSurface ? unpackUnitVector<12>(photon.packed[0]) : unpackUnitVector<16>(photon.packed[0]);
    }
    GLINT_HD Vec3 ng(const Photon& photon) const {
        if (knowsSurface) { return unpackUnitVector<8>(photon.packed[1]); }
        return knowsBand ? unpackUnitVector<10>(photon.packed[1]) : unpackUnitVector<12>(photon.packed[1]);
    }
    GLINT_HD uint32_t depth(const Photon& photon) const { return photon.packed[knowsSurface ? 0 : 1] >> 24; }
    GLINT_HD uint32_t surface(const Photon& photon) const {
        return knowsSurface ? (photon.packed[1] >> 16) & mostSurfaces() : kOpaqueSurface;
    }
    /// 0: all of the spectrum.
    GLINT_HD uint32_t band(const Photon& photon) const {
        return knowsBand ? (photon.packed[1] >> bandShift()) & kMostWavelengthBands : 0u;
    }
    GLINT_HD uint32_t mostSurfaces() const { return knowsBand ? 0xfffu : 0xffffu; }

  private:
    GLINT_HD uint32_t bandShift() const { return knowsSurface ? 28u : 20u; }
};

GLINT_HD inline PhotonLayout photonLayout(const SppmParams& params) {
    return {params.photonsKnowSurface, params.photonsKnowBand};
}

/// The number of the surface of an instance, for photons on it and for visible points.
template <FeatureMask kMask>
GLINT_HD uint32_t surfaceNumber(const SceneView& view, const SppmParams& params, uint32_t instance) {
    if (!params.photonsKnowSurface) { return kOpaqueSurface; }
    const MaterialData& material = view.materials[view.geometry.instances[instance].material];
    return letsStoredPhotonsThrough<kMask>(material, params.storeAlpha)
               ? instance % photonLayout(params).mostSurfaces() + 1u
               : kOpaqueSurface;
}

/// Whether a photon counts for a visible point within the radius, as far as it is their surfaces that decide.
/// - On one surface it does, and so among all opaque ones: a floor of tiles, a mesh in parts.
/// - Between an opaque surface and one that lets photons through, never.
/// - Between two objects that let photons through, where they have one material and the photon's one goes on
///   as the visible point's does: as tiles of a sheet do, and parts of a ball, but not a ball within a ball.
/// - With their fronts on opposite sides, opaque ones that go on as each other do: tiles of a floor that are
///   wound in opposite ways. Of light that came to the other side the visible point's material sends nothing.
/// `isTurned`: the fronts are on opposite sides. `height`: the photon's, over the visible point, along the
/// mean of both normals, turned to one side; 0 on planes and spheres.
GLINT_HD inline bool sharePhotons(const SceneView& view, uint32_t ofPhoton, uint32_t ofPoint, bool isTurned,
                                  float height, float radiusSquared) {
    constexpr float kGreatestStep = 1.0f / 64.0f;  // of the radius
    if (ofPhoton == ofPoint && !isTurned) { return true; }
    const bool goesOn = height * height <= square(kGreatestStep) * radiusSquared;
    if (isTurned) { return ofPhoton == kOpaqueSurface && ofPoint == kOpaqueSurface && goesOn; }
    if (ofPhoton == kOpaqueSurface || ofPoint == kOpaqueSurface) { return false; }
    const View<InstanceData>& instances = view.geometry.instances;
    return instances[ofPhoton - 1].material == instances[ofPoint - 1].material && goesOn;
}

/// What the kernels of a pass are told: whether photons must know their surface, as they must where some
/// of them can pass one, whether their band, and no more scatterings than a photon can count. `view` is
/// the host's.
inline SppmParams settledParams(const SceneView& view, SppmParams params) {
    if (params.pass.maxDepth > kMostPhotonScatterings) { params.pass.maxDepth = kMostPhotonScatterings; }
    params.photonsKnowBand = !view.spectrum.empty();
    params.photonsKnowSurface = false;
    const View<InstanceData>& instances = view.geometry.instances;
    for (uint32_t i = 0; i < instances.count && !params.photonsKnowSurface; ++i) {
        params.photonsKnowSurface =
            letsStoredPhotonsThrough<kAllFeatures>(view.materials[instances[i].material], params.storeAlpha);
    }
    return params;
}

}  // namespace glint
