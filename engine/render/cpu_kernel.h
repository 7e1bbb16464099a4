// The tile loops that the CPU variants compile, and the masks they are compiled for.
//
// cpu_variants.cpp takes their addresses; each cpu_kernel_<name>.cpp holds the code of one mask, so that they
// compile side by side. Only cpu_kernel_*.cpp may include cpu_kernel_tile.h.
#pragma once

#include "engine/render/cpu_variants.h"

namespace glint {

template <FeatureMask kMask>
void renderTile(const SceneView& view, const PassParams& params, const PixelRect& tile, PixelSample* image);

template <FeatureMask kMask>
void renderAovTile(const SceneView& view, const PassParams& params, const PixelRect& tile, AovSample* image);

constexpr FeatureMask kAnalyticShapes = kFeatureSphere | kFeaturePlane | kFeatureFlat;
constexpr FeatureMask kSmoothMaterials =
    kFeatureDiffuse | kFeatureSpecular | kFeatureDielectric | kFeatureMixture;
constexpr FeatureMask kFewLightKinds = kFeatureAreaLights | kFeatureDeltaLights | kFeatureEnvironmentConstant;

/// A Cornell box: analytic shapes, diffuse, lit by a few of them.
constexpr FeatureMask kMaskDiffuseShapes = kAnalyticShapes | kFeatureDiffuse | kFeatureAreaLights;
/// The same with glass and mirrors, any kind of light but images, and a lens.
constexpr FeatureMask kMaskSmoothShapes =
    kAnalyticShapes | kFeatureFrontOnly | kSmoothMaterials | kFewLightKinds | kFeatureDepthOfField;
/// Architecture and scans: textured diffuse meshes with any number of lights.
constexpr FeatureMask kMaskDiffuseMeshes = kAnalyticShapes | kFeatureMesh | kFeatureMeshNormals |
                                           kFeatureTransforms | kFeatureTextures | kFeatureDiffuse |
                                           kFewLightKinds | kFeatureManyLights | kFeatureDepthOfField;
/// All shapes and materials, but no environment image and one sampler.
constexpr FeatureMask kMaskNoEnvironmentImage =
    kAllFeatures & ~(kFeatureEnvironmentImage | kFeatureIndependentSampler);

}  // namespace glint
