// Materials, textures, lights and the camera as kernels see them. Plain data, filled by engine/build.
#pragma once

#include "engine/base/kinds.h"
#include "engine/base/view.h"
#include "engine/math/frame.h"
#include "engine/math/vec.h"

namespace glint {

enum MaterialFlag : uint8_t {
    kMaterialThin = 1u << 0,
    kMaterialEmitsBothSides = 1u << 1,
    kMaterialEmissive = 1u << 2,
};

/// A GGX alpha below this is treated as perfectly smooth: its lobe is narrower than float directions
/// resolve well.
constexpr float kSmoothAlpha = 1e-4f;

/// Entries of a rough coat's table.
constexpr int kCoatSamples = 32;

struct MaterialData {
    Vec3 color{0.5f};
    uint32_t colorTexture = 0xffffffffu;  ///< index into SceneView::textures, or none
    Vec3 eta{1.0f};                       ///< conductor
    Vec3 k{0.0f};                         ///< conductor
    float ior = 1.5f;                     ///< dielectric, plastic, mixture
    float alpha = 0.0f;                   ///< GGX; below kSmoothAlpha: smooth
    Vec3 mixtureProbability{1, 0, 0};     ///< sums to 1
    Vec3 emission{0.0f};                  ///< radiance, strength included
    float coatInternalAlbedo = 0.0f;  ///< plastic: share of diffuse light that the coat's underside reflects
    float coatAverageAlbedo = 0.0f;   ///< plastic: cosine-weighted mean of the coat's albedo from outside
    MaterialKind kind = MaterialKind::Diffuse;
    uint8_t flags = 0;
    /// plastic, rough: albedo over Fresnel at cosine (i / (kCoatSamples - 1))^2
    float coatRatio[kCoatSamples] = {};
};

/// 3 bytes (sRGB or linear) or 3 floats a texel; exactly one of the pointers is set. Row 0 is the image's
/// top row.
struct TextureView {
    const uint8_t* bytes = nullptr;
    const float* floats = nullptr;
    int width = 0;
    int height = 0;
    Vec2 scale{1.0f};
    ColorEncoding encoding = ColorEncoding::Linear;  ///< of `bytes`
    bool flipV = false;
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
};

}  // namespace glint
