#include "engine/builders/coat_albedo.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/kernels/bsdf/plastic.h"

namespace glint {
namespace {

float fresnelAt(float mu, float ior) {
    float cosT = 0.0f;
    return fresnelDielectric(mu, ior, &cosT);
}

/// 2 times the integral of E(mu) mu over [0, 1], as a sum over the albedo table's variable t = sqrt(mu),
/// where it is smooth: 4 E t^3 dt.
template <class Albedo>
float cosineMean(const Albedo& albedo, int steps) {
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double t = (i + 0.5) / steps;
        sum += 4.0 * static_cast<double>(albedo(static_cast<float>(t * t))) * t * t * t / steps;
    }
    return static_cast<float>(sum);
}

/// Facets as the models ask for them.
template <class Facets>
float coatAlbedoOf(float ior, const Facets& facets, const Vec3& wo) {
    constexpr int kSteps = 16;
    float sum = 0.0f;
    for (int i = 0; i < kSteps * kSteps; ++i) {
        const int column = i % kSteps, row = i / kSteps;
        const Vec2 u((static_cast<float>(column) + 0.5f) / kSteps, (static_cast<float>(row) + 0.5f) / kSteps);
        const Vec3 h = facets.sampleNormal(wo, u);
        const Vec3 wi = reflect(wo, h);
        if (wi.z > 0.0f) {
            const float cosine = clampf(glm::dot(wo, h), 0.0f, 1.0f);
            sum += fresnelAt(cosine, ior) * facets.reflectionWeight(wo, wi);
        }
    }
    return std::fmin(sum / (kSteps * kSteps), 1.0f);
}

Vec3 directionAt(float mu, bool across = false) {
    const float sine = safeSqrt((1.0f - mu) * (1.0f + mu));
    return across ? Vec3(0.0f, sine, mu) : Vec3(sine, 0.0f, mu);
}

/// A row whose albedo at cosine mu is albedo(mu); `alpha` tells whether it is smooth.
template <class Albedo>
CoatRow tabulate(float ior, float alpha, const Albedo& albedo) {
    ShadingInputs inputs;
    inputs.ior = ior;
    inputs.roughness = alpha;
    CoatRow& row = inputs.coat;
    const float smoothMean = cosineMean([&](float mu) { return fresnelAt(mu, ior); }, 512);
    // What cannot get out: reciprocity of the smooth boundary, (1 - Eavg) = ior^2 (1 - Fi).
    row.internalAlbedo = clampf(1.0f - (1.0f - smoothMean) / square(ior), 0.0f, 1.0f);
    row.averageAlbedo = smoothMean;
    if (alpha < kSmoothAlpha) {
        std::fill(std::begin(row.ratio), std::end(row.ratio), 1.0f);
        return row;
    }
    for (int i = 1; i < kCoatSamples; ++i) {
        const float mu = square(static_cast<float>(i) / (kCoatSamples - 1));
        const float fresnel = fresnelAt(mu, ior);
        row.ratio[i] = fresnel > 0.0f ? albedo(mu) / fresnel : 0.0f;
    }
    // Below the first entry, within 0.06 degrees of grazing, narrow lobes have a dip that the table cannot
    // resolve: the larger value loses a little light there, the smaller would gain some.
    const float grazing = albedo(1e-4f) / std::fmax(fresnelAt(1e-4f, ior), 1e-6f);
    row.ratio[0] = std::fmax(row.ratio[1], grazing);
    // The mean of what the kernel interpolates, not of the exact albedo: energy is then conserved exactly.
    row.averageAlbedo = cosineMean([&](float mu) { return detail::coatAlbedo(inputs, row, mu); }, 512);
    return row;
}

}  // namespace

float roughCoatAlbedo(float ior, const GeneralFacets& facets, const Vec3& wo) {
    return coatAlbedoOf(ior, facets, wo);
}

float roughCoatAlbedo(float ior, float alpha, float mu) {
    return coatAlbedoOf(ior, GgxFacets{alpha}, directionAt(mu));
}

CoatRow tabulateCoat(float ior, float alpha) {
    return tabulate(ior, alpha, [&](float mu) { return roughCoatAlbedo(ior, alpha, mu); });
}

CoatRow tabulateCoat(float ior, const GeneralFacets& facets, bool across) {
    return tabulate(ior, std::fmax(facets.alphaX, facets.alphaY),
                    [&](float mu) { return roughCoatAlbedo(ior, facets, directionAt(mu, across)); });
}

void tabulateCrossedCoat(FacetDistribution distribution, ShadingInputs* inputs) {
    const GeneralFacets facets{inputs->roughness, inputs->crossRoughness, distribution};
    inputs->coat = tabulateCoat(inputs->ior, facets, false);
    inputs->crossCoat =
        facets.alphaX == facets.alphaY ? inputs->coat : tabulateCoat(inputs->ior, facets, true);
    const float average = 0.5f * (inputs->coat.averageAlbedo + inputs->crossCoat.averageAlbedo);
    inputs->coat.averageAlbedo = average;
    inputs->crossCoat.averageAlbedo = average;
}

}  // namespace glint
