// Materials and directions that the BSDF tests run over, and one material at a point for tests without
// a scene.
#pragma once

#include <string>
#include <vector>

#include "engine/kernels/bsdf/bsdf.h"

namespace glint::test {

/// What makeBsdf() needs of a surface point.
struct TestSurface {
    Vec3 ng{0.0f, 0.0f, 1.0f};
    Vec3 ns{0.0f, 0.0f, 1.0f};
    Vec2 uv{0.0f};
    Vec3 vertexColor{1.0f};
    Vec3 dpdu{1.0f, 0.0f, 0.0f};
    Vec3 dpdv{0.0f, 1.0f, 0.0f};
    uint32_t material = 0;
};

/// What makeBsdf() needs of a scene: one material.
struct MaterialScene {
    explicit MaterialScene(const MaterialData& material) : materials{&material, 1} {}

    View<MaterialData> materials;
    View<TextureView> textures;
    View<CoatRow> coats;
};

struct BsdfCase {
    std::string name;
    MaterialData material;
};

MaterialData diffuseMaterial(const Vec3& color);
MaterialData mirrorMaterial(const Vec3& color);
MaterialData conductorMaterial(const std::string& metal, float alpha);
MaterialData dielectricMaterial(float ior, float alpha, bool thin = false);
MaterialData plasticMaterial(const Vec3& color, float ior, float alpha);
MaterialData mixtureMaterial(const Vec3& color, const Vec3& probability, float ior);
/// An index of 1.5; `coat` is the share that has one of alpha coatAlpha.
MaterialData principledMaterial(const Vec3& color, float alpha, float metallic, float coat = 0.0f,
                                float coatAlpha = 0.0f, const Vec3& sheen = Vec3(0.0f));
/// The principled material with this share of what enters passing: a body, or a sheet.
MaterialData withPassing(MaterialData material, float share, bool isSheet, bool isRootTint = false);
/// The material with facets of another distribution, or with another alpha along y.
MaterialData withFacets(MaterialData material, float alphaY, FacetDistribution distribution);
MaterialData phongMaterial(const Vec3& color, const Vec3& specular, float exponent);
MaterialData wardMaterial(const Vec3& color, const Vec3& specular, Vec2 alpha, WardForm form);
/// A metal under a coat of this index, GGX alpha and optical depth.
MaterialData coatedMaterial(const std::string& metal, float alpha, float ior, float coatAlpha,
                            const Vec3& absorption = Vec3(0.0f));
MaterialData translucentMaterial(const Vec3& color, const Vec3& transmission);

/// Every kind over its range of parameters: roughness 0 and 1e-3 to 1, indices below and above 1.
std::vector<BsdfCase> allBsdfCases();

/// Index behind over that before the surface where light is bent, seen from its front; 1: it passes straight.
float bendingIor(const MaterialData& material);

/// The alpha of the narrowest lobe that has a density; 1 where none has facets.
float narrowestAlpha(const MaterialData& material);

/// The unit direction at an angle of acos(cosine) to +z; negative cosines are on the back.
Vec3 directionAt(float cosine, float phiRad = 0.7f);

/// The full-featured BSDF of a material on a flat surface with normal +z (or as given). The material must
/// outlive it.
Bsdf<kAllFeatures> testBsdf(const MaterialData& material, const Vec3& wo, const TestSurface& surface = {},
                            TransportMode transport = TransportMode::Radiance);

}  // namespace glint::test
