// What a scene can need of a kernel, as bits. Kernels are templates on a mask and leave the rest out at
// compile time.
//
// feature_scan sets the bits; a kernel compiled for a superset of them may run.
#pragma once

#include <cstdint>

#include "engine/base/host_device.h"

namespace glint {

using FeatureMask = uint64_t;

enum Feature : FeatureMask {
    kFeatureCurved = 1u << 0,  ///< sphere
    kFeaturePlane = 1u << 1,
    kFeatureFlat = 1u << 2,  ///< rectangle, disc
    kFeatureMesh = 1u << 3,
    kFeatureMeshNormals = 1u << 4,
    kFeatureMeshColors = 1u << 5,
    kFeatureTransforms = 1u << 6,  ///< any mesh object with a transform other than the identity
    kFeatureFrontOnly = 1u << 7,
    kFeatureTextures = 1u << 8,
    kFeatureDiffuse = 1u << 9,
    kFeatureSpecular = 1u << 10,  ///< mirror, smooth conductor
    kFeatureDielectric = 1u << 11,
    kFeatureGlossy = 1u << 12,  ///< any lobe of facets but those of principled materials
    kFeaturePlastic = 1u << 13,
    kFeatureMixture = 1u << 14,
    kFeatureAreaLights = 1u << 15,
    kFeatureDeltaLights = 1u << 16,  ///< point, spot, directional, projector
    kFeatureEnvironmentConstant = 1u << 17,
    kFeatureEnvironmentImage = 1u << 18,
    kFeatureManyLights = 1u << 19,  ///< the light tree is used; otherwise a table of powers is enough
    kFeatureCameraArea = 1u << 20,  ///< camera rays begin in more than one point: a lens, parallel rays
    kFeatureIndependentSampler = 1u << 21,
    kFeatureInputTextures = 1u << 22,  ///< textures on inputs of materials other than the colour
    /// turned, moved, clamped or mirrored textures, nearest texels, changed values, other channels
    kFeaturePlacedTextures = 1u << 23,
    kFeatureRevolved = 1u << 24,        ///< surface of revolution
    kFeatureBumps = 1u << 25,           ///< height and normal maps
    kFeatureCutouts = 1u << 26,         ///< surfaces that are not there everywhere
    kFeatureMipmaps = 1u << 27,         ///< textures that are filtered by a pixel's width
    kFeatureDispersion = 1u << 28,      ///< glass whose index depends on the wavelength
    kFeatureAccelerators = 1u << 29,    ///< acceleration structures other than bounding volume hierarchies
    kFeatureAttenuation = 1u << 30,     ///< glass that absorbs light on its way inside
    kFeatureTranslucent = 1u << 31,     ///< sheets that let light through diffusely
    kFeaturePrincipled = 1ull << 32,    ///< coats and sheen over plastic or metal
    kFeatureFacets = 1ull << 33,        ///< facets other than GGX with one alpha
    kFeatureProjectors = 1ull << 34,    ///< lights that show a picture, or shine by one
    kFeaturePortal = 1ull << 35,        ///< an environment that shines through a rectangle alone
    kFeatureHighlights = 1ull << 36,    ///< Phong's and Ward's models
    kFeatureTransmission = 1ull << 37,  ///< principled materials that let light pass
    kFeatureCoated = 1ull << 38,        ///< metals under coats
    /// every surface point has dpdu and dpdv, not only those whose material needs them: for tests
    kFeatureTangents = 1ull << 63,
    /// any of these makes shading normals differ from geometric ones
    kFeatureShadingNormals = kFeatureMeshNormals | kFeatureBumps,
};

/// All that a scene can ask for.
constexpr FeatureMask kAllFeatures = (1ull << 39) - 1;
constexpr FeatureMask kMaterialFeatures =
    kFeatureDiffuse | kFeatureSpecular | kFeatureDielectric | kFeatureGlossy | kFeaturePlastic |
    kFeatureMixture | kFeatureTranslucent | kFeaturePrincipled | kFeatureHighlights | kFeatureCoated;

/// Whether the mask has the feature, or any of several.
template <FeatureMask kMask>
GLINT_HD constexpr bool hasFeature(FeatureMask feature) {
    return (kMask & feature) != 0;
}

}  // namespace glint
