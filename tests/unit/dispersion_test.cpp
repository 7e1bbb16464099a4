// Indices of refraction by wavelength against the manufacturers' catalogues, and the spectrum's strata.
#include "engine/math/dispersion.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "engine/builders/material_table.h"
#include "engine/builders/spectrum_table.h"
#include "engine/io/scene_loader.h"
#include "engine/kernels/spectrum.h"
#include "engine/scene/glasses.h"
#include "tests/support/render_scene.h"
#include "tests/support/temp_folder.h"
#include "tests/support/test_scenes.h"

namespace glint::test {
namespace {

/// nd and Abbe number as Schott's catalogue prints them, and as tables of minerals give them.
struct Catalogued {
    const char* name;
    float nd, abbe, abbeTolerance;
};

TEST(Dispersion, NamedGlassesHaveTheIndicesOfTheirCatalogues) {
    for (const Catalogued& entry : {Catalogued{"BK7", 1.51680f, 64.17f, 0.01f},
                                    {"SF11", 1.78472f, 25.68f, 0.01f},
                                    {"SF10", 1.72828f, 28.53f, 0.01f},
                                    {"SF5", 1.67271f, 32.25f, 0.01f},
                                    {"F2", 1.62004f, 36.37f, 0.01f},
                                    {"BAK4", 1.56883f, 55.98f, 0.01f},
                                    {"SK16", 1.62041f, 60.32f, 0.01f},
                                    {"LASF9", 1.85025f, 32.17f, 0.01f},
                                    {"fused silica", 1.45846f, 67.82f, 0.02f},
                                    {"sapphire", 1.7682f, 72.2f, 0.3f},
                                    {"diamond", 2.4175f, 55.3f, 0.1f},
                                    {"water", 1.3334f, 55.8f, 0.3f}}) {
        const auto glass = findGlass(entry.name);
        ASSERT_TRUE(glass) << entry.name;
        EXPECT_NEAR(glass->ior, entry.nd, 7e-5f) << entry.name;
        EXPECT_NEAR(abbeNumber(glass->dispersion, glass->ior), entry.abbe, entry.abbeTolerance) << entry.name;
    }
    EXPECT_FALSE(findGlass("butter"));
    for (const std::string_view name : glassNames()) {
        const auto glass = findGlass(name);
        ASSERT_TRUE(glass) << name;
        EXPECT_GT(indexShift(glass->dispersion, 400.0f), 0.0f) << name;
        EXPECT_LT(indexShift(glass->dispersion, 700.0f), 0.0f) << name;
        EXPECT_NEAR(indexShift(glass->dispersion, kLineDNm), 0.0f, 1e-6f) << name;
    }
}

TEST(Dispersion, AnAbbeNumberComesBack) {
    for (const float abbe : {10.0f, 25.7f, 64.2f, 500.0f}) {
        EXPECT_NEAR(abbeNumber(dispersionOfAbbeNumber(1.6f, abbe), 1.6f), abbe, 2e-4f * abbe);
    }
}

TEST(Spectrum, StrataAreWhiteTogetherAndFollowEachOther) {
    for (const auto& strata : {tabulateSpectrum(), tabulateThreeChannels()}) {
        glm::dvec3 sum(0.0);
        for (const SpectrumStratum& stratum : strata) {
            sum += glm::dvec3(stratum.weight);
            EXPECT_GE(minComponent(stratum.weight), 0.0f);
            EXPECT_LE(maxComponent(stratum.weight), 3.0f + 1e-4f);
        }
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(sum[c] / static_cast<double>(strata.size()), 1.0, 1e-6);
        }
    }
    const auto strata = tabulateSpectrum();
    EXPECT_EQ(strata.front().beginNm, 380.0f);
    EXPECT_EQ(strata.back().endNm, 780.0f);
    for (size_t i = 1; i < strata.size(); ++i) {
        EXPECT_EQ(strata[i].beginNm, strata[i - 1].endNm);
        EXPECT_LT(strata[i].beginNm, strata[i].endNm);
    }
    const auto brightest = [&](int channel) {
        const auto most =
            std::ranges::max_element(strata, {}, [&](const SpectrumStratum& s) { return s.weight[channel]; });
        return most->beginNm;
    };
    EXPECT_GT(brightest(0), 600.0f);
    EXPECT_GT(brightest(1), 510.0f);
    EXPECT_LT(brightest(1), 560.0f);
    EXPECT_LT(brightest(2), 475.0f);
}

TEST(Spectrum, WavelengthsFollowTheNumberDrawn) {
    const auto strata = tabulateSpectrum();
    float before = 0.0f;
    uint32_t band = 1;
    for (int i = 0; i < 4096; ++i) {
        const Wavelength drawn = wavelengthAt(viewOf(strata), static_cast<float>(i) / 4096.0f);
        EXPECT_GT(drawn.nm, before);
        EXPECT_TRUE(drawn.band == band || drawn.band == band + 1);
        before = drawn.nm;
        band = drawn.band;
    }
    EXPECT_EQ(band, kMostWavelengthBands);
    EXPECT_LE(wavelengthAt(viewOf(strata), 0x1.fffffep-1f).nm, 780.0f);
}

TEST(Spectrum, WavelengthsOfCameraAndPhotonOverlapInTheirBandOnly) {
    const auto strata = tabulateSpectrum();
    const uint32_t bands = spectrumBands(static_cast<uint32_t>(strata.size()));
    glm::dvec3 sum(0.0);
    constexpr int kSteps = 1500;
    for (int i = 0; i < kSteps; ++i) {
        const Wavelength point = wavelengthAt(viewOf(strata), (static_cast<float>(i) + 0.5f) / kSteps);
        EXPECT_EQ(spectralOverlap(point, 0, bands), Vec3(1.0f));
        EXPECT_EQ(spectralOverlap({}, point.band, bands), Vec3(1.0f));
        for (uint32_t band = 1; band <= bands; ++band) {
            const Vec3 overlap = spectralOverlap(point, band, bands);
            if (band != point.band) { EXPECT_EQ(overlap, Vec3(0.0f)); }
            // A photon of the point's own wavelength: one weight is left of the two.
            sum += glm::dvec3(overlap * point.weight * point.weight) / static_cast<double>(bands);
        }
    }
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(sum[c] / kSteps, 1.0, 5e-3);
    }
}

