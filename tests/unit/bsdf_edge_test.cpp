// BSDFs where formulas divide by zero: grazing and coinciding directions, extreme indices and roughness,
// bent normals.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/bsdf_cases.h"
#include "tests/support/chi_square.h"

namespace glint::test {
namespace {

bool isSane(const Vec3& v) { return isFinite(v) && minComponent(v) >= 0.0f; }

std::vector<BsdfCase> edgeCases() {
    std::vector<BsdfCase> cases = allBsdfCases();
    cases.push_back({"conductor at the limit of smooth", conductorMaterial("silver", kSmoothAlpha)});
    cases.push_back({"dielectric at the limit of smooth", dielectricMaterial(1.5f, kSmoothAlpha)});
    cases.push_back({"dielectric nearly without a boundary", dielectricMaterial(1.001f, 0.5f)});
    cases.push_back({"dielectric of an extreme index", dielectricMaterial(1e4f, 0.5f)});
    cases.push_back({"dielectric of a vanishing index", dielectricMaterial(1e-4f, 0.5f)});
    cases.push_back({"plastic of index 1", plasticMaterial(Vec3(0.5f), 1.0f, 0.2f)});
    cases.push_back({"plastic of index 1, black", plasticMaterial(Vec3(0.0f), 1.0f, 0.0f)});
    cases.push_back({"plastic of index 0.5", plasticMaterial(Vec3(0.5f), 0.5f, 0.0f)});
    cases.push_back({"principled without an index",
                     principledMaterial(Vec3(0.5f), 0.3f, 0.0f, 1.0f, kSmoothAlpha, Vec3(1.0f))});
    cases.back().material.inputs.ior = 1.0f;
    cases.back().material.inputs.sheenRoughness = 0.0f;
    MaterialData vacuum = conductorMaterial("gold", 0.1f);
    vacuum.inputs.eta = Vec3(1.0f);
    vacuum.inputs.k = Vec3(0.0f);
    cases.push_back({"conductor of vacuum", vacuum});
    vacuum.inputs.eta = Vec3(0.0f);
    cases.push_back({"conductor of nothing", vacuum});
    return cases;
}

const std::vector<float> kEdgeCosines{1.0f, 1e-3f, 1e-6f, 1e-20f, 0.0f, -1e-20f, -1e-6f, -0.5f, -1.0f};

TEST(BsdfEdges, SamplesAreFiniteEverywhere) {
    for (const BsdfCase& bsdfCase : edgeCases()) {
        for (const float cosine : kEdgeCosines) {
            const Bsdf<kAllFeatures> bsdf = testBsdf(bsdfCase.material, directionAt(cosine));
            for (const float uLobe : {0.0f, 0.3f, 0.6f, kOneMinusEpsilon}) {
                for (const float u : {0.0f, 0.5f, kOneMinusEpsilon}) {
                    for (const float v : {0.0f, 0.5f, kOneMinusEpsilon}) {
                        SCOPED_TRACE(
                            fmt::format("{} cosine {} u {} {} {}", bsdfCase.name, cosine, uLobe, u, v));
                        const BsdfSample s = sample(bsdf, uLobe, Vec2(u, v));
                        if (!s.valid) { continue; }
                        EXPECT_TRUE(isSane(s.weight)) << s.weight.x;
                        EXPECT_NEAR(glm::length(s.wi), 1.0f, 1e-4f);
                        EXPECT_TRUE(std::isfinite(s.pdfSolidAngle) && s.pdfSolidAngle >= 0.0f)
                            << s.pdfSolidAngle;
                        EXPECT_EQ(s.pdfSolidAngle == 0.0f, s.isSpecular);
                    }
                }
            }
        }
    }
}

TEST(BsdfEdges, ValuesAreFiniteEverywhere) {
    for (const BsdfCase& bsdfCase : edgeCases()) {
        for (const float cosO : kEdgeCosines) {
            const Bsdf<kAllFeatures> bsdf = testBsdf(bsdfCase.material, directionAt(cosO));
            for (const float cosI : kEdgeCosines) {
                for (const float phi : {0.7f, 0.7f + kPi, 2.0f}) {
                    const BsdfValue value = evaluateWithPdf(bsdf, directionAt(cosI, phi));
                    EXPECT_TRUE(isSane(value.value) && std::isfinite(value.pdfSolidAngle) &&
                                value.pdfSolidAngle >= 0.0f)
                        << bsdfCase.name << " " << cosO << " " << cosI << " " << phi;
                }
            }
        }
    }
}

TEST(BsdfEdges, IndexOneIsNotThere) {
    const Bsdf<kAllFeatures> bsdf = testBsdf(dielectricMaterial(1.0f, 0.0f), directionAt(0.3f));
    const BsdfSample s = sample(bsdf, 0.0f, Vec2(0.5f));
    ASSERT_TRUE(s.valid && s.isTransmission);
    EXPECT_LT(glm::length(s.wi + directionAt(0.3f)), 1e-6f);
    EXPECT_FLOAT_EQ(s.weight.x, 1.0f);
}

TEST(BsdfEdges, TotalInternalReflection) {
    // From inside glass of index 1.5, sin > 1 / 1.5 cannot leave.
    const Bsdf<kAllFeatures> bsdf = testBsdf(dielectricMaterial(1.5f, 0.0f), directionAt(-0.7f));
    const BsdfSample s = sample(bsdf, kOneMinusEpsilon, Vec2(0.5f));
    ASSERT_TRUE(s.valid);
    EXPECT_FALSE(s.isTransmission);
    EXPECT_LT(s.wi.z, 0.0f);
}

TEST(BsdfEdges, SnellsLaw) {
    const Vec3 wo = directionAt(0.6f);  // sin 0.8
    const BsdfSample s = sample(testBsdf(dielectricMaterial(1.6f, 0.0f), wo), kOneMinusEpsilon, Vec2(0.5f));
    ASSERT_TRUE(s.valid && s.isTransmission);
    EXPECT_NEAR(std::hypot(s.wi.x, s.wi.y), 0.5f, 1e-6f);
    EXPECT_LT(s.wi.z, 0.0f);
}

TEST(BsdfEdges, OpaqueMaterialsScatterOnTheBack) {
    for (const MaterialData& material :
         {diffuseMaterial(Vec3(0.5f)), plasticMaterial(Vec3(0.5f), 1.5f, 0.2f)}) {
        const Vec3 front = evaluate(testBsdf(material, directionAt(0.6f)), directionAt(0.3f, 2.0f));
        const Vec3 back = evaluate(testBsdf(material, directionAt(-0.6f)), directionAt(-0.3f, 2.0f));
        EXPECT_NEAR(front.x, back.x, 1e-6f);
        EXPECT_GT(front.x, 0.0f);
        EXPECT_EQ(evaluate(testBsdf(material, directionAt(0.6f)), directionAt(-0.3f)).x, 0.0f)
            << "nothing passes";
    }
}

/// With any shading normal: no light through opaque surfaces, and none of a mirror's is lost at
/// grazing angles.
TEST(BsdfShadingNormals, NeitherLeakNorGoBlack) {
    Random random(4);
    const MaterialData mirror = mirrorMaterial(Vec3(1.0f));
    const std::vector<MaterialData> opaque{
        diffuseMaterial(Vec3(0.5f)), plasticMaterial(Vec3(0.5f), 1.5f, 0.2f), conductorMaterial("gold", 0.3f),
        principledMaterial(Vec3(0.5f), 0.2f, 0.4f, 0.8f, 0.0f, Vec3(0.5f))};
    for (int i = 0; i < 3000; ++i) {
        TestSurface surface;
        surface.ns = directionAt(0.05f + 0.95f * random.uniform(), kTwoPi * random.uniform());
        const Vec3 wo = directionAt(std::fmax(random.uniform(), 1e-4f) * (i % 2 == 0 ? 1.0f : 0.02f),
                                    6.0f * random.uniform());
        const BsdfSample reflected = sample(testBsdf(mirror, wo, surface), 0.5f, Vec2(0.5f));
        ASSERT_TRUE(reflected.valid) << wo.z << " " << surface.ns.z;
        EXPECT_GT(reflected.wi.z, 0.0f);
        for (const MaterialData& material : opaque) {
            const Bsdf<kAllFeatures> bsdf = testBsdf(material, wo, surface);
            EXPECT_EQ(evaluate(bsdf, directionAt(-random.uniform(), random.uniform())).x, 0.0f);
            const BsdfSample s = sample(bsdf, random.uniform(), random.uniform2());
            EXPECT_TRUE(!s.valid || s.wi.z > 0.0f);
            EXPECT_TRUE(isSane(s.weight));
        }
    }
}

/// A kernel for diffuse scenes computes what the full kernel computes.
TEST(BsdfMasks, DiffuseKernelAgreesWithTheFullOne) {
    constexpr FeatureMask kMask = kFeatureDiffuse | kFeatureMeshNormals;
    static_assert(isDiffuseOnly<kMask>() && !usesLobeChoice<kMask>());
    const MaterialData material = diffuseMaterial(Vec3(0.3f, 0.6f, 0.9f));
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        TestSurface surface;
        surface.ns = directionAt(0.3f + 0.7f * random.uniform(), kTwoPi * random.uniform());
        const Vec3 wo = sampleSphere(random.uniform2());
        const auto full = testBsdf(material, wo, surface);
        const auto lean = makeBsdf<kMask>(MaterialScene(material), surface, wo);
        const Vec3 wi = sampleSphere(random.uniform2());
        EXPECT_NEAR(evaluate(full, wi).x, evaluate(lean, wi).x, 2e-6f);
        EXPECT_NEAR(pdfSolidAngle(full, wi), pdfSolidAngle(lean, wi), 2e-6f);
        const Vec2 u = random.uniform2();
        const BsdfSample a = sample(full, 0.5f, u);
        const BsdfSample b = sample(lean, 0.5f, u);
        ASSERT_EQ(a.valid, b.valid);
        if (a.valid) {
            EXPECT_NEAR(a.weight.x, b.weight.x, 1e-5f);
            EXPECT_LT(glm::length(a.wi - b.wi), 1e-5f);
        }
    }
}

TEST(BsdfMasks, SpecularOnlyMaterialsSaySo) {
    const Vec3 wo = directionAt(0.5f);
    EXPECT_TRUE(isSpecularOnly(testBsdf(mirrorMaterial(Vec3(1.0f)), wo)));
    EXPECT_TRUE(isSpecularOnly(testBsdf(dielectricMaterial(1.5f, 0.0f), wo)));
    EXPECT_TRUE(isSpecularOnly(testBsdf(dielectricMaterial(1.5f, 0.3f, true), wo)));
    EXPECT_FALSE(isSpecularOnly(testBsdf(dielectricMaterial(1.5f, 0.3f), wo)));
    EXPECT_TRUE(isSpecularOnly(testBsdf(mixtureMaterial(Vec3(1.0f), Vec3(0, 0.5f, 0.5f), 1.5f), wo)));
    EXPECT_FALSE(isSpecularOnly(testBsdf(mixtureMaterial(Vec3(1.0f), Vec3(0.1f, 0.4f, 0.5f), 1.5f), wo)));
    EXPECT_FALSE(isSpecularOnly(testBsdf(plasticMaterial(Vec3(1.0f), 1.5f, 0.0f), wo)));
    EXPECT_FALSE(isSpecularOnly(testBsdf(principledMaterial(Vec3(1.0f), 0.0f, 0.9f), wo)));
    EXPECT_TRUE(isSpecularOnly(testBsdf(principledMaterial(Vec3(1.0f), 0.0f, 1.0f, 1.0f), wo)));
    EXPECT_FALSE(isSpecularOnly(testBsdf(principledMaterial(Vec3(1.0f), 0.0f, 1.0f, 1.0f, 0.1f), wo)));
}

}  // namespace
}  // namespace glint::test
