// Saving a scene as Glint JSON and loading it gives back every field that affects the picture, bit for bit.
#include <cstring>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/scene_json.h"
#include "engine/io/scene_loader.h"
#include "engine/scene/scene_fields.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

template <class T>
bool sameBits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof(T)) == 0;
}

template <class T>
bool sameArray(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

void expectSame(const MeshData& a, const MeshData& b) {
    EXPECT_TRUE(sameArray(a.positions, b.positions));
    EXPECT_TRUE(sameArray(a.normals, b.normals));
    EXPECT_TRUE(sameArray(a.uvs, b.uvs));
    EXPECT_TRUE(sameArray(a.colors, b.colors));
    EXPECT_TRUE(sameArray(a.tangents, b.tangents));
    EXPECT_TRUE(sameArray(a.indices, b.indices));
}

void expectSame(const SceneImage& a, const SceneImage& b) {
    ASSERT_EQ(a.bytes != nullptr, b.bytes != nullptr);
    ASSERT_EQ(a.floats != nullptr, b.floats != nullptr);
    if (a.bytes) { EXPECT_TRUE(sameArray(a.bytes->rgb, b.bytes->rgb)); }
    if (a.floats) { EXPECT_TRUE(sameArray(a.floats->rgb, b.floats->rgb)); }
}

void expectSame(const Material& a, const Material& b) {
    EXPECT_EQ(a.kind, b.kind) << a.name;
    EXPECT_TRUE(sameBits(a.color.value, b.color.value)) << a.name;
    EXPECT_EQ(a.color.texture, b.color.texture) << a.name;
    EXPECT_EQ(a.metal, b.metal) << a.name;
    EXPECT_TRUE(sameBits(a.eta, b.eta) && sameBits(a.k, b.k)) << a.name;
    EXPECT_TRUE(sameBits(a.ior, b.ior)) << a.name;
    EXPECT_TRUE(sameBits(a.roughness, b.roughness)) << a.name;
    EXPECT_EQ(a.thin, b.thin) << a.name;
    EXPECT_TRUE(sameBits(a.mixtureWeights, b.mixtureWeights)) << a.name;
    EXPECT_TRUE(sameBits(a.emission, b.emission)) << a.name;
    EXPECT_TRUE(sameBits(a.emissionStrength, b.emissionStrength)) << a.name;
    EXPECT_EQ(a.emitsBothSides, b.emitsBothSides) << a.name;
}

void expectSame(const Object& a, const Object& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.shape, b.shape) << a.name;
    EXPECT_EQ(a.mesh, b.mesh) << a.name;
    EXPECT_EQ(a.material, b.material) << a.name;
    EXPECT_TRUE(sameBits(a.objectToWorld, b.objectToWorld)) << a.name;
    EXPECT_EQ(a.frontOnly, b.frontOnly) << a.name;
}

void expectSame(const Light& a, const Light& b) {
    EXPECT_EQ(a.kind, b.kind) << a.name;
    EXPECT_TRUE(sameBits(a.position, b.position) && sameBits(a.direction, b.direction)) << a.name;
    EXPECT_TRUE(sameBits(a.color, b.color) && sameBits(a.strength, b.strength)) << a.name;
    EXPECT_TRUE(sameBits(a.coneAngleDeg, b.coneAngleDeg)) << a.name;
    EXPECT_TRUE(sameBits(a.coneFalloffStartDeg, b.coneFalloffStartDeg)) << a.name;
}

