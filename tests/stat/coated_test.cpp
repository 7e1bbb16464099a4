// Metals under smooth coats against the metal alone at refracted directions, and what Fresnel and Beer say.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/bsdf_cases.h"
#include "tests/support/uniform_numbers.h"

namespace glint::test {
namespace {

/// The reflectance of a boundary between dielectrics by Fresnel's equations.
double fresnel(double cosine, double ior) {
    const double inside = std::sqrt(1.0 - (1.0 - cosine * cosine) / (ior * ior));
    const double s = (cosine - ior * inside) / (cosine + ior * inside);
    const double p = (ior * cosine - inside) / (ior * cosine + inside);
    return 0.5 * (s * s + p * p);
}

Vec3 refractedInto(const Vec3& w, float ior) {
    return {w.x / ior, w.y / ior, std::sqrt(1.0f - (1.0f - w.z * w.z) / (ior * ior))};
}

const Vec3 kAbsorption(0.0f, 0.3f, 1.5f);

double left(int channel, const Vec3& a, const Vec3& b) {
    return std::exp(-static_cast<double>(kAbsorption[channel]) *
                    (1.0 / static_cast<double>(a.z) + 1.0 / static_cast<double>(b.z)));
}

TEST(Coated, RoughMetalIsSeenThroughTheCoat) {
    UniformNumbers random(1);
    for (const float ior : {1.0f, 1.5f, 2.2f}) {
        const MaterialData coated = coatedMaterial("gold", 0.4f, ior, 0.0f, kAbsorption);
        const MaterialData metal = conductorMaterial("gold", 0.4f);
        for (int i = 0; i < 2000; ++i) {
            const Vec3 wo = sampleCosineHemisphere(random.next2()),
                       wi = sampleCosineHemisphere(random.next2());
            if (wo.z < 0.02f || wi.z < 0.02f) { continue; }
            const Vec3 woIn = refractedInto(wo, ior), wiIn = refractedInto(wi, ior);
            const Vec3 f = evaluate(testBsdf(metal, woIn), wiIn) / wiIn.z;
            const double passes = (1.0 - fresnel(static_cast<double>(wo.z), static_cast<double>(ior))) *
                                  (1.0 - fresnel(static_cast<double>(wi.z), static_cast<double>(ior))) /
                                  static_cast<double>(ior * ior);
            const Vec3 found = evaluate(testBsdf(coated, wo), wi) / wi.z;
            for (int c = 0; c < 3; ++c) {
                const double wanted = static_cast<double>(f[c]) * passes * left(c, woIn, wiIn);
                EXPECT_NEAR(static_cast<double>(found[c]), wanted, 2e-4 * wanted + 1e-7);
            }
        }
    }
}

TEST(Coated, SmoothLayersAreOneMirror) {
    for (const float ior : {1.0f, 1.5f, 2.2f}) {
        const MaterialData coated = coatedMaterial("copper", 0.0f, ior, 0.0f, kAbsorption);
        const MaterialData metal = conductorMaterial("copper", 0.0f);
        for (const float cosine : {1.0f, 0.6f, 0.1f}) {
            const Vec3 wo = directionAt(cosine), inside = refractedInto(wo, ior);
            const BsdfSample s = sample(testBsdf(coated, wo), 0.5f, Vec2(0.5f));
            const BsdfSample m = sample(testBsdf(metal, inside), 0.5f, Vec2(0.5f));
            ASSERT_TRUE(s.valid && s.isSpecular);
            const double r = fresnel(static_cast<double>(cosine), static_cast<double>(ior));
            for (int c = 0; c < 3; ++c) {
                const double below =
                    (1.0 - r) * (1.0 - r) * static_cast<double>(m.weight[c]) * left(c, inside, inside);
                EXPECT_NEAR(static_cast<double>(s.weight[c]), r + below, 1e-5);
            }
        }
    }
}

}  // namespace
}  // namespace glint::test
