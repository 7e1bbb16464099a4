// Mitsuba's spectra, textures and bsdfs as Glint's colours, textures and materials.
#include <cmath>
#include <functional>

#include "engine/io/image_io.h"
#include "engine/io/mitsuba_spectrum.h"
#include "tests/support/mitsuba_test.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

class MitsubaMaterialsTest : public MitsubaTest {
  protected:
    Vec3 radiance(const std::string& element) {
        return load("<emitter type='constant'>" + element + "</emitter>").environment.color;
    }
    Vec3 reflectance(const std::string& element) {
        return materialOf("<bsdf type='diffuse'>" + element + "</bsdf>").color.value;
    }
};

/// x and y of linear Rec.709.
Vec2 chromaticity(const Vec3& rgb) {
    const float x = 0.4124564f * rgb.x + 0.3575761f * rgb.y + 0.1804375f * rgb.z;
    const float y = 0.2126729f * rgb.x + 0.7151522f * rgb.y + 0.0721750f * rgb.z;
    const float z = 0.0193339f * rgb.x + 0.1191920f * rgb.y + 0.9503041f * rgb.z;
    return Vec2(x, y) / (x + y + z);
}

TEST(MitsubaSpectrum, KnownLightsHaveTheirColours) {
    const SpectrumSample flat[] = {{300.0, 0.5}, {900.0, 0.5}};
    const Vec3 grey = rgbOfSpectrum(flat, SpectrumRole::Reflectance);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(grey[c], 0.5f, 5e-4f);
    }
    const Vec2 equal = chromaticity(rgbOfSpectrum(flat, SpectrumRole::Emission));
    EXPECT_NEAR(equal.x, 1.0f / 3.0f, 2e-4f);
    EXPECT_NEAR(equal.y, 1.0f / 3.0f, 2e-4f);
    // CIE illuminant A.
    const Vec2 tungsten = chromaticity(rgbOfBlackbody(2855.5));
    EXPECT_NEAR(tungsten.x, 0.44757f, 3e-4f);
    EXPECT_NEAR(tungsten.y, 0.40745f, 3e-4f);
    // At 6500 K about 95 lm/W (Murphy 2012, "Maximum spectral luminous efficacy of white light").
    const Vec3 hot = rgbOfBlackbody(6500.0);
    const double luminance = 0.2126729 * static_cast<double>(hot.x) + 0.7151522 * static_cast<double>(hot.y) +
                             0.0721750 * static_cast<double>(hot.z);
    const double radiance = 5.670374e-8 * std::pow(6500.0, 4.0) / 3.14159265;
    EXPECT_NEAR(luminance * 106.857 * 683.002 / radiance, 95.0, 0.6);
    // What lies between two samples, and nothing beyond them.
    const SpectrumSample green[] = {{500.0, 0.0}, {550.0, 1.0}, {600.0, 0.0}};
    const Vec3 color = rgbOfSpectrum(green, SpectrumRole::Emission);
    EXPECT_GT(color.y, 3.0f * std::fabs(color.x));
}

/// Of Palik's measurements of amorphous carbon.
TEST(MitsubaSpectrum, NamedMetalsAreTheirSpectra) {
    const SpectrumSample eta[] = {{364.647, 2.0},  {387.438, 2.06}, {413.267, 2.11}, {442.786, 2.17},
                                  {476.846, 2.24}, {516.583, 2.30}, {563.545, 2.38}, {619.9, 2.43},
                                  {688.778, 2.43}, {774.875, 2.33}, {885.571, 2.24}};
    const Vec3 expected = rgbOfSpectrum(eta, SpectrumRole::Index), stored = mitsubaMetal("a-C")->eta;
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(stored[c], expected[c], 0.01f) << c;
    }
    EXPECT_FALSE(mitsubaMetal("unobtainium"));
    EXPECT_EQ(mitsubaMetal("W_palik")->eta, mitsubaMetal("W")->eta);
    EXPECT_NE(mitsubaMetal("Cu_palik")->eta, mitsubaMetal("Cu")->eta) << "two measurements";
    // Stephens and Malitson 1952; DeVore 1951, the extraordinary ray; wavelengths in micrometres, squared.
    const auto periclase = [](double w) { return 2.956362 + 0.0219577 / (w - 0.01428322) - 0.01062387 * w; };
    const auto rutile = [](double w) { return 7.197 + 0.3322 / (w - 0.0843); };
    const std::pair<const char*, std::function<double(double)>> kFormulas[] = {{"MgO", periclase},
                                                                               {"TiO2", rutile}};
    for (const auto& [name, squared] : kFormulas) {
        std::vector<SpectrumSample> index;
        for (double nm = 360.0; nm <= 830.0; nm += 5.0) {
            index.push_back({nm, std::sqrt(squared(nm * nm * 1e-6))});
        }
        const Vec3 computed = rgbOfSpectrum(index, SpectrumRole::Index);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(mitsubaMetal(name)->eta[c], computed[c], 0.01f * computed[c]) << name << " " << c;
        }
    }
    EXPECT_FLOAT_EQ(*mitsubaIndex("BK7"), 1.5046f);
    EXPECT_FALSE(mitsubaIndex("unobtainium"));
}

