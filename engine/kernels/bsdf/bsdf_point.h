// A material at one point, seen from one direction: what its model evaluates and samples. Host and device.
//
// Local frame: z is the shading normal on wo's side, so wo.z >= 0; wi.z > 0 is reflection, wi.z < 0
// transmission. All directions point away from the surface.
//
// What diffuse surfaces do without is not stored where the feature mask knows of no others. Every number is
// computed alike for all masks, so that their pictures have the same bits.
#pragma once

#include "engine/kernels/features.h"
#include "engine/kernels/shading_view.h"
#include "engine/math/warp.h"

namespace glint {

/// What is transported along the path: radiance (paths from the camera) shrinks by the squared relative index
/// of refraction when it enters a denser medium; importance, that is photons' power, does not.
enum class TransportMode : uint8_t { Radiance, Importance };

/// f |cos wi| and the density of wi by solid angle, without the parts that only one direction has (deltas).
struct BsdfValue {
    Vec3 value{0.0f};
    float pdfSolidAngle = 0.0f;
};

struct BsdfSample {
    Vec3 wi{0.0f};               ///< local from a model, in world space from sample()
    Vec3 weight{0.0f};           ///< f |cos wi| / density, the lobe's probability included
    float pdfSolidAngle = 0.0f;  ///< density of wi over all lobes; 0 when isSpecular
    /// squared relative index that radiance was divided by; Russian roulette multiplies its throughput by
    /// this, or paths die inside glass for nothing
    float etaScale = 1.0f;
    bool isSpecular = false;  ///< wi is the only direction it could be: no light sampling could find it
    bool isTransmission = false;
    bool valid = false;  ///< false: absorbed; nothing else is set
};

/// Values of sample()'s uLobe: [begin, end).
struct LobeRange {
    float begin = 0.0f;
    float end = 0.0f;

    GLINT_HD float probability() const { return end - begin; }
    GLINT_HD bool contains(float u) const { return u >= begin && u < end; }
};

/// True for masks whose surfaces are all diffuse: sample() then ignores uLobe and the BSDF needs no frame.
template <FeatureMask kMask>
GLINT_HD constexpr bool isDiffuseOnly() {
    return (kMask & kMaterialFeatures & ~kFeatureDiffuse) == 0;
}

/// Whether sample() looks at its uLobe for any material of such scenes; if not, none need be drawn.
template <FeatureMask kMask>
GLINT_HD constexpr bool usesLobeChoice() {
    return (kMask & kMaterialFeatures & ~(kFeatureDiffuse | kFeatureSpecular | kFeatureGlossy)) != 0;
}

/// What lobes other than the diffuse one need; nothing where there are none.
template <bool kNeeded>
struct BsdfLocalFrame {
    Frame frame{};       ///< around nsWorld
    Vec3 woLocal{0.0f};  ///< z >= 0, except for importance that comes from behind ns (importance.h)
    float eta = 1.0f;    ///< dielectric: index beyond the surface over index on wo's side
    TransportMode transport = TransportMode::Radiance;
};
template <>
struct BsdfLocalFrame<false> {};

/// What textures replace the material's constants with; nothing where there are no such textures.
template <bool kNeeded>
struct BsdfTexturedInputs {
    // NOLINTNEXTLINE(modernize-use-equals-default): that would be deleted, since the union's member has one.
    GLINT_HD BsdfTexturedInputs() {}

    /// Set where the material has kMaterialInputTextures; nothing is spent on it elsewhere.
    union {
        ShadingInputs textured;
    };
};
template <>
struct BsdfTexturedInputs<false> {};

/// The light's wavelength; nothing where none matters.
template <bool kNeeded>
struct BsdfWavelength {
    float wavelengthNm = 0.0f;  ///< 0: all of the spectrum
};
template <>
struct BsdfWavelength<false> {
    static constexpr float wavelengthNm = 0.0f;  // NOLINT(readability-identifier-naming): as the other's
};

/// A material at one point, seen from one direction.
template <FeatureMask kMask>
struct Bsdf : BsdfLocalFrame<!isDiffuseOnly<kMask>()>,
              BsdfTexturedInputs<hasFeature<kMask>(kFeatureInputTextures)>,
              BsdfWavelength<hasFeature<kMask>(kFeatureDispersion)> {
    const MaterialData* material = nullptr;
    Vec3 color{0.0f};    ///< texture and vertex colour included
    Vec3 ngWorld{0.0f};  ///< geometric normal on wo's side
    Vec3 nsWorld{0.0f};  ///< shading normal on wo's side
    float ngNs = 1.0f;   ///< cosine between the two; exactly 1 where they are the same

    /// All but the colour, as they are at the point.
    GLINT_HD const ShadingInputs& inputs() const {
        if constexpr (hasFeature<kMask>(kFeatureInputTextures)) {
            if ((material->flags & kMaterialInputTextures) != 0) { return this->textured; }
        }
        return material->inputs;
    }
};

/// What a model may leave as it is.
struct BsdfModelDefaults {
    /// Whether a photon leaves in any direction above the surface, however a camera path bends ns.
    static constexpr bool kPhotonsLeaveAboutNg = false;

