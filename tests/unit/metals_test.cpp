// Metals against the reflectances at normal incidence that the literature gives for linear Rec.709
// (Akenine-Moller, Haines and Hoffman 2018, Real-Time Rendering, table 9.2), and Fresnel's equations against
// known values.
#include "engine/scene/metals.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "engine/kernels/bsdf/fresnel.h"

namespace glint {
namespace {

Vec3 atNormal(const char* name) {
    const std::optional<MetalConstants> metal = findMetal(name);
    return metal ? fresnelConductor(1.0f, metal->eta, metal->k) : Vec3(-1.0f);
}

void expectNear(const char* name, const Vec3& published, float tolerance) {
    const Vec3 f0 = atNormal(name);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(f0[c], std::min(published[c], 1.0f), tolerance) << name << " channel " << c;
    }
}

TEST(Metals, ReflectanceAtNormalIncidence) {
    // Measurements of one metal by several authors differ by 0.02 to 0.07, depending on how it was polished.
    expectNear("gold", Vec3(1.022f, 0.782f, 0.344f), 0.05f);
    expectNear("copper", Vec3(0.955f, 0.638f, 0.538f), 0.05f);
    expectNear("silver", Vec3(0.972f, 0.960f, 0.915f), 0.07f);
    expectNear("aluminium", Vec3(0.913f, 0.922f, 0.924f), 0.02f);
    expectNear("platinum", Vec3(0.673f, 0.637f, 0.585f), 0.02f);
    expectNear("palladium", Vec3(0.733f, 0.697f, 0.652f), 0.02f);
    expectNear("brass", Vec3(0.910f, 0.778f, 0.423f), 0.04f);
    expectNear("chromium", Vec3(0.550f, 0.556f, 0.554f), 0.02f);
    expectNear("iron", Vec3(0.562f, 0.565f, 0.578f), 0.09f);
    expectNear("nickel", Vec3(0.660f, 0.609f, 0.526f), 0.05f);
    expectNear("cobalt", Vec3(0.662f, 0.655f, 0.634f), 0.03f);
    expectNear("titanium", Vec3(0.542f, 0.497f, 0.449f), 0.10f);
    expectNear("tungsten", Vec3(0.504f, 0.498f, 0.478f), 0.03f);
}

TEST(Metals, HaveTheirColours) {
    EXPECT_GT(atNormal("gold").x, atNormal("gold").y);
    EXPECT_GT(atNormal("gold").y, 1.5f * atNormal("gold").z) << "yellow";
    EXPECT_GT(atNormal("copper").x, 1.3f * atNormal("copper").y) << "reddish";
    EXPECT_GT(atNormal("silver").z, 0.9f);
}

TEST(Metals, NamesAreSortedAndKnown) {
    const std::vector<std::string_view> names = metalNames();
    EXPECT_GE(names.size(), 12u);
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
    for (const std::string_view name : names) {
        const std::optional<MetalConstants> metal = findMetal(name);
        ASSERT_TRUE(metal);
        EXPECT_GT(minComponent(metal->eta), 0.0f);
        EXPECT_GT(minComponent(metal->k), 0.0f);
    }
    EXPECT_EQ(listedMetals().size() + 1, names.size()) << "aluminium has two spellings";
    EXPECT_FALSE(findMetal("unobtainium"));
    EXPECT_EQ(findMetal("aluminum")->eta, findMetal("aluminium")->eta);
}

TEST(Fresnel, DielectricKnownValues) {
    float cosT = 0.0f;
    EXPECT_NEAR(fresnelDielectric(1.0f, 1.5f, &cosT), 0.04f, 1e-6f);
    EXPECT_NEAR(fresnelDielectric(1.0f, 1.0f / 1.5f, &cosT), 0.04f, 1e-6f);
    EXPECT_EQ(fresnelDielectric(0.0f, 1.5f, &cosT), 1.0f);
    EXPECT_EQ(fresnelDielectric(0.5f, 1.0f, &cosT), 0.0f);
    EXPECT_EQ(cosT, 0.5f);
    EXPECT_EQ(fresnelDielectric(0.5f, 0.5f, &cosT), 1.0f) << "total internal reflection";
    // Brewster's angle: only the perpendicular part reflects, ((n^2 - 1) / (n^2 + 1))^2.
    const float brewster = 1.0f / std::sqrt(1.0f + 2.25f);
    EXPECT_NEAR(fresnelDielectric(brewster, 1.5f, &cosT), 0.5f * square(1.25f / 3.25f), 1e-6f);
}

TEST(Fresnel, ConductorWithoutAbsorptionIsADielectric) {
    float cosT = 0.0f;
    for (float cosine = 0.0f; cosine <= 1.0f; cosine += 0.05f) {
        EXPECT_NEAR(fresnelConductor(cosine, 1.7f, 0.0f), fresnelDielectric(cosine, 1.7f, &cosT), 2e-6f)
            << cosine;
    }
}

TEST(Fresnel, ConductorAtNormalIncidence) {
    // ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2)
    EXPECT_NEAR(fresnelConductor(1.0f, 0.2f, 3.9f), (0.64f + 15.21f) / (1.44f + 15.21f), 1e-6f);
    EXPECT_NEAR(fresnelConductor(0.0f, 0.2f, 3.9f), 1.0f, 1e-6f);
}

}  // namespace
}  // namespace glint
