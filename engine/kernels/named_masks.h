// The feature masks that kernels are compiled for ahead of time, by name.
//
// The CPU's variants (render/cpu_variants.cpp) and the GPU's (cuda/cuda_variants.cpp) choose from them.
#pragma once

#include "engine/kernels/features.h"

namespace glint {

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
