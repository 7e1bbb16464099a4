// Roughness of two directions and Beckmann's facets in the files of every format, and what is written
// of them.
#include <gmock/gmock.h>

#include "engine/io/exporter.h"
#include "engine/io/json_writer.h"
#include "engine/io/scene_json.h"
#include "engine/scene/scene_hash.h"
#include "tests/support/gltf_test.h"
#include "tests/support/mitsuba_test.h"
#include "tests/support/pbrt_test.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// Burley 2012: alphas of a roughness r are r^2 / aspect and r^2 aspect, aspect sqrt(1 - 0.9 anisotropic).
void expectBurley(const Material& material, float roughness, float anisotropic) {
    const float aspect = std::sqrt(1.0f - 0.9f * anisotropic);
    EXPECT_NEAR(material.roughness.value, roughness * roughness / aspect, 1e-6f);
    EXPECT_NEAR(material.crossRoughness.value, roughness * roughness * aspect, 1e-6f);
}

Material brushed(MaterialKind kind, float along, float across, float turnDeg = 0.0f) {
    Material material;
    material.kind = kind;
    material.color.value = Vec3(1.0f);
    material.roughness.value = along;
    material.crossRoughness.value = across;
    material.anisotropyRotationDeg = turnDeg;
    return material;
}

/// A rectangle of the material, as it is read from what an exporter wrote.
class AnisotropyExport : public testing::Test {
  protected:
    Material exported(const Material& material, const std::string& name) {
        SceneDescription scene;
        scene.materials.push_back(material);
        scene.objects.emplace_back();
        scene.objects.back().shape = ShapeKind::Rectangle;
        scene.objects.back().material = 0;
        scene.environment.color = Vec3(0.0f);
        if (!name.ends_with("glb")) { scene.options.filter = FilterKind::Gaussian; }  // as there
        const std::string path = folder.path(name);
        warnings.clear();
        const Status saved = exporterOf(path)->save(scene, path, &warnings);
        EXPECT_TRUE(saved) << saved.error().format();
        const auto opened = loadScene(path, {.noStudio = true});
        EXPECT_TRUE(opened) << opened.error().format();
        return opened && !opened->objects.empty()
                   ? opened->materials[static_cast<size_t>(opened->objects[0].material)]
                   : Material();
    }
    TempFolder folder;
    std::vector<std::string> warnings;
};

class AnisotropyMitsuba : public MitsubaTest {};

TEST_F(AnisotropyMitsuba, AlphasAndDistributionsAreTaken) {
    const Material metal = materialOf(
        "<bsdf type='roughconductor'><string name='distribution' value='ggx'/><float name='alphaU' "
        "value='0.05'/><float name='alphaV' value='0.3'/></bsdf>");
    EXPECT_EQ(metal.distribution, FacetDistribution::Ggx);
    EXPECT_FLOAT_EQ(metal.roughness.value, 0.05f);
    EXPECT_FLOAT_EQ(metal.crossRoughness.value, 0.3f);
    EXPECT_THAT(warnings, IsEmpty());
    const Material even = materialOf(
        "<bsdf type='roughdielectric'><float name='alpha_u' value='0.2'/><float name='alpha_v' "
        "value='0.2'/></bsdf>");
    EXPECT_EQ(even.distribution, FacetDistribution::Beckmann);
    EXPECT_FALSE(hasCrossRoughness(even));
    materialOf("<bsdf type='roughdielectric'><string name='distribution' value='as'/></bsdf>");
    EXPECT_THAT(warnings, Contains(HasSubstr("Phong's distribution")));
    expectBurley(materialOf("<bsdf type='principled'><float name='roughness' value='0.5'/><float "
                            "name='anisotropic' value='0.8'/></bsdf>"),
                 0.5f, 0.8f);
    EXPECT_FALSE(hasCrossRoughness(materialOf("<bsdf type='principled'/>")));
    const Material ward = materialOf(
        "<bsdf type='ward'><float name='alpha_u' value='0.1'/><float name='alpha_v' value='0.4'/></bsdf>");
    EXPECT_EQ(ward.kind, MaterialKind::Ward);
    EXPECT_FLOAT_EQ(ward.crossRoughness.value, 0.4f);
}

