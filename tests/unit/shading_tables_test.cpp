// What the builders make of a description: materials, textures, camera and feature mask, and what they share
// or refuse.
#include <limits>

#include <gtest/gtest.h>

#include "engine/builders/camera_builder.h"
#include "engine/builders/feature_scan.h"
#include "engine/builders/material_table.h"
#include "engine/render/variant_choice.h"

namespace glint {
namespace {

Texture grayTexture(const char* name, uint8_t level) {
    auto image = std::make_shared<Image8>();
    image->width = image->height = 1;
    image->rgb.assign(3, level);
    Texture texture;
    texture.name = name;
    texture.image.bytes = image;
    return texture;
}

/// One sphere for each material.
SceneDescription sceneOf(std::vector<Material> materials) {
    SceneDescription scene;
    scene.materials = std::move(materials);
    for (size_t i = 0; i < scene.materials.size(); ++i) {
        Object object;
        object.material = static_cast<int>(i);
        scene.objects.push_back(object);
    }
    return scene;
}

Material materialOf(MaterialKind kind) {
    Material material;
    material.name = "subject";
    material.kind = kind;
    return material;
}

Result<std::shared_ptr<const MaterialTable>> build(const SceneDescription& scene,
                                                   std::shared_ptr<const MaterialTable> previous = nullptr) {
    const auto textures = buildTextureTable(scene, nullptr);
    if (!textures) { return textures.error(); }
    return buildMaterialTable(scene, **textures, previous);
}

FeatureMask featuresOf(const SceneDescription& scene) { return scanFeatures(scene, **build(scene)); }

std::string errorOf(const Material& material) {
    const auto table = build(sceneOf({material}));
    return table ? "" : table.error().message;
}

TEST(MaterialTable, LooksMetalsUp) {
    Material metal = materialOf(MaterialKind::Conductor);
    metal.metal = "copper";
    const auto named = build(sceneOf({metal}));
    ASSERT_TRUE(named);
    EXPECT_GT((*named)->materials[0].inputs.eta.y, (*named)->materials[0].inputs.eta.x);
    metal.metal = "";
    metal.eta.value = Vec3(0.3f);
    EXPECT_EQ((*build(sceneOf({metal})))->materials[0].inputs.eta, Vec3(0.3f));
    metal.metal = "coper";
    EXPECT_NE(errorOf(metal).find("did you mean 'copper'"), std::string::npos) << errorOf(metal);
}

TEST(MaterialTable, RefusesWhatMeansNothing) {
    Material glass = materialOf(MaterialKind::Dielectric);
    for (const float ior : {0.0f, -1.0f, std::nanf(""), std::numeric_limits<float>::infinity()}) {
        glass.ior.value = ior;
        EXPECT_NE(errorOf(glass).find("'subject'"), std::string::npos) << ior;
    }
    Material plastic = materialOf(MaterialKind::Plastic);
    plastic.ior.value = 0.9f;
    EXPECT_NE(errorOf(plastic), "");
    plastic.kind = MaterialKind::Principled;
    EXPECT_NE(errorOf(plastic), "") << "its dielectric has a boundary, too";
    Material mixture = materialOf(MaterialKind::Mixture);
    mixture.mixtureWeights.value = Vec3(0.0f);
    EXPECT_NE(errorOf(mixture), "");
    mixture.mixtureWeights.value = Vec3(1.0f, -0.1f, 0.0f);
    EXPECT_NE(errorOf(mixture), "");
    Material diffuse = materialOf(MaterialKind::Diffuse);
    diffuse.color.value.y = std::nanf("");
    EXPECT_NE(errorOf(diffuse), "");
    diffuse.color.value.y = 1.0f;
    diffuse.color.texture = 3;
    EXPECT_NE(errorOf(diffuse).find("texture 3"), std::string::npos);
}

TEST(MaterialTable, NormalisesAndClamps) {
    Material mixture = materialOf(MaterialKind::Mixture);
    mixture.mixtureWeights.value = Vec3(2.0f, 1.0f, 1.0f);
    mixture.color.value = Vec3(1.5f, -0.5f, 0.25f);
    mixture.emission.value = Vec3(2.0f);
    mixture.emissionStrength = 3.0f;
    const MaterialData data = (*build(sceneOf({mixture})))->materials[0];
    EXPECT_EQ(data.inputs.mixtureWeights, Vec3(0.5f, 0.25f, 0.25f));
    EXPECT_EQ(data.color, Vec3(1.0f, 0.0f, 0.25f));
    EXPECT_EQ(data.emission, Vec3(6.0f));
    EXPECT_EQ(data.flags, kMaterialEmissive);
}

TEST(MaterialTable, IsSharedWhileNothingChanges) {
    Material plastic = materialOf(MaterialKind::Plastic);
    plastic.roughness.value = 0.2f;
    SceneDescription scene = sceneOf({plastic});
    const auto first = *build(scene);
    EXPECT_EQ(*build(scene, first), first);
    scene.materials[0].color.value = Vec3(0.1f);
    const auto second = *build(scene, first);
    EXPECT_NE(second, first);
    EXPECT_EQ(second->materials[0].inputs.coat.ratio[7], first->materials[0].inputs.coat.ratio[7]);
    scene.materials[0].roughness.value = 0.9f;
    EXPECT_NE((*build(scene, second))->materials[0].inputs.coat.ratio[7],
              first->materials[0].inputs.coat.ratio[7]);
}

TEST(TextureTable, HoldsOnlyWhatIsUsed) {
    SceneDescription scene = sceneOf({materialOf(MaterialKind::Diffuse), materialOf(MaterialKind::Diffuse)});
    scene.textures = {grayTexture("unused", 1), grayTexture("used", 2),
                      grayTexture("of an unused material", 3)};
    scene.materials[0].color.texture = 1;
    scene.materials[1].color.texture = 2;
    scene.objects[1].material = 0;
    const auto table = *buildTextureTable(scene, nullptr);
    ASSERT_EQ(table->textures.size(), 1u);
    EXPECT_EQ(table->textures[0].bytes, scene.textures[1].image.bytes->rgb.data()) << "pixels are not copied";
    EXPECT_EQ(table->textures[0].encoding, ColorEncoding::Srgb);
    EXPECT_EQ(table->packedIndex, (std::vector<uint32_t>{kNone, 0u, kNone}));
    EXPECT_EQ(table->bytes(), 3u);
    const auto materials = *buildMaterialTable(scene, *table, nullptr);
    EXPECT_EQ(materials->materials[0].colorTexture, 0u);
    EXPECT_EQ(materials->materials[1].colorTexture, kNone);

    EXPECT_EQ(*buildTextureTable(scene, table), table) << "shared while nothing changes";
    scene.materials[0].color.value = Vec3(0.9f);
    EXPECT_EQ(*buildTextureTable(scene, table), table);
    scene.textures[1].flipV = true;
    EXPECT_NE(*buildTextureTable(scene, table), table);
}

TEST(TextureTable, PlacesTextures) {
    SceneDescription scene = sceneOf({materialOf(MaterialKind::Diffuse)});
    scene.textures = {grayTexture("used", 2), grayTexture("unused", 1)};
    scene.materials[0].color.texture = 0;
    scene.textures[1].wrapU = WrapMode::Clamp;
    EXPECT_EQ(featuresOf(scene) & kFeaturePlacedTextures, FeatureMask{0}) << "no object has the clamped one";
    const auto plain = *buildTextureTable(scene, nullptr);
    const std::pair<const char*, void (*)(Texture*)> changes[] = {
        {"wrapU", [](Texture* t) { t->wrapU = WrapMode::Clamp; }},
        {"wrapV", [](Texture* t) { t->wrapV = WrapMode::Mirror; }},
        {"filter", [](Texture* t) { t->filter = TexelFilter::Nearest; }},
        {"offset", [](Texture* t) { t->offset.y = 0.5f; }},
        {"rotation", [](Texture* t) { t->rotationDeg = 30.0f; }}};
    for (const auto& [name, change] : changes) {
        SceneDescription placed = scene;
        change(&placed.textures[0]);
        EXPECT_NE(featuresOf(placed) & kFeaturePlacedTextures, FeatureMask{0}) << name;
        EXPECT_NE(*buildTextureTable(placed, plain), plain) << name;
    }
    scene.textures[0].rotationDeg = 30.0f;
    const auto turned = *buildTextureTable(scene, nullptr);
    EXPECT_NEAR(turned->textures[0].turn.x, std::sqrt(0.75f), 1e-6f);
    EXPECT_NEAR(turned->textures[0].turn.y, 0.5f, 1e-6f);
    scene.textures[0].offset.x = std::nanf("");
    EXPECT_FALSE(buildTextureTable(scene, nullptr));
}

TEST(TextureTable, RefusesTexturesWithoutPixels) {
    SceneDescription scene = sceneOf({materialOf(MaterialKind::Diffuse)});
    scene.materials[0].color.texture = 0;
    scene.textures = {Texture{}};
    scene.textures[0].name = "empty";
    const auto table = buildTextureTable(scene, nullptr);
    ASSERT_FALSE(table);
    EXPECT_NE(table.error().message.find("'empty'"), std::string::npos);
}

TEST(FeatureScan, NamesExactlyWhatIsNeeded) {
    SceneDescription scene = sceneOf({materialOf(MaterialKind::Diffuse)});
    EXPECT_EQ(featuresOf(scene), FeatureMask{kFeatureCurved | kFeatureDiffuse});

    Material rough = materialOf(MaterialKind::Conductor);
    rough.roughness.value = 0.3f;
    scene.materials.push_back(rough);
    EXPECT_EQ(featuresOf(scene), FeatureMask{kFeatureCurved | kFeatureDiffuse}) << "an unused material";
    scene.objects[0].material = 1;
    EXPECT_EQ(featuresOf(scene), FeatureMask{kFeatureCurved | kFeatureGlossy});
    scene.materials[1].roughness.value = 0.5f * kSmoothAlpha;
    EXPECT_EQ(featuresOf(scene), FeatureMask{kFeatureCurved | kFeatureSpecular});

    scene.camera.apertureDiameter = 0.1f;
    scene.options.sampler = SamplerKind::Independent;
    scene.objects[0].frontOnly = true;
    const FeatureMask needed = kFeatureCurved | kFeatureSpecular | kFeatureCameraArea | kFeatureFrontOnly;
    EXPECT_EQ(featuresOf(scene), needed);
    EXPECT_EQ(neededFeatures(needed, SamplerKind::Independent), needed | kFeatureIndependentSampler);
    EXPECT_EQ(neededFeatures(needed, SamplerKind::Sobol), needed);
}

TEST(FeatureScan, PrincipledMaterialsHaveABitOfTheirOwn) {
    Material paint = materialOf(MaterialKind::Principled);
    paint.roughness.value = 0.4f;
    paint.clearcoat.value = 1.0f;
    EXPECT_EQ(featuresOf(sceneOf({paint})), FeatureMask{kFeatureCurved | kFeaturePrincipled});
}

TEST(FeatureScan, Meshes) {
    SceneDescription scene = sceneOf({materialOf(MaterialKind::Plastic)});
    auto data = std::make_shared<MeshData>();
    scene.meshes.resize(1);
    scene.meshes[0].data = data;
    scene.objects[0].shape = ShapeKind::Mesh;
    scene.objects[0].mesh = 0;
    EXPECT_EQ(featuresOf(scene), FeatureMask{kFeatureMesh | kFeaturePlastic});
    data->normals.resize(3);
    data->colors.resize(3);
    scene.objects[0].objectToWorld = translate(Vec3(1.0f, 0.0f, 0.0f));
    EXPECT_EQ(featuresOf(scene), FeatureMask{kFeatureMesh | kFeaturePlastic | kFeatureMeshNormals |
                                             kFeatureMeshColors | kFeatureTransforms});
}

TEST(CameraBuilder, LooksWhereItShould) {
    Camera camera;
    camera.position = Vec3(0.0f, 0.0f, 5.0f);
    camera.target = Vec3(0.0f);
    camera.verticalFovDeg = 90.0f;
    camera.horizontalScale = 0.5f;
    const CameraData data = *buildCamera(camera, 2.0f);
    EXPECT_LT(glm::length(data.frame.s - Vec3(1, 0, 0)), 1e-6f) << "right";
    EXPECT_LT(glm::length(data.frame.t - Vec3(0, 1, 0)), 1e-6f) << "up";
    EXPECT_LT(glm::length(data.frame.n - Vec3(0, 0, 1)), 1e-6f) << "backwards";
    EXPECT_NEAR(data.halfHeight, 1.0f, 1e-6f);
    EXPECT_NEAR(data.halfWidth, 1.0f, 1e-6f);
}

TEST(CameraBuilder, SurvivesUpsThatSayNothing) {
    Camera camera;
    camera.position = Vec3(0.0f, 10.0f, 0.0f);
    camera.target = Vec3(0.0f);
    for (const Vec3& up : {Vec3(0, 1, 0), Vec3(0.0f), Vec3(0, -1e30f, 0), Vec3(1e-30f, 0, 0)}) {
        camera.up = up;
        const auto data = buildCamera(camera, 1.0f);
        ASSERT_TRUE(data);
        EXPECT_NEAR(glm::length(data->frame.s), 1.0f, 1e-6f);
        EXPECT_NEAR(glm::dot(data->frame.s, data->frame.n), 0.0f, 1e-6f);
        EXPECT_NEAR(glm::dot(glm::cross(data->frame.s, data->frame.t), data->frame.n), 1.0f, 1e-6f);
    }
}

TEST(CameraBuilder, RefusesWhatShowsNothing) {
    const auto fails = [](void (*change)(Camera*)) {
        Camera camera;
        change(&camera);
        return !buildCamera(camera, 1.0f).ok();
    };
    EXPECT_FALSE(fails([](Camera*) {}));
    EXPECT_TRUE(fails([](Camera* c) { c->target = c->position; }));
    EXPECT_TRUE(fails([](Camera* c) { c->position.x = std::nanf(""); }));
    EXPECT_TRUE(fails([](Camera* c) { c->verticalFovDeg = 180.0f; }));
    EXPECT_TRUE(fails([](Camera* c) { c->verticalFovDeg = 0.0f; }));
    EXPECT_TRUE(fails([](Camera* c) { c->apertureDiameter = -1.0f; }));
    EXPECT_TRUE(fails([](Camera* c) { c->focalDistance = 0.0f; }));
    EXPECT_TRUE(fails([](Camera* c) { c->apertureBlades = 2; }));
    EXPECT_TRUE(fails([](Camera* c) { c->horizontalScale = 0.0f; }));
    EXPECT_FALSE(buildCamera(Camera{}, 0.0f).ok());
}

}  // namespace
}  // namespace glint