/// The scene of one glass ball.
SceneDescription ballOf(const Material& glass) {
    SceneDescription scene = emptyScene({0, 0, 4}, {0, 0, 0}, 30.0f, 8);
    addObject(&scene, ShapeKind::Sphere, {}, glass);
    return scene;
}

Material glassMaterial() {
    Material glass;
    glass.kind = MaterialKind::Dielectric;
    glass.color.value = Vec3(1.0f);
    return glass;
}

TEST(DispersiveMaterial, ThreeIndicesAreMetAtThreeWavelengths) {
    Material glass = glassMaterial();
    glass.iorRgb = {2.408f, 2.424f, 2.449f};
    const auto built = buildAll(ballOf(glass));
    const SceneView view = built->view();
    ASSERT_EQ(view.spectrum.count, 3u);
    const MaterialData& data = view.materials[view.geometry.instances[0].material];
    for (uint32_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(data.inputs.ior + indexShift(data.dispersion, view.spectrum[c].beginNm), glass.iorRgb[c],
                    2e-6f);
    }
}

TEST(DispersiveMaterial, CostsNothingWhereNothingDisperses) {
    const auto disperses = [](const Material& material) {
        const auto built = buildAll(ballOf(material));
        EXPECT_EQ((built->features & kFeatureDispersion) != 0, !built->view().spectrum.empty());
        return (built->features & kFeatureDispersion) != 0;
    };
    Material glass = glassMaterial();
    EXPECT_FALSE(disperses(glass));
    glass.abbeNumber = 40.0f;
    EXPECT_TRUE(disperses(glass));
    glass.thin = true;
    EXPECT_FALSE(disperses(glass)) << "a sheet bends nothing";
    glass.thin = false;
    glass.abbeNumber = 0.0f;
    glass.glass = "water";
    EXPECT_TRUE(disperses(glass));
    glass.kind = MaterialKind::Plastic;
    EXPECT_FALSE(disperses(glass));
    SceneDescription unused = ballOf(diffuseMaterial(0.5f));
    glass.kind = MaterialKind::Dielectric;
    addMaterial(&unused, glass);
    EXPECT_TRUE(buildAll(unused)->view().spectrum.empty());
}

TEST(DispersiveMaterial, FilesSayEachThingOnce) {
    TempFolder folder;
    const auto load = [&](const std::string& keys) {
        return loadScene(folder.write(
            "a.json",
            R"({ "glint": 1, "materials": { "m": { "type": "dielectric", )" + keys + R"( } }, "objects": [
            { "type": "sphere", "material": "m", "center": [0, 0, 0], "radius": 1 }] })"));
    };
    const auto glass = load(R"("glass": "SF11")");
    ASSERT_TRUE(glass) << glass.error().message;
    EXPECT_EQ(glass->materials[0].glass, "SF11");
    EXPECT_TRUE(load(R"("ior": 1.6, "abbeNumber": 30)"));
    EXPECT_TRUE(load(R"("iorRgb": [2.4, 2.42, 2.45])"));
    for (const char* refused : {R"("glass": "SF11", "ior": 1.5)", R"("glass": "BK7", "iorRgb": [1, 1, 1])",
                                R"("iorRgb": [2.4, 2.42, 2.45], "abbeNumber": 30)", R"("glass": "BK8")",
                                R"("abbeNumber": -1)", R"("ior": 1.6, "abbeNumber": "low")"}) {
        EXPECT_FALSE(load(refused)) << refused;
    }
    EXPECT_NE(load(R"("glass": "BK8")").error().message.find("BK7"), std::string::npos);
}

}  // namespace
}  // namespace glint::test