TEST_F(AnisotropyExport, MitsubaKeepsBoth) {
    for (const MaterialKind kind : {MaterialKind::Conductor, MaterialKind::Dielectric}) {
        Material material = brushed(kind, 0.125f, 0.5f);
        material.distribution = FacetDistribution::Beckmann;
        const Material opened = exported(material, "out.xml");
        EXPECT_THAT(warnings, IsEmpty());
        EXPECT_EQ(opened.distribution, FacetDistribution::Beckmann);
        EXPECT_EQ(opened.roughness, material.roughness);
        EXPECT_EQ(opened.crossRoughness, material.crossRoughness);
    }
    const Material turned = exported(brushed(MaterialKind::Conductor, 0.125f, 0.5f, 90.0f), "out.xml");
    EXPECT_THAT(warnings, IsEmpty());
    EXPECT_EQ(turned.roughness.value, 0.5f);
    EXPECT_EQ(turned.crossRoughness.value, 0.125f);
    exported(brushed(MaterialKind::Conductor, 0.125f, 0.5f, 30.0f), "out.xml");
    EXPECT_THAT(warnings, Contains(HasSubstr("along u and v")));
    const Material paint = exported(brushed(MaterialKind::Principled, 0.4f, 0.1f), "out.xml");
    EXPECT_NEAR(paint.roughness.value, 0.4f, 1e-5f);
    EXPECT_NEAR(paint.crossRoughness.value, 0.1f, 1e-5f);
}

class AnisotropyPbrt : public PbrtTest {};

TEST_F(AnisotropyPbrt, RoughnessesAlongUAndVAreTaken) {
    const Material glass =
        materialOf(R"(Material "dielectric" "float uroughness" 0.09 "float vroughness" 0.25)");
    EXPECT_THAT(warnings, IsEmpty());
    EXPECT_NEAR(glass.roughness.value, 0.3f, 1e-6f);
    EXPECT_NEAR(glass.crossRoughness.value, 0.5f, 1e-6f);
    const Material half =
        materialOf(R"(Material "coateddiffuse" "float roughness" 0.25 "float vroughness" 0.04)");
    EXPECT_NEAR(half.roughness.value, 0.5f, 1e-6f);
    EXPECT_NEAR(half.crossRoughness.value, 0.2f, 1e-6f);
    EXPECT_FALSE(hasCrossRoughness(
        materialOf(R"(Material "conductor" "float uroughness" 0.1 "float vroughness" 0.1)")));
    expectBurley(materialOf(R"(Material "disney" "float roughness" 0.6 "float anisotropic" 0.5)"), 0.6f,
                 0.5f);
}

TEST_F(AnisotropyExport, PbrtKeepsGgx) {
    const Material opened = exported(brushed(MaterialKind::Conductor, 0.125f, 0.5f), "out.pbrt");
    EXPECT_THAT(warnings, IsEmpty());
    EXPECT_EQ(opened.roughness.value, 0.125f);
    EXPECT_EQ(opened.crossRoughness.value, 0.5f);
    Material material = brushed(MaterialKind::Conductor, 0.25f, 0.25f);
    material.distribution = FacetDistribution::Beckmann;
    exported(material, "out.pbrt");
    EXPECT_THAT(warnings, Contains(HasSubstr("Beckmann's facets are GGX")));
}

class AnisotropyGltf : public GltfTest {};

/// KHR_materials_anisotropy: alpha_t = mix(alpha, 1, strength^2), alpha_b = alpha.
TEST_F(AnisotropyGltf, StrengthAndRotationAreTaken) {
    const Material metal = only(
        R"("pbrMetallicRoughness": {"metallicFactor": 1, "roughnessFactor": 0.5}, "extensions":
           {"KHR_materials_anisotropy": {"anisotropyStrength": 0.6, "anisotropyRotation": 0.5}})");
    EXPECT_NEAR(metal.roughness.value, 0.25f + 0.36f * 0.75f, 1e-6f);
    EXPECT_NEAR(metal.crossRoughness.value, 0.25f, 1e-6f);
    // v counts downwards in these files.
    EXPECT_NEAR(metal.anisotropyRotationDeg, -0.5f * 180.0f / kPi, 1e-4f);
    EXPECT_FALSE(hasCrossRoughness(only(R"("pbrMetallicRoughness": {"roughnessFactor": 0.5})")));
}

