// Editable materials. Plain data: what the panels edit and the scene files hold.
//
// Deliberately left out: node graphs, layers beyond one coat, subsurface and volumes.
#pragma once

#include <cstdint>
#include <string>

#include "engine/base/kinds.h"
#include "engine/math/vec.h"

namespace glint {

/// A linear colour, or an image that replaces it.
struct ColorInput {
    Vec3 value{0.5f};
    int texture = -1;  ///< index into SceneDescription::textures, or -1
};

struct Material {
    std::string name;
    MaterialKind kind = MaterialKind::Diffuse;

    /// Diffuse, plastic: albedo. Mirror: reflectance. Dielectric: tint of what passes and reflects. Mixture:
    /// all three. Conductor: a factor on the Fresnel reflectance, 1 by default. Range [0, 1].
    ColorInput color;

    std::string metal = "gold";  ///< conductor: measured constants by name (metals.h); empty: use eta and k
    Vec3 eta{0.2f};              ///< conductor without a metal name: index of refraction at R, G, B
    Vec3 k{3.9f};                ///< conductor without a metal name: extinction at R, G, B

    float ior = 1.5f;  ///< dielectric, plastic, mixture: interior over exterior index of refraction, > 0
    /// conductor, dielectric, plastic: GGX alpha in [0, 1]; below kSmoothAlpha: smooth
    float roughness = 0.0f;
    bool thin = false;                      ///< dielectric only
    Vec3 mixtureWeights{1.0f, 0.0f, 0.0f};  ///< diffuse, mirror, refractive; not negative, not all zero

    Vec3 emission{0.0f};            ///< radiance factor, W/(sr m^2) per channel
    float emissionStrength = 1.0f;  ///< multiplies `emission`
    bool emitsBothSides = false;    ///< otherwise only the side the geometric normal points to

    bool emissive() const { return emissionStrength > 0.0f && maxComponent(emission) > 0.0f; }
};

}  // namespace glint