TEST_F(MitsubaMaterialsTest, ColoursAreLinear) {
    EXPECT_EQ(radiance("<rgb name='radiance' value='1, 2 3'/>"), Vec3(1, 2, 3));
    EXPECT_EQ(radiance("<rgb name='radiance' value='4'/>"), Vec3(4.0f));
    EXPECT_EQ(radiance("<spectrum name='radiance' value='4'/>"), Vec3(4.0f));
    EXPECT_EQ(radiance("<float name='radiance' value='4'/>"), Vec3(4.0f));
    EXPECT_EQ(radiance(""), Vec3(1.0f));
    expectNear(radiance("<srgb name='radiance' value='0.5 1 0'/>"), Vec3(0.21404f, 1, 0), 1e-4f);
    expectNear(reflectance("<rgb name='reflectance' value='#8000ff'/>"), Vec3(0.21586f, 0, 1), 1e-4f);
    EXPECT_EQ(reflectance("<rgb name='reflectance' value='2 0.5 0'/>"), Vec3(1, 0.5f, 0));
    EXPECT_THAT(warnings, Contains(HasSubstr("reflectances beyond 0 to 1 are clamped")));
    expectNear(reflectance("<spectrum name='reflectance' value='350:0.3, 800:0.3'/>"), Vec3(0.3f), 1e-3f);
    folder.write("flat.spd", "# a comment 1 2\n350 0.3\n800 0.3\n");
    expectNear(reflectance("<spectrum name='reflectance' filename='flat.spd'/>"), Vec3(0.3f), 1e-3f);
    const Vec3 evenly = reflectance(R"(<spectrum name='reflectance' type='regular'>
        <float name='wavelength_min' value='400'/><float name='wavelength_max' value='700'/>
        <string name='values' value='0.1, 0.5, 0.2, 0.9'/></spectrum>)");
    expectNear(evenly,
               reflectance("<spectrum name='reflectance' value='400:0.1, 500:0.5, 600:0.2, 700:0.9'/>"),
               1e-5f);
    EXPECT_GT(maxComponent(evenly), 0.2f);
    expectNear(radiance("<blackbody name='radiance' temperature='2855.5K' scale='2'/>"),
               2.0f * rgbOfBlackbody(2855.5), 1.0f);
}

TEST_F(MitsubaMaterialsTest, DielectricsHaveTheRatioOfIndices) {
    Material glass = materialOf("<bsdf type='dielectric'/>");
    EXPECT_EQ(glass.kind, MaterialKind::Dielectric);
    EXPECT_FLOAT_EQ(glass.ior.value, 1.5046f / 1.000277f);
    EXPECT_EQ(glass.color.value, Vec3(1.0f));
    EXPECT_THAT(warnings, IsEmpty());
    glass = materialOf(
        "<bsdf type='thindielectric'><string name='int_ior' value='diamond'/><float "
        "name='ext_ior' value='2'/></bsdf>");
    EXPECT_TRUE(glass.thin);
    EXPECT_FLOAT_EQ(glass.ior.value, 2.419f / 2.0f);
    glass = materialOf(
        "<bsdf type='roughdielectric'><string name='distribution' value='ggx'/><float "
        "name='alpha' value='0.3'/></bsdf>");
    EXPECT_FLOAT_EQ(glass.roughness.value, 0.3f);
    EXPECT_THAT(warnings, IsEmpty());
    EXPECT_EQ(glass.distribution, FacetDistribution::Ggx);
    EXPECT_FALSE(hasCrossRoughness(glass));
    glass = materialOf("<bsdf type='roughdielectric'/>");
    EXPECT_EQ(glass.distribution, FacetDistribution::Beckmann);
    EXPECT_FLOAT_EQ(glass.roughness.value, 0.1f);
    EXPECT_THAT(warnings, IsEmpty());
}

