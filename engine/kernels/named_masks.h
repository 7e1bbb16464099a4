// The feature masks that kernels are compiled for ahead of time, by name.
//
// The CPU's variants (render/cpu_variants.cpp) and the GPU's (cuda/cuda_variants.cpp) choose from them.
#pragma once

#include "engine/kernels/features.h"

namespace glint {

constexpr FeatureMask kAnalyticShapes = kFeatureCurved | kFeaturePlane | kFeatureFlat;
constexpr FeatureMask kMeshes = kFeatureMesh | kFeatureMeshNormals | kFeatureMeshColors;
constexpr FeatureMask kSmoothMaterials =
    kFeatureDiffuse | kFeatureSpecular | kFeatureDielectric | kFeatureMixture;
constexpr FeatureMask kFewLightKinds = kFeatureAreaLights | kFeatureDeltaLights | kFeatureEnvironmentConstant;

/// A Cornell box: analytic shapes, diffuse, lit by a few of them.
constexpr FeatureMask kMaskDiffuseShapes =
    kAnalyticShapes | kFeatureFrontOnly | kFeatureDiffuse | kFewLightKinds;
/// The same with glass and mirrors, and a lens.
constexpr FeatureMask kMaskSmoothShapes = kMaskDiffuseShapes | kSmoothMaterials | kFeatureCameraArea;
/// The same with surfaces of revolution, which on a GPU cost stack even where there are none.
constexpr FeatureMask kMaskSmoothRevolvedShapes = kMaskSmoothShapes | kFeatureRevolved;
/// A scan, a model from a file, architecture: diffuse meshes beside analytic shapes.
constexpr FeatureMask kMaskDiffuseMeshes = kMaskDiffuseShapes | kMeshes | kFeatureTransforms |
                                           kFeatureTextures | kFeatureManyLights | kFeatureCameraArea;
/// The same with glass, mirrors, mixtures and bumps: textured rooms.
constexpr FeatureMask kMaskSmoothMeshes = kMaskDiffuseMeshes | kSmoothMaterials | kFeatureBumps;
/// Everything with one sampler, but for what few scenes have: textures on inputs other than the colour,
/// placed and mip-mapped ones, surfaces of revolution, bumps, cut-outs, dispersion, glass that absorbs,
/// translucent sheets, principled materials that let light pass, facets other than GGX with one alpha,
/// Phong's and Ward's models, metals under coats, projectors, portals and other acceleration structures.
constexpr FeatureMask kMaskOneSampler =
    kAllFeatures &
    ~(kFeatureIndependentSampler | kFeatureInputTextures | kFeaturePlacedTextures | kFeatureMipmaps |
      kFeatureRevolved | kFeatureBumps | kFeatureCutouts | kFeatureDispersion | kFeatureAttenuation |
      kFeatureTranslucent | kFeatureAccelerators | kFeatureFacets | kFeatureProjectors | kFeatureHighlights |
      kFeatureTransmission | kFeatureCoated | kFeaturePortal);

}  // namespace glint
