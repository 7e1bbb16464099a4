// Materials, textures, lights and the camera as kernels see them. Plain data, filled by engine/builders.
#pragma once

#include "engine/base/kinds.h"
#include "engine/base/view.h"
#include "engine/math/frame.h"
#include "engine/math/material_inputs.h"
#include "engine/math/vec.h"

namespace glint {

enum MaterialFlag : uint8_t {
    kMaterialThin = 1u << 0,
    kMaterialEmitsBothSides = 1u << 1,
    kMaterialEmissive = 1u << 2,
    kMaterialInputTextures = 1u << 3,  ///< some input other than the colour is a texture; emission included
};

/// A GGX alpha below this is treated as perfectly smooth: its lobe is narrower than float directions
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
};

/// What a model computes with at a point, but for the colour.
struct ShadingInputs : MaterialInputs<Vec3, float> {
    CoatRow coat;  ///< plastic
};

/// An index into SceneView::textures, or none.
struct TextureSlot {
    static constexpr uint32_t kNone = 0xffffffffu;

    TextureSlot() = default;
    explicit TextureSlot(const Vec3&) {}
    explicit TextureSlot(float) {}

    uint32_t index = kNone;
};

struct MaterialData {
    Vec3 color{0.5f};
    uint32_t colorTexture = TextureSlot::kNone;         ///< index into SceneView::textures, or none
    ShadingInputs inputs;                               ///< constants; what textures replace is not looked at
    MaterialInputs<TextureSlot, TextureSlot> textures;  ///< none in masks without kFeatureInputTextures
    uint32_t coatTable = TextureSlot::kNone;  ///< plastic with textures: first row in SceneView::coats
    /// radiance, strength included; with a texture: the strength, which multiplies it
    Vec3 emission{0.0f};
    uint32_t emissionTexture = TextureSlot::kNone;  ///< none in masks without kFeatureInputTextures
    MaterialKind kind = MaterialKind::Diffuse;
    uint8_t flags = 0;
};

/// 3 bytes (sRGB or linear) or 3 floats a texel; exactly one of the pointers is set. Row 0 is the image's
/// top row.
struct TextureView {
    const uint8_t* bytes = nullptr;
    const float* floats = nullptr;
    int width = 0;
    int height = 0;
    Vec2 scale{1.0f};
    Vec2 turn{1.0f, 0.0f};  ///< cosine and sine of the angle by which scaled uv are turned; masks without
    Vec2 offset{0.0f};      ///< kFeaturePlacedTextures look at none of these
    ColorEncoding encoding = ColorEncoding::Linear;  ///< of `bytes`
    bool flipV = false;
    WrapMode wrapU = WrapMode::Repeat, wrapV = WrapMode::Repeat;
    TexelFilter filter = TexelFilter::Bilinear;
};

/// A pinhole or thin lens, ready for rays: see camera_ray.h.
struct CameraData {
    Vec3 position;
    Frame frame;  ///< s: image right, t: image up, n: backwards (against the view direction)
    float tanHalfFovX = 1.0f;
    float tanHalfFovY = 1.0f;
    float lensRadius = 0.0f;
    float focalDistance = 1.0f;
    int blades = 0;
    float bladeRotationRad = 0.0f;

    bool operator==(const CameraData&) const = default;
};

}  // namespace glint