TEST_F(MitsubaMaterialsTest, MediaInGlassAbsorb) {
    const auto glassWith = [this](const std::string& medium) {
        const SceneDescription scene =
            load("<shape type='sphere'><bsdf type='dielectric'/><medium name='interior' type='homogeneous'>" +
                 medium + "</medium></shape>");
        warnings = scene.warnings;
        return absorptionOf(scene.materials.at(static_cast<size_t>(scene.objects.at(0).material)));
    };
    expectNear(glassWith("<rgb name='sigma_t' value='1 20 0'/><float name='albedo' value='0'/><float "
                         "name='scale' value='3'/>"),
               Vec3(3, 60, 0), 1e-4f);
    EXPECT_THAT(warnings, IsEmpty());
    expectNear(glassWith("<rgb name='sigma_a' value='0.5 0.25 0'/>"), Vec3(0.5f, 0.25f, 0), 1e-6f);
    EXPECT_THAT(warnings, IsEmpty());
    expectNear(glassWith("<float name='sigma_t' value='2'/><float name='albedo' value='0.5'/>"), Vec3(1),
               1e-6f);
    EXPECT_THAT(warnings, Contains(HasSubstr("approximated: media absorb, but scatter nothing")));
    const SceneDescription fog = load(
        "<shape type='sphere'><bsdf type='diffuse'/><medium name='interior' type='homogeneous'/></shape>");
    EXPECT_THAT(fog.warnings, Contains(HasSubstr("media are left out")));
    const SceneDescription named = load(
        "<medium type='homogeneous' id='ink'><rgb name='sigma_t' value='1,2,3'/><float name='albedo' "
        "value='0'/></medium>"
        "<shape type='sphere'><bsdf type='dielectric'/><ref name='interior' id='ink'/></shape>");
    EXPECT_THAT(named.warnings, Not(Contains(HasSubstr("media"))));
    EXPECT_NE(named.materials.at(0).attenuationColor, Vec3(1.0f));
}

TEST_F(MitsubaMaterialsTest, DiffuseTransmittersAreTranslucent) {
    const Material sheet =
        materialOf("<bsdf type='difftrans'><rgb name='transmittance' value='0.1 0.5 0.9'/></bsdf>");
    EXPECT_EQ(sheet.kind, MaterialKind::Translucent);
    EXPECT_EQ(sheet.color.value, Vec3(0.0f));
    EXPECT_EQ(sheet.transmission.value, Vec3(0.1f, 0.5f, 0.9f));
    EXPECT_THAT(warnings, IsEmpty());
    const Material leaf = materialOf(
        "<bsdf type='principledthin'><rgb name='base_color' value='0.2 0.8 0.4'/><float name='diff_trans' "
        "value='1.5'/></bsdf>");
    EXPECT_EQ(leaf.kind, MaterialKind::Translucent);
    expectNear(leaf.color.value, Vec3(0.05f, 0.2f, 0.1f), 1e-6f);
    expectNear(leaf.transmission.value, Vec3(0.15f, 0.6f, 0.3f), 1e-6f);
}

TEST_F(MitsubaMaterialsTest, ConductorsHaveNamesSpectraOrNothing) {
    Material metal = materialOf("<bsdf type='conductor'><string name='material' value='Au'/></bsdf>");
    EXPECT_EQ(metal.kind, MaterialKind::Conductor);
    EXPECT_TRUE(metal.metal.empty());
    EXPECT_EQ(metal.eta.value, mitsubaMetal("Au")->eta);
    metal = materialOf(
        "<bsdf type='conductor'><spectrum name='eta' value='0.8'/><spectrum name='k' "
        "value='6'/></bsdf>");
    EXPECT_EQ(metal.eta.value, Vec3(0.8f));
    EXPECT_EQ(metal.k.value, Vec3(6.0f));
    metal = materialOf(
        "<bsdf type='roughconductor'><float name='alpha_u' value='0.1'/><float name='alpha_v' "
        "value='0.4'/></bsdf>");
    EXPECT_FLOAT_EQ(metal.roughness.value, 0.1f);
    EXPECT_FLOAT_EQ(metal.crossRoughness.value, 0.4f);
    EXPECT_GT(metal.k.value.x, 1e3f);
    EXPECT_THAT(warnings, IsEmpty());
}

