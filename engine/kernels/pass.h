// What one pass over the picture is told, and what it brings back for each pixel. Plain data.
#pragma once

#include "engine/base/kinds.h"
#include "engine/math/vec.h"

namespace glint {

/// How direct light is found. All three have the same expectation; the last two are for tests and for
/// showing why.
enum class DirectLightTag : uint8_t {
    Mis,  ///< light and BSDF sampling, combined by the power heuristic (Veach and Guibas 1995)
    /// light sampling; light that cannot be sampled (planes, through mirrors) still counts when hit
    LightOnly,
    BsdfOnly,  ///< no light sampling, except of point, spot and directional lights
};

/// Extra pictures of the first hit, made on request only, by passes of their own: asking for one never
/// touches the film.
enum Aov : uint32_t {
    kAovAlbedo = 1u << 0,
    kAovShadingNormal = 1u << 1,
    kAovGeometricNormal = 1u << 2,
    kAovDepth = 1u << 3,       ///< distance along the view axis of the first hit, world units; 0: nothing hit
    kAovObjectId = 1u << 4,    ///< object index + 1; 0: nothing hit
    kAovMaterialId = 1u << 5,  ///< material index + 1; 0: nothing hit
    kAovBoxesTested = 1u << 6,       ///< by the camera's ray: boxes of the acceleration structures, or planes
    kAovPrimitivesTested = 1u << 7,  ///< likewise: triangles and other shapes
    kAovNewtonSteps = 1u << 8,       ///< likewise: evaluations of turned profiles
};

struct PassParams {
    int width = 0;
    int height = 0;
    uint32_t pass = 0;  ///< counts from 0; the n-th sample of each pixel
    uint32_t seed = 0;
    int maxDepth = 16;
    int rouletteStartDepth = 4;
    FilterKind filter = FilterKind::BlackmanHarris;
    float filterRadius = 1.5f;
    SamplerKind sampler = SamplerKind::Sobol;
    float fireflyClamp = 0.0f;  ///< 0: off
    DirectLightTag directLight = DirectLightTag::Mis;
};

/// Why a sample was dropped.
enum class SampleFault : uint8_t { None, NotANumber, Infinite, Negative };
constexpr int kSampleFaultCount = 4;

struct AovSample {
    Vec3 albedo{0.0f};
    Vec3 shadingNormal{0.0f};  ///< world space, unit, on the side of the geometric normal; 0: nothing hit
    Vec3 geometricNormal{0.0f};
    float depth = 0.0f;
    uint32_t objectId = 0;
    uint32_t materialId = 0;
    float boxesTested = 0.0f;  ///< counts; their means over passes need not be whole
    float primitivesTested = 0.0f;
    float newtonSteps = 0.0f;
};

/// One camera path. When fault is not None, radiance is 0 and must not enter the film.
struct PixelSample {
    Vec3 radiance{0.0f};
    SampleFault fault = SampleFault::None;
    uint32_t rays = 0;  ///< rays traced, shadow rays included
};

}  // namespace glint
