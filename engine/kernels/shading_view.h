// Materials, textures, lights and the camera as kernels see them. Plain data, filled by engine/builders.
#pragma once

#include "engine/base/kinds.h"
#include "engine/base/view.h"
#include "engine/math/dispersion.h"
#include "engine/math/frame.h"
#include "engine/math/material_inputs.h"
#include "engine/math/vec.h"

namespace glint {

enum MaterialFlag : uint16_t {
    kMaterialThin = 1u << 0,
    kMaterialEmitsBothSides = 1u << 1,
    kMaterialEmissive = 1u << 2,
    kMaterialInputTextures = 1u << 3,  ///< some input other than the colour is a texture; emission included
    kMaterialBump = 1u << 4,           ///< a height or normal map perturbs the shading normal
    kMaterialCutOut = 1u << 5,         ///< not there everywhere
    kMaterialMipmaps = 1u << 6,        ///< some texture is filtered by a pixel's width
    kMaterialDisperses = 1u << 7,      ///< its index depends on the wavelength
    kMaterialFacets = 1u << 8,         ///< facets other than GGX with one alpha: bsdf/facets.h
    kMaterialTransmits = 1u << 9,  ///< principled: some light passes, as bsdf/principled_transmission.h says
    kMaterialRootTint = 1u << 10,  ///< likewise: it is tinted by the root of the colour
};

/// An alpha of facets below this is treated as perfectly smooth: its lobe is narrower than float directions
/// resolve well.
constexpr float kSmoothAlpha = 1e-4f;

/// Entries of a row of a rough coat's table.
constexpr int kCoatSamples = 32;

/// What a plastic's coat of one roughness and index reflects.
struct CoatRow {
    float internalAlbedo = 0.0f;  ///< share of diffuse light that the coat's underside reflects
    float averageAlbedo = 0.0f;   ///< cosine-weighted mean of the coat's albedo from outside
    /// albedo over Fresnel at cosine (i / (kCoatSamples - 1))^2
    float ratio[kCoatSamples] = {};

    bool operator==(const CoatRow&) const = default;
};

/// What a model computes with at a point, but for the colour.
struct ShadingInputs : MaterialInputs<Vec3, float> {
    CoatRow coat;  ///< plastic, principled
    /// with kMaterialFacets: of light that comes across the direction of `roughness`; coat: along it. Both
    /// have the average over all directions
    CoatRow crossCoat;

    bool operator==(const ShadingInputs&) const = default;
};

/// An index into SceneView::textures, or none.
struct TextureSlot {
    static constexpr uint32_t kNone = 0xffffffffu;

    TextureSlot() = default;
    explicit TextureSlot(const Vec3&) {}
    explicit TextureSlot(float) {}

    uint32_t index = kNone;

    bool operator==(const TextureSlot&) const = default;
};

struct MaterialData {
    Vec3 color{0.5f};
    uint32_t colorTexture = TextureSlot::kNone;         ///< index into SceneView::textures, or none
    ShadingInputs inputs;                               ///< constants; what textures replace is not looked at
    MaterialInputs<TextureSlot, TextureSlot> textures;  ///< none in masks without kFeatureInputTextures
    Dispersion dispersion;
    Vec3 absorption{0.0f};                    ///< of bodies that light passes: per metre of a way inside
    uint32_t coatTable = TextureSlot::kNone;  ///< coat with textures: first row in SceneView::coats
    /// radiance, strength included; with a texture: the strength, which multiplies it
    Vec3 emission{0.0f};
    uint32_t emissionTexture = TextureSlot::kNone;  ///< none in masks without kFeatureInputTextures
    uint32_t heightTexture = TextureSlot::kNone;    ///< kernels/bump.h, with kMaterialBump
    float bumpHeight = 0.0f;                        ///< metres per unit of the height texture
    uint32_t normalTexture = TextureSlot::kNone;
    Vec3 normalCode{0.5f, 0.5f, 1.0f};  ///< what stands for the texture where there is none
    float normalStrength = 1.0f;
    float opacity = 1.0f;  ///< kernels/cutout.h, with kMaterialCutOut
    uint32_t opacityTexture = TextureSlot::kNone;
    uint32_t alphaTexture = TextureSlot::kNone;  ///< its alpha is a factor on the opacity
    Vec2 facetTurn{1.0f, 0.0f};                  ///< of the first roughness, from dpdu: cosine and sine
    FacetDistribution distribution = FacetDistribution::Ggx;
    MaterialKind kind = MaterialKind::Diffuse;
    WardForm wardForm = WardForm::Balanced;
    uint16_t flags = 0;

    bool operator==(const MaterialData&) const = default;
};

/// One of equally likely parts of the spectrum.
struct SpectrumStratum {
    float beginNm = 0.0f, endNm = 0.0f;
    Vec3 weight{1.0f};  ///< what its light adds to each channel; over all strata the mean is 1
};

/// 3 bytes (sRGB or linear) or 3 floats a texel; exactly one of `bytes` and `floats` is set. Row 0 is the
/// image's top row.
struct TextureView {
    const uint8_t* bytes = nullptr;
    const float* floats = nullptr;
    const uint8_t* alpha = nullptr;  ///< a byte a texel; null: 1 everywhere
    /// TexelFilter::Mipmap: 3 linear floats a texel of each level but the whole image, the larger ones first
    const float* mips = nullptr;
    int width = 0;
    int height = 0;
    Vec2 scale{1.0f};
    Vec2 turn{1.0f, 0.0f};  ///< cosine and sine of the angle by which scaled uv are turned; masks without
    Vec2 offset{0.0f};      ///< kFeaturePlacedTextures look at none of these
    ColorEncoding encoding = ColorEncoding::Linear;  ///< of `bytes`
    bool flipV = false;
    WrapMode wrapU = WrapMode::Repeat, wrapV = WrapMode::Repeat;
    TexelFilter filter = TexelFilter::Bilinear;
    TextureChannel channel = TextureChannel::Red;
    /// (base + gain x)^exponent is shown for what the image holds
    float base = 0.0f, gain = 1.0f, exponent = 1.0f;
};

/// A pinhole, a thin lens or parallel rays, ready for use: see camera_ray.h.
struct CameraData {
    Vec3 position;
    Frame frame;  ///< s: image right, t: image up, n: backwards (against the view direction)
    /// half of what the picture shows, and its middle right of and above the view axis: in the plane at a
    /// distance of 1 or, with parallel rays, anywhere
    float halfWidth = 1.0f;
    float halfHeight = 1.0f;
    Vec2 middle{0.0f};
    bool isOrthographic = false;
    float lensRadius = 0.0f;
    float focalDistance = 1.0f;
    int blades = 0;
    float bladeRotationRad = 0.0f;

    /// Whether rays begin in more than one point.
    GLINT_HD bool hasArea() const { return lensRadius > 0.0f || isOrthographic; }

    bool operator==(const CameraData&) const = default;
};

}  // namespace glint