/// What Mitsuba's plastic reflects of diffuse light: c / (1 - c Fi) or, linear, c / (1 - Fi), times the rest.
TEST_F(MitsubaMaterialsTest, LinearPlasticIsAnotherColour) {
    const std::string color = "<rgb name='diffuse_reflectance' value='0.2 0.5 0.9'/>";
    const Material nonlinear =
        materialOf("<bsdf type='plastic'><boolean name='nonlinear' value='true'/>" + color + "</bsdf>");
    EXPECT_EQ(nonlinear.color.value, Vec3(0.2f, 0.5f, 0.9f));
    EXPECT_EQ(nonlinear.kind, MaterialKind::Plastic);
    const Material linear = materialOf("<bsdf type='plastic'>" + color + "</bsdf>");
    const float internal = 0.592f;  // of an index of 1.49 (d'Eon and Irving 2011, fit to 1e-3)
    for (int c = 0; c < 3; ++c) {
        const float base = linear.color.value[c];
        EXPECT_NEAR(base / (1.0f - base * internal), nonlinear.color.value[c] / (1.0f - internal), 0.01f)
            << c;
    }
    EXPECT_THAT(warnings, IsEmpty());
}

TEST_F(MitsubaMaterialsTest, WrappersChangeWhatTheyHold) {
    const std::string red = "<bsdf type='diffuse'><rgb name='reflectance' value='1 0 0'/></bsdf>";
    const std::string blue = "<bsdf type='diffuse'><rgb name='reflectance' value='0 0 1'/></bsdf>";
    EXPECT_EQ(materialOf("<bsdf type='twosided'>" + red + "</bsdf>").color.value, Vec3(1, 0, 0));
    const SceneDescription sides = load("<shape type='rectangle'><bsdf type='twosided'>" + red +
                                        "<bsdf type='conductor'/></bsdf></shape>");
    ASSERT_EQ(sides.objects.size(), 2u);
    const auto ofObject = [&](size_t i) {
        EXPECT_TRUE(sides.objects[i].frontOnly);
        return sides.materials.at(static_cast<size_t>(sides.objects[i].material));
    };
    EXPECT_EQ(ofObject(0).color.value, Vec3(1, 0, 0));
    EXPECT_EQ(ofObject(1).kind, MaterialKind::Mirror);
    EXPECT_EQ(sides.objects[1].objectToWorld.vector(Vec3(0, 0, 1)), Vec3(0, 0, -1));
    EXPECT_THAT(sides.warnings, Not(Contains(HasSubstr("approximated"))));
    EXPECT_FLOAT_EQ(
        materialOf("<bsdf type='mask'><float name='opacity' value='0.25'/>" + red + "</bsdf>").opacity.value,
        0.25f);
    const std::string blend = "<bsdf type='blendbsdf'><float name='weight' value='0.25'/>";
    EXPECT_EQ(materialOf(blend + red + blue + "</bsdf>").color.value, Vec3(0.75f, 0, 0.25f));
    EXPECT_THAT(warnings, IsEmpty());
    materialOf(blend + red + "<bsdf type='conductor'/></bsdf>");
    EXPECT_THAT(warnings, Contains(HasSubstr("approximated: of blended materials")));
    EXPECT_TRUE(load("<shape type='sphere'><bsdf type='null'/></shape>").objects.empty());
    EXPECT_EQ(materialOf("<bsdf type='coating'>" + red + "</bsdf>").kind, MaterialKind::Plastic);
    EXPECT_THAT(warnings, Contains(HasSubstr("approximated: coats over diffuse surfaces")));
}

TEST_F(MitsubaMaterialsTest, EachFurtherModelIsApproximatedAndSaid) {
    for (const char* type : {"principled", "principledthin"}) {
        materialOf("<bsdf type='" + std::string(type) + "'/>");
        EXPECT_THAT(warnings, Contains(HasSubstr("approximated: "))) << type;
    }
    EXPECT_EQ(materialOf("<bsdf type='principled'><float name='metallic' value='1'/></bsdf>").kind,
              MaterialKind::Principled);
    EXPECT_FLOAT_EQ(
        materialOf("<bsdf type='principled'><float name='roughness' value='0.5'/></bsdf>").roughness.value,
        0.25f);
    EXPECT_THAT(errorOf("<shape type='sphere'><bsdf type='hk'/></shape>"), HasSubstr("no bsdf \"hk\""));
    const SceneDescription scene =
        load("<shape type='sphere'><bsdf type='hk'/></shape>", {.allowMissing = true});
    EXPECT_EQ(scene.objects.size(), 1u);
    EXPECT_THAT(scene.warnings, Contains(HasSubstr("no bsdf \"hk\"")));
}

}  // namespace
}  // namespace glint::test