TEST_F(AnisotropyExport, GltfKeepsAlphasAndDirection) {
    for (const auto& [along, across, turnDeg] :
         {std::tuple(0.5f, 0.125f, 30.0f), std::tuple(0.125f, 0.5f, -20.0f),
          std::tuple(0.25f, 1.0f, 90.0f)}) {
        Material paint = brushed(MaterialKind::Principled, along, across, turnDeg);
        const Material opened = exported(paint, "out.glb");
        EXPECT_THAT(warnings, IsEmpty());
        EXPECT_NEAR(opened.roughness.value, std::max(along, across), 1e-5f);
        EXPECT_NEAR(opened.crossRoughness.value, std::min(along, across), 1e-5f);
        const float wanted = turnDeg + (across > along ? 90.0f : 0.0f);
        // Texture coordinates are upside down in the file.
        EXPECT_NEAR(std::remainder(opened.anisotropyRotationDeg + wanted, 180.0f), 0.0f, 1e-3f);
    }
}

TEST(AnisotropyMtl, AnisoAndAnisorAreBurleys) {
    const TempFolder folder;
    folder.write("m.mtl", "newmtl it\nKd 0.8 0.1 0.1\nPr 0.6\nPm 1\naniso 0.5\nanisor 0.125\n");
    const auto scene =
        loadScene(folder.write("in.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl it\nf 1 2 3\n"));
    ASSERT_TRUE(scene) << scene.error().format();
    const Material& metal = scene->materials.at(static_cast<size_t>(scene->objects.at(0).material));
    EXPECT_EQ(metal.kind, MaterialKind::Conductor);
    expectBurley(metal, 0.6f, 0.5f);
    EXPECT_FLOAT_EQ(metal.anisotropyRotationDeg, 45.0f);
    EXPECT_THAT(scene->warnings, IsEmpty());
}

std::string jsonOf(const std::string& rough) {
    return R"({"glint": 1, "materials": {"it": {"type": "conductor", "roughness": 0.1)" + rough +
           R"(}}, "objects": [{"type": "sphere", "material": "it"}], "environment": {"color": 1}})";
}

TEST(AnisotropyJson, IsReadWrittenAndFingerprinted) {
    const TempFolder folder;
    const auto open = [&](const std::string& rough) {
        auto scene = loadScene(folder.write("a.json", jsonOf(rough)));
        EXPECT_TRUE(scene) << scene.error().format();
        return *scene;
    };
    const SceneDescription plain = open("");
    EXPECT_FALSE(hasCrossRoughness(plain.materials[0]));
    const SceneDescription all =
        open(R"(, "crossRoughness": 0.4, "anisotropyRotationDeg": 30, "distribution": "beckmann")");
    EXPECT_EQ(all.materials[0].crossRoughness, NumberInput{0.4f});
    EXPECT_EQ(all.materials[0].distribution, FacetDistribution::Beckmann);
    const Status saved = saveSceneJson(all, folder.path("b.json"));
    ASSERT_TRUE(saved) << saved.error().format();
    const auto again = loadScene(folder.path("b.json"));
    ASSERT_TRUE(again) << again.error().format();
    EXPECT_EQ(sceneHash(*again), sceneHash(all));
    for (const char* one : {R"(, "crossRoughness": 0.4)", R"(, "distribution": "beckmann")",
                            R"(, "crossRoughness": 0.4, "anisotropyRotationDeg": 30)"}) {
        EXPECT_NE(sceneHash(open(one)), sceneHash(plain)) << one;
    }
    EXPECT_FALSE(loadScene(folder.write("c.json", jsonOf(R"(, "crossRoughness": -0.5)"))));
    EXPECT_FALSE(loadScene(folder.write("d.json", jsonOf(R"(, "distribution": "phong")"))));
}

}  // namespace
}  // namespace glint::test