    /// Whether a lobe with a density lets light through, which light sampling then looks for behind, too.
    static GLINT_HD bool transmitsSampledLight(const MaterialData&) { return false; }

    /// Whether photons that are stored on it may pass it: through some lobe, at some point of it.
    static GLINT_HD bool letsStoredPhotonsThrough(const MaterialData&, float) { return false; }

    /// Makes what textures say of the inputs something the model can compute with. Constants are settled when
    /// the material is built.
    static GLINT_HD void settle(const MaterialData&, const View<CoatRow>&, ShadingInputs*) {}

    /// The colour at the point for denoisers and previews.
    template <FeatureMask kMask>
    static GLINT_HD Vec3 displayAlbedo(const Bsdf<kMask>& bsdf) {
        return bsdf.color;
    }
};

namespace detail {

GLINT_HD inline bool isSmooth(const ShadingInputs& inputs) { return inputs.roughness < kSmoothAlpha; }

GLINT_HD inline bool hasRoughnessTexture(const MaterialData& material) {
    return material.textures.roughness.index != TextureSlot::kNone ||
           material.textures.crossRoughness.index != TextureSlot::kNone;
}

/// Whether a material is rough or smooth somewhere.
GLINT_HD inline bool canBeRough(const MaterialData& material) {
    return hasRoughnessTexture(material) || !isSmooth(material.inputs);
}
GLINT_HD inline bool canBeSmooth(const MaterialData& material) {
    return hasRoughnessTexture(material) || isSmooth(material.inputs);
}

GLINT_HD inline BsdfSample specularSample(const Vec3& wi, const Vec3& weight) {
    BsdfSample sample;
    sample.wi = wi;
    sample.weight = weight;
    sample.isSpecular = true;
    sample.valid = true;
    return sample;
}

GLINT_HD inline BsdfSample nonDeltaSample(const Vec3& wi, const Vec3& weight, float pdfSolidAngle) {
    BsdfSample sample;
    sample.wi = wi;
    sample.weight = weight;
    sample.pdfSolidAngle = pdfSolidAngle;
    sample.valid = pdfSolidAngle > 0.0f;
    return sample;
}

GLINT_HD inline Vec3 mirrored(const Vec3& woLocal) { return {-woLocal.x, -woLocal.y, woLocal.z}; }

/// The axes that local directions of the BSDF refer to.
template <FeatureMask kMask>
GLINT_HD Frame frameOf(const Bsdf<kMask>& bsdf) {
    if constexpr (isDiffuseOnly<kMask>()) {
        return Frame::fromNormal(bsdf.nsWorld);
    } else {
        return bsdf.frame;
    }
}

/// A world direction in the local frame; x and y are left out where nothing looks at them.
template <FeatureMask kMask>
GLINT_HD Vec3 toLocal(const Bsdf<kMask>& bsdf, const Vec3& wiWorld) {
    if constexpr (isDiffuseOnly<kMask>()) {
        return {0.0f, 0.0f, glm::dot(wiWorld, bsdf.nsWorld)};
    } else {
        return bsdf.frame.toLocal(wiWorld);
    }
}

/// wi's cosine with the geometric normal; nsWi: its cosine with the shading normal.
template <FeatureMask kMask>
GLINT_HD float geometricCosine(const Bsdf<kMask>& bsdf, const Vec3& wiWorld, float nsWi) {
    if constexpr (hasFeature<kMask>(kFeatureShadingNormals)) {
        if (bsdf.ngNs < 1.0f) { return glm::dot(bsdf.ngWorld, wiWorld); }
    }
    return nsWi;
}

}  // namespace detail
}  // namespace glint