void expectSame(const SceneDescription& a, const SceneDescription& b) {
    EXPECT_EQ(a.title, b.title);
    EXPECT_EQ(a.description, b.description);
    forEachField<Camera>([&](const auto& field) {
        EXPECT_TRUE(sameBits(a.camera.*field.member, b.camera.*field.member)) << field.key;
    });
    EXPECT_EQ(a.resolution, b.resolution);
    EXPECT_EQ(a.options, b.options);
    EXPECT_EQ(a.sppm, b.sppm);
    ASSERT_EQ(a.textures.size(), b.textures.size());
    ASSERT_EQ(a.materials.size(), b.materials.size());
    ASSERT_EQ(a.meshes.size(), b.meshes.size());
    ASSERT_EQ(a.objects.size(), b.objects.size());
    ASSERT_EQ(a.lights.size(), b.lights.size());
    for (size_t i = 0; i < a.textures.size(); ++i) {
        expectSame(a.textures[i].image, b.textures[i].image);
        EXPECT_EQ(a.textures[i].encoding, b.textures[i].encoding);
        EXPECT_EQ(a.textures[i].flipV, b.textures[i].flipV);
        EXPECT_TRUE(sameBits(a.textures[i].scale, b.textures[i].scale));
        EXPECT_TRUE(sameBits(a.textures[i].offset, b.textures[i].offset));
        EXPECT_EQ(a.textures[i].rotationDeg, b.textures[i].rotationDeg);
        EXPECT_EQ(a.textures[i].wrapU, b.textures[i].wrapU);
        EXPECT_EQ(a.textures[i].wrapV, b.textures[i].wrapV);
        EXPECT_EQ(a.textures[i].filter, b.textures[i].filter);
    }
    for (size_t i = 0; i < a.materials.size(); ++i) {
        expectSame(a.materials[i], b.materials[i]);
    }
    for (size_t i = 0; i < a.meshes.size(); ++i) {
        expectSame(*a.meshes[i].data, *b.meshes[i].data);
    }
    for (size_t i = 0; i < a.objects.size(); ++i) {
        expectSame(a.objects[i], b.objects[i]);
    }
    for (size_t i = 0; i < a.lights.size(); ++i) {
        expectSame(a.lights[i], b.lights[i]);
    }
    EXPECT_TRUE(sameBits(a.environment.color, b.environment.color));
    EXPECT_TRUE(sameBits(a.environment.strength, b.environment.strength));
    EXPECT_TRUE(sameBits(a.environment.rotationDeg, b.environment.rotationDeg));
    ASSERT_EQ(a.environment.image >= 0, b.environment.image >= 0);
    if (a.environment.image >= 0) {
        expectSame(a.environmentImages[static_cast<size_t>(a.environment.image)],
                   b.environmentImages[static_cast<size_t>(b.environment.image)]);
    }
}

/// Saves into another folder, so that relative paths have to be rewritten.
void expectSurvivesSaving(const std::string& path, const LoadOptions& options = {}) {
    SCOPED_TRACE(path);
    const auto original = loadScene(path, options);
    ASSERT_TRUE(original.ok()) << original.error().format();
    const fs::path folder = fs::path(testing::TempDir()) / "glint_scene_save";
    fs::create_directories(folder);
    const std::string saved = (folder / "saved.json").string();
    const Status status = saveSceneJson(*original, saved);
    ASSERT_TRUE(status.ok()) << status.error().format();
    const auto loaded = loadScene(saved);
    ASSERT_TRUE(loaded.ok()) << loaded.error().format();
    expectSame(*original, *loaded);
    fs::remove_all(folder);
}

TEST(SceneSave, OurOwnScenesComeBack) {
    for (const auto& entry : fs::directory_iterator(GLINT_SOURCE_DIR "/scenes")) {
        if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".schema") {
            expectSurvivesSaving(entry.path().string());
        }
    }
}

TEST(SceneSave, TextScenesAndObjFilesComeBack) {
    for (const auto& entry : fs::directory_iterator(GLINT_SOURCE_DIR "/tests/data/film")) {
        if (entry.path().extension() == ".txt" || entry.path().extension() == ".obj") {
            expectSurvivesSaving(entry.path().string());
        }
    }
}

