// Principled materials that let light pass, against glass and against what their shares say.
#include <gtest/gtest.h>

#include "tests/support/bsdf_cases.h"
#include "tests/support/uniform_numbers.h"

namespace glint::test {
namespace {

const TransportMode kModes[]{TransportMode::Radiance, TransportMode::Importance};

/// A white body of which nothing scatters is glass.
TEST(Passing, WhiteBodiesAreGlass) {
    UniformNumbers random(1);
    for (const float alpha : {0.1f, 0.5f}) {
        const MaterialData body = withPassing(principledMaterial(Vec3(1.0f), alpha, 0.0f), 1.0f, false);
        const MaterialData glass = dielectricMaterial(1.5f, alpha);
        for (int i = 0; i < 2000; ++i) {
            const Vec3 wo = sampleSphere(random.next2()), wi = sampleSphere(random.next2());
            for (const TransportMode mode : kModes) {
                const float passes = evaluate(testBsdf(body, wo, {}, mode), wi).x;
                const float wanted = evaluate(testBsdf(glass, wo, {}, mode), wi).x;
                EXPECT_NEAR(passes, wanted, 1e-4f * wanted + 1e-7f) << wo.z << " " << wi.z;
            }
        }
    }
    const MaterialData body = withPassing(principledMaterial(Vec3(1.0f), 0.0f, 0.0f), 1.0f, false);
    const MaterialData glass = dielectricMaterial(1.5f, 0.0f);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 wo = sampleSphere(random.next2());
        const float uLobe = random.next();
        for (const TransportMode mode : kModes) {
            const BsdfSample a = sample(testBsdf(body, wo, {}, mode), uLobe, Vec2(0.5f));
            const BsdfSample b = sample(testBsdf(glass, wo, {}, mode), uLobe, Vec2(0.5f));
            if (a.isTransmission != b.isTransmission) { continue; }  // uLobe lies within rounding
            ASSERT_TRUE(a.valid && b.valid && a.isSpecular && b.isSpecular);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(a.weight[c], b.weight[c], 1e-4f * b.weight[c]);
                EXPECT_NEAR(a.wi[c], b.wi[c], 1e-5f);
            }
            EXPECT_FLOAT_EQ(a.etaScale, b.etaScale);
        }
    }
}

/// What passes is the share of what all would be, under the tint.
TEST(Passing, SharesAndTintsAreFactors) {
    UniformNumbers random(2);
    const Vec3 color(0.25f, 0.64f, 0.04f), root(0.5f, 0.8f, 0.2f);
    for (const bool isSheet : {false, true}) {
        const MaterialData all = withPassing(principledMaterial(Vec3(1.0f), 0.4f, 0.0f), 1.0f, isSheet);
        const MaterialData some = withPassing(principledMaterial(color, 0.4f, 0.25f), 0.6f, isSheet);
        MaterialData rooted = some;
        rooted.flags |= kMaterialRootTint;
        for (int i = 0; i < 1000; ++i) {
            const Vec3 wo = sampleSphere(random.next2());
            Vec3 wi = sampleSphere(random.next2());
            wi.z = std::copysign(wi.z, -wo.z);
            const float whole = evaluate(testBsdf(all, wo), wi).x;
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(evaluate(testBsdf(some, wo), wi)[c], 0.45f * color[c] * whole,
                            1e-4f * whole + 1e-7f);
                EXPECT_NEAR(evaluate(testBsdf(rooted, wo), wi)[c], 0.45f * root[c] * whole,
                            1e-4f * whole + 1e-7f);
            }
        }
    }
}

/// A sheet sends on straight what it does not reflect, and what its facets would reflect, mirrored.
TEST(Passing, SheetsDoNotBendLight) {
    UniformNumbers random(3);
    const MaterialData smooth = withPassing(principledMaterial(Vec3(1.0f), 0.0f, 0.0f), 1.0f, true);
    const MaterialData rough = withPassing(principledMaterial(Vec3(1.0f), 0.3f, 0.0f), 1.0f, true);
    const MaterialData metal = principledMaterial(Vec3(1.0f), 0.3f, 1.0f);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 wo = sampleSphere(random.next2());
        const BsdfSample straight = sample(testBsdf(smooth, wo), 0.9999f, Vec2(0.5f));
        if (straight.isTransmission) { EXPECT_LT(glm::length(straight.wi + wo), 1e-6f); }
        Vec3 wi = sampleSphere(random.next2());
        wi.z = std::copysign(wi.z, wo.z);
        const float sum =
            evaluate(testBsdf(rough, wo), wi).x + evaluate(testBsdf(rough, wo), Vec3(wi.x, wi.y, -wi.z)).x;
        const float reflected = evaluate(testBsdf(metal, wo), wi).x;
        EXPECT_NEAR(sum, reflected, 1e-4f * reflected + 1e-7f);
    }
}

}  // namespace
}  // namespace glint::test
