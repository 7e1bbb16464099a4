#include "tests/support/bsdf_cases.h"

#include <fmt/format.h>

#include "engine/builders/coat_albedo.h"
#include "engine/scene/kind_names.h"
#include "engine/scene/material.h"
#include "engine/scene/metals.h"

namespace glint::test {

MaterialData diffuseMaterial(const Vec3& color) {
    MaterialData data;
    data.color = color;
    return data;
}

MaterialData mirrorMaterial(const Vec3& color) {
    MaterialData data = diffuseMaterial(color);
    data.kind = MaterialKind::Mirror;
    return data;
}

MaterialData conductorMaterial(const std::string& metal, float alpha) {
    MaterialData data = diffuseMaterial(Vec3(1.0f));
    data.kind = MaterialKind::Conductor;
    data.inputs.eta = findMetal(metal)->eta;
    data.inputs.k = findMetal(metal)->k;
    data.inputs.roughness = alpha;
    return data;
}

MaterialData dielectricMaterial(float ior, float alpha, bool thin) {
    MaterialData data = diffuseMaterial(Vec3(1.0f));
    data.kind = MaterialKind::Dielectric;
    data.inputs.ior = ior;
    data.inputs.roughness = alpha;
    data.flags = thin ? kMaterialThin : 0;
    return data;
}

MaterialData plasticMaterial(const Vec3& color, float ior, float alpha) {
    MaterialData data = diffuseMaterial(color);
    data.kind = MaterialKind::Plastic;
    data.inputs.ior = ior;
    data.inputs.roughness = alpha;
    data.inputs.coat = tabulateCoat(ior, alpha);
    return data;
}

MaterialData mixtureMaterial(const Vec3& color, const Vec3& probability, float ior) {
    MaterialData data = diffuseMaterial(color);
    data.kind = MaterialKind::Mixture;
    data.inputs.mixtureWeights = probability;
    data.inputs.ior = ior;
    return data;
}

MaterialData principledMaterial(const Vec3& color, float alpha, float metallic, float coat, float coatAlpha,
                                const Vec3& sheen) {
    MaterialData data = plasticMaterial(color, 1.5f, alpha);
    data.kind = MaterialKind::Principled;
    data.inputs.metallic = metallic;
    data.inputs.clearcoat = coat;
    data.inputs.clearcoatRoughness = coatAlpha;
    data.inputs.sheenColor = sheen;
    return data;
}

MaterialData withPassing(MaterialData material, float share, bool isSheet, bool isRootTint) {
    material.flags |=
        kMaterialTransmits | (isSheet ? kMaterialThin : 0) | (isRootTint ? kMaterialRootTint : 0);
    material.inputs.specularTransmission = share;
    return material;
}

float bendingIor(const MaterialData& material) {
    return (material.flags & kMaterialThin) != 0 ? 1.0f : material.inputs.ior;
}

MaterialData withFacets(MaterialData material, float alphaY, FacetDistribution distribution) {
    material.flags |= kMaterialFacets;
    material.distribution = distribution;
    material.inputs.crossRoughness = alphaY;
    if (hasCoatTable(material.kind)) { tabulateCrossedCoat(distribution, &material.inputs); }
    return material;
}

MaterialData phongMaterial(const Vec3& color, const Vec3& specular, float exponent) {
    MaterialData data = diffuseMaterial(color);
    data.kind = MaterialKind::Phong;
    data.inputs.specularReflectance = specular;
    data.inputs.exponent = exponent;
    return data;
}

MaterialData coatedMaterial(const std::string& metal, float alpha, float ior, float coatAlpha,
                            const Vec3& absorption) {
    MaterialData data = conductorMaterial(metal, alpha);
    data.kind = MaterialKind::Coated;
    data.inputs.ior = ior;
    data.inputs.clearcoatRoughness = coatAlpha;
    data.inputs.coatAbsorption = absorption;
    return data;
}

MaterialData wardMaterial(const Vec3& color, const Vec3& specular, Vec2 alpha, WardForm form) {
    MaterialData data = diffuseMaterial(color);
    data.kind = MaterialKind::Ward;
    data.wardForm = form;
    data.inputs.specularReflectance = specular;
    data.inputs.roughness = alpha.x;
    data.inputs.crossRoughness = alpha.y;
    data.flags = alpha.x != alpha.y ? kMaterialFacets : 0;
    return data;
}

/// Phong's and Ward's models, with and without a diffuse part, and with too much of both.
void addHighlightCases(std::vector<BsdfCase>* cases) {
    const Vec3 black(0.0f), white(1.0f), grey(0.5f), few(0.2f, 0.1f, 0.5f);
    for (const float exponent : {0.0f, 3.0f, 30.0f, 1e4f, 1e6f}) {
        cases->push_back({fmt::format("phong {}", exponent), phongMaterial(grey, few, exponent)});
        cases->push_back({fmt::format("phong white {}", exponent), phongMaterial(black, white, exponent)});
        cases->push_back({fmt::format("phong too bright {}", exponent), phongMaterial(white, few, exponent)});
    }
    cases->push_back({"phong black", phongMaterial(black, black, 30.0f)});
    for (const WardForm form : {WardForm::Ward, WardForm::Duer, WardForm::Balanced}) {
        for (const Vec2 alpha :
             {Vec2(1e-3f), Vec2(0.1f), Vec2(0.5f), Vec2(1.0f), Vec2(0.02f, 0.3f), Vec2(0.6f, 0.1f)}) {
            const std::string name = fmt::format("{} by {}", alpha.x, alpha.y);
            const std::string_view variant = nameOf(form);
            cases->push_back(
                {fmt::format("ward {} {}", variant, name), wardMaterial(grey, few, alpha, form)});
            cases->push_back(
                {fmt::format("ward {} white {}", variant, name), wardMaterial(black, white, alpha, form)});
        }
        cases->push_back(
            {fmt::format("ward {} too bright", nameOf(form)), wardMaterial(grey, white, Vec2(0.2f), form)});
    }
}

/// Materials of facets other than GGX with one alpha.
void addFacetCases(const Vec3& color, std::vector<BsdfCase>* cases) {
    constexpr FacetDistribution kGgx = FacetDistribution::Ggx, kBeckmann = FacetDistribution::Beckmann;
    const auto add = [&](const std::string& name, const MaterialData& material, float alphaY) {
        for (const FacetDistribution distribution : {kGgx, kBeckmann}) {
            if (distribution == kBeckmann && material.kind == MaterialKind::Principled) { continue; }
            if (distribution == kGgx && alphaY == material.inputs.roughness) { continue; }
            cases->push_back(
                {fmt::format("{} {} {} by {}", name, nameOf(distribution), material.inputs.roughness, alphaY),
                 withFacets(material, alphaY, distribution)});
        }
    };
    for (const Vec2 alpha :
         {Vec2(1e-3f, 1e-3f), Vec2(0.3f), Vec2(1.0f), Vec2(0.02f, 0.3f), Vec2(0.6f, 0.1f)}) {
        add("conductor", conductorMaterial("gold", alpha.x), alpha.y);
        add("dielectric 1.5", dielectricMaterial(1.5f, alpha.x), alpha.y);
        add("dielectric 0.6", dielectricMaterial(0.6f, alpha.x), alpha.y);
        add("plastic", plasticMaterial(color, 1.5f, alpha.x), alpha.y);
        add("plastic white", plasticMaterial(Vec3(1.0f), 1.5f, alpha.x), alpha.y);
        add("principled", principledMaterial(color, alpha.x, 0.0f), alpha.y);
        add("principled metal", principledMaterial(Vec3(1.0f), alpha.x, 1.0f, 0.6f, 0.1f), alpha.y);
        add("principled white, half metal", principledMaterial(Vec3(1.0f), alpha.x, 0.5f), alpha.y);
    }
}

/// Principled materials of which each has other layers.
void addPrincipledCases(const Vec3& color, std::vector<BsdfCase>* cases) {
    const Vec3 white(1.0f);
    for (const float alpha : {0.0f, 0.05f, 0.3f, 1.0f}) {
        cases->push_back({fmt::format("principled {}", alpha), principledMaterial(color, alpha, 0.0f)});
        cases->push_back({fmt::format("principled metal {}", alpha), principledMaterial(color, alpha, 1.0f)});
        cases->push_back({fmt::format("principled white, coated with its roughness {}", alpha),
                          principledMaterial(white, alpha, 0.5f, 1.0f, alpha, white)});
        cases->push_back({fmt::format("principled cloth {}", alpha),
                          principledMaterial(white, 0.8f, 0.0f, 0.0f, 0.0f, Vec3(0.9f, 0.5f, 1.0f))});
        cases->back().material.inputs.sheenRoughness = alpha;
    }
    cases->push_back({"principled car paint", principledMaterial(color, 0.4f, 0.7f, 1.0f, 0.0f)});
    cases->push_back({"principled metal, coated", principledMaterial(white, 0.0f, 1.0f, 1.0f, 0.0f)});
    cases->push_back(
        {"principled mirror under a rough coat", principledMaterial(white, 0.0f, 1.0f, 0.8f, 0.2f)});
    cases->push_back({"principled tinted", principledMaterial(color, 0.2f, 0.2f, 0.5f, 0.1f, Vec3(0.3f))});
    cases->back().material.inputs.specular = 0.6f;
    cases->back().material.inputs.specularTint = Vec3(0.0f, 1.0f, 0.4f);
    cases->push_back({"principled black", principledMaterial(Vec3(0.0f), 0.0f, 0.0f)});
    cases->back().material.inputs.specular = 0.0f;
}

/// Metals under coats.
void addCoatedCases(std::vector<BsdfCase>* cases) {
    for (const float alpha : {0.0f, 0.02f, 0.3f, 1.0f}) {
        for (const float coatAlpha : {0.0f, 0.1f, 0.6f}) {
            for (const float ior : {1.0f, 1.5f, 2.5f}) {
                cases->push_back({fmt::format("coated {} under {} of {}", alpha, coatAlpha, ior),
                                  coatedMaterial("silver", alpha, ior, coatAlpha, Vec3(0.0f, 0.2f, 1.0f))});
            }
        }
    }
    cases->push_back({"coated, brushed", withFacets(coatedMaterial("silver", 0.4f, 1.5f, 0.0f), 0.1f,
                                                    FacetDistribution::Beckmann)});
}

/// Principled materials that let light pass.
void addPassingCases(const Vec3& color, std::vector<BsdfCase>* cases) {
    const Vec3 white(1.0f);
    for (const float alpha : {0.0f, 0.02f, 0.3f, 1.0f}) {
        for (const bool isSheet : {false, true}) {
            const auto add = [&](const char* name, const MaterialData& material, float share) {
                cases->push_back({fmt::format("passing {} {} {}", name, isSheet ? "sheet" : "body", alpha),
                                  withPassing(material, share, isSheet, !isSheet)});
            };
            add("white", principledMaterial(white, alpha, 0.0f), 1.0f);
            add("half", principledMaterial(color, alpha, 0.0f), 0.5f);
            add("metal", principledMaterial(color, alpha, 0.7f), 0.8f);
            add("layered", principledMaterial(white, alpha, 0.2f, 0.8f, 0.2f, Vec3(0.8f, 0.4f, 1.0f)), 0.7f);
            if (alpha > 0.0f) {
                add("brushed",
                    withFacets(principledMaterial(white, alpha, 0.0f), 0.15f, FacetDistribution::Ggx), 0.7f);
            }
        }
    }
    MaterialData weak = principledMaterial(white, 0.3f, 0.0f);
    weak.inputs.specular = 0.5f;
    weak.inputs.specularTint = Vec3(1.0f, 0.5f, 0.0f);
    cases->push_back({"passing, less reflected", withPassing(weak, 0.9f, false)});
}

float narrowestAlpha(const MaterialData& material) {
    const ShadingInputs& in = material.inputs;
    if (material.kind == MaterialKind::Phong) {
        return std::fmin(std::sqrt(2.0f / (in.exponent + 2.0f)), 1.0f);
    }
    if (material.kind == MaterialKind::Ward) { return std::fmin(in.roughness, in.crossRoughness); }
    const bool isCoated = material.kind == MaterialKind::Coated;
    const bool hasRoughCoat = (isCoated || in.clearcoat > 0.0f) && in.clearcoatRoughness >= kSmoothAlpha;
    const float base = (isCoated || material.kind == MaterialKind::Principled) && detail::isSmooth(in)
                           ? 1.0f
                           : detail::narrowestAlpha<kAllFeatures>(material, in);
    return hasRoughCoat ? std::fmin(base, in.clearcoatRoughness) : base;
}

MaterialData translucentMaterial(const Vec3& color, const Vec3& transmission) {
    MaterialData data = diffuseMaterial(color);
    data.kind = MaterialKind::Translucent;
    data.inputs.transmission = transmission;
    data.inputs.ior = 1.0f;  // it bends nothing
    return data;
}

std::vector<BsdfCase> allBsdfCases() {
    const Vec3 color(0.8f, 0.5f, 0.2f);
    std::vector<BsdfCase> cases{
        {"diffuse", diffuseMaterial(color)},
        {"diffuse white", diffuseMaterial(Vec3(1.0f))},
        {"mirror", mirrorMaterial(color)},
        {"conductor gold smooth", conductorMaterial("gold", 0.0f)},
        {"dielectric 1.5 smooth", dielectricMaterial(1.5f, 0.0f)},
        {"dielectric 0.6 smooth", dielectricMaterial(0.6f, 0.0f)},
        {"dielectric 1 smooth", dielectricMaterial(1.0f, 0.0f)},
        {"dielectric 1.5 thin", dielectricMaterial(1.5f, 0.0f, true)},
        {"mixture", mixtureMaterial(color, Vec3(0.5f, 0.3f, 0.2f), 1.5f)},
        {"mixture no diffuse", mixtureMaterial(color, Vec3(0.0f, 0.4f, 0.6f), 1.8f)},
        {"translucent", translucentMaterial(Vec3(0.1f, 0.5f, 0.2f), Vec3(0.8f, 0.4f, 0.3f))},
        {"translucent, passing all", translucentMaterial(Vec3(0.0f), Vec3(1.0f))},
        {"translucent, too bright", translucentMaterial(Vec3(0.9f, 0.2f, 0.5f), Vec3(0.6f))},
        {"plastic smooth", plasticMaterial(color, 1.5f, 0.0f)},
        {"plastic white smooth", plasticMaterial(Vec3(1.0f), 1.9f, 0.0f)},
        {"plastic black smooth", plasticMaterial(Vec3(0.0f), 1.5f, 0.0f)},
    };
    addPrincipledCases(color, &cases);
    addPassingCases(color, &cases);
    addCoatedCases(&cases);
    addFacetCases(color, &cases);
    addHighlightCases(&cases);
    for (const float alpha : {1e-3f, 1e-2f, 0.1f, 0.3f, 1.0f}) {
        cases.push_back({fmt::format("conductor gold {}", alpha), conductorMaterial("gold", alpha)});
        cases.push_back({fmt::format("dielectric 1.5 {}", alpha), dielectricMaterial(1.5f, alpha)});
        cases.push_back({fmt::format("dielectric 0.6 {}", alpha), dielectricMaterial(0.6f, alpha)});
        cases.push_back({fmt::format("dielectric 2.4 {}", alpha), dielectricMaterial(2.4f, alpha)});
        cases.push_back({fmt::format("plastic {}", alpha), plasticMaterial(color, 1.5f, alpha)});
        cases.push_back({fmt::format("plastic white {}", alpha), plasticMaterial(Vec3(1.0f), 1.5f, alpha)});
    }
    return cases;
}

Vec3 directionAt(float cosine, float phiRad) {
    const float sine = safeSqrt((1.0f - cosine) * (1.0f + cosine));
    return {sine * std::cos(phiRad), sine * std::sin(phiRad), cosine};
}

Bsdf<kAllFeatures> testBsdf(const MaterialData& material, const Vec3& wo, const TestSurface& surface,
                            TransportMode transport) {
    return makeBsdf<kAllFeatures>(MaterialScene(material), surface, wo, transport);
}

}  // namespace glint::test