SceneDescription sceneWithEverything() {
    SceneDescription scene;
    scene.title = "quotes \" and \\ and\ncontrol \x01";
    scene.camera.verticalFovDeg = 0.1f + 0.2f;
    scene.camera.apertureBlades = 5;
    scene.options = {.integrator = IntegratorKind::Sppm,
                     .maxDepth = 7,
                     .rouletteStartDepth = 2,
                     .filter = FilterKind::Gaussian,
                     .filterRadius = 1.7f,
                     .sampler = SamplerKind::Independent,
                     .accelerator = AcceleratorKind::Aabb,
                     .seed = 0xFFFFFFFFu,
                     .fireflyClamp = 1e-30f};
    scene.sppm = {.photonsPerPass = 1u << 30,
                  .alpha = 0.7f,
                  .radiusWorld = 1.0f / 3.0f,
                  .radiusFootprints = 2.7f,
                  .storeRoughness = 0.17f,
                  .sampleDirectLight = false,
                  .lookup = PhotonLookupKind::Tree,
                  .memoryBudgetMiB = 77};
    scene.rayCast = {.shadows = false, .falloff = false, .ambient = {0.1f, 0.2f, 1.0f / 3.0f}};
    for (int kind = 0; kind < 6; ++kind) {
        Material material;
        material.name = kind % 2 == 0 ? "twice" : "";
        material.kind = static_cast<MaterialKind>(kind);
        material.color.value = {0.1f, 1.0f / 3.0f, 0.7f};
        material.emission.value = {1e20f, 0.0f, 1.0f / 7.0f};
        material.emitsBothSides = kind == 1;
        scene.materials.push_back(material);
    }
    scene.materials[2].metal.clear();
    scene.materials[2].eta.value = {1.1f, 1.2f, 1.3f};
    scene.materials[3].thin = true;
    scene.materials[3].phongSpecular = {0.1f, 0.2f, 3.0f};
    scene.materials[3].phongExponent = 1.0f / 7.0f;
    scene.materials[4].roughness.value = 0.3f;
    scene.materials[5].mixtureWeights.value = {0.2f, 0.3f, 0.5f};
    auto mesh = std::make_shared<MeshData>();
    mesh->positions = {{0, 0, 0}, {1.0f / 3.0f, 1e-30f, -0.0f}, {0, 16777216.0f, 3e38f}};
    mesh->normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    mesh->uvs = {{0, 0}, {1, 0}, {0.3f, 1}};
    mesh->colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh->tangents = {{1, 0, 0, -1}, {1.0f / 3.0f, 0.9f, 0, 1}, {0, 0, 0, 0}};
    mesh->indices = {0, 1, 2};
    scene.meshes.resize(2);
    scene.meshes[0].data = mesh;
    scene.meshes[1].data = mesh;
    for (int shape = 0; shape < 5; ++shape) {
        for (int i = 0; i < 2; ++i) {
            Object object;
            object.name = "object";
            object.shape = static_cast<ShapeKind>(shape);
            object.mesh = object.shape == ShapeKind::Mesh ? i : -1;
            object.material = shape + i;
            object.frontOnly = i == 1;
            if (i == 1) {
                object.objectToWorld =
                    translate({0.1f, -0.0f, 5}) * rotate({1, 2, 3}, 0.7f) * scale({-1, 2, 0.3f});
            }
            scene.objects.push_back(object);
        }
    }
    for (int kind = 0; kind < 4; ++kind) {
        Light light;
        light.name = "light";
        light.kind = static_cast<LightKind>(kind);
        light.color = {0.1f, 0.2f, 0.3f};
        light.strength = 1e5f / 3.0f;
        scene.lights.push_back(light);
    }
    scene.lights[1].coneAngleDeg = 33.3f;
    scene.environment = {.color = {0.3f, 0.2f, 0.1f}, .strength = 0.7f, .image = 0, .rotationDeg = 12.3f};
    scene.environmentImages.resize(1);
    const SkySource sky{.sunElevationDeg = 12.5f, .width = 32};
    scene.environmentImages[0] = {.source = sky, .floats = generateSky(sky)};
    return scene;
}

TEST(SceneSave, EveryKindOfThingComesBack) {
    const SceneDescription scene = sceneWithEverything();
    const auto text = writeSceneJson(scene, "saved.json");
    ASSERT_TRUE(text.ok()) << text.error().format();
    const auto loaded = readSceneJson({"saved.json", *text}, {});
    ASSERT_TRUE(loaded.ok()) << loaded.error().format();
    expectSame(scene, *loaded);
}

TEST(SceneSave, NumbersThatAreNotFiniteAreRefused) {
    SceneDescription scene;
    scene.environment.strength = std::numeric_limits<float>::infinity();
    const auto text = writeSceneJson(scene, "saved.json");
    ASSERT_FALSE(text.ok());
    EXPECT_THAT(text.error().message, testing::HasSubstr("not finite"));
}

TEST(SceneSave, AFailedSaveLeavesTheOldFile) {
    const fs::path folder = fs::path(testing::TempDir()) / "glint_scene_save_failed";
    fs::create_directories(folder);
    const std::string path = (folder / "scene.json").string();
    std::ofstream(path) << "old";
    SceneDescription scene;
    scene.textures.resize(1);
    EXPECT_FALSE(saveSceneJson(scene, path).ok());
    std::string text;
    std::ifstream(path) >> text;
    EXPECT_EQ(text, "old");
    fs::remove_all(folder);
}

}  // namespace
}  // namespace glint
