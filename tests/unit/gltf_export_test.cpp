// Scenes written as glTF: valid files that show the same picture when they are opened again, bit for bit
// where nothing is approximated.
#include "tests/support/gltf_export_test.h"

#include <gmock/gmock.h>

#include "engine/io/atomic_file.h"
#include "engine/io/image_io.h"
#include "engine/scene/mesh_area.h"
#include "engine/scene/metals.h"
#include "tests/support/film_bits.h"
#include "tests/support/render_scene.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

class GltfExport : public GltfExportTest {};

constexpr const char* kExtensions = R"("extensions": {"KHR_lights_punctual": {"lights": [
    {"type": "point", "intensity": 3415, "color": [1, 0.5, 0.25]}, {"type": "directional", "intensity": 700.5},
    {"type": "spot", "intensity": 5000, "spot": {"innerConeAngle": 0.4, "outerConeAngle": 0.4}}]}})";

/// Meshes that are shared, mirrored and turned, pictures, glass, lamps, and lights of each kind.
TEST_F(GltfExport, FilesKeepTheirBits) {
    Image8 image{4, 4, {}, {}};
    for (int i = 0; i < 48; ++i) {
        image.rgb.push_back(static_cast<uint8_t>(5 * i));
    }
    ASSERT_TRUE(savePng(folder.path("a picture.png"), image));
    const std::string more = std::string(kExtensions) + R"(, "images": [{"uri": "a%20picture.png"}],
        "samplers": [{"wrapS": 33071, "wrapT": 33648, "magFilter": 9728}], "textures": [{"source": 0, "sampler": 0}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "aspectRatio": 1.25, "znear": 0.1}}],
        "materials": [{"name": "board", "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.4,
          "baseColorTexture": {"index": 0, "extensions": {"KHR_texture_transform": {"offset": [0.25, 0.5],
          "rotation": 0.5, "scale": [2, 3]}}}}, "normalTexture": {"index": 0, "scale": 0.5}},
         {"name": "glass", "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0}, "extensions": {"KHR_materials_transmission":
          {"transmissionFactor": 1}, "KHR_materials_ior": {"ior": 1.4}, "KHR_materials_volume": {"thicknessFactor": 2,
          "attenuationDistance": 3, "attenuationColor": [0.25, 0.5, 0.75]}}},
         {"name": "lamp", "emissiveFactor": [1, 0.5, 0.25], "extensions": {"KHR_materials_emissive_strength":
          {"emissiveStrength": 12.5}}}, {"name": "half", "alphaMode": "BLEND", "pbrMetallicRoughness":
          {"metallicFactor": 0, "baseColorFactor": [0.1, 0.2, 0.3, 0.6]},
          "extensions": {"KHR_materials_transmission": {"transmissionFactor": 0.5}}}])";
    const std::string primitive =
        R"({"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2,
        "material": )";
    const std::string meshes = "\"meshes\": [" + primitive + "0}]}, " + primitive + "1}]}, " + primitive +
                               "2}]}, " + primitive + "3}]}]";
    const std::string nodes =
        R"("nodes": [{"camera": 0, "translation": [0, 0, 6]}, {"mesh": 0, "name": "first"},
        {"mesh": 0, "rotation": [0, 0.38268343, 0, 0.92387953], "translation": [2, 0, -1], "scale": [-1, 2, 0.5]},
        {"mesh": 1, "translation": [-1, 0.5, 1]}, {"mesh": 2, "translation": [0, 3, 0],
         "rotation": [0.70710678, 0, 0, 0.70710678]}, {"mesh": 3, "translation": [1, -0.5, 2]},
        {"translation": [1, 2, 3], "extensions": {"KHR_lights_punctual": {"light": 0}}},
        {"rotation": [-0.70710678, 0, 0, 0.70710678], "extensions": {"KHR_lights_punctual": {"light": 1}}},
        {"translation": [0, 0, 5], "extensions": {"KHR_lights_punctual": {"light": 2}}}])";
    SceneDescription scene = load(gltf(more, meshes, nodes));
    scene.resolution = {50, 40};
    for (const char* name : {"out.gltf", "out.glb"}) {
        SceneDescription opened = exported(scene, name);
        EXPECT_THAT(warnings, IsEmpty());
        EXPECT_EQ(opened.warnings, scene.warnings);
        EXPECT_EQ(opened.objects.at(0).name, "first");
        EXPECT_EQ(opened.meshes.size(), 1u) << "shared by all";
        opened.resolution = scene.resolution;
        expectSameBits(renderPasses(scene, 3, 2), renderPasses(opened, 3, 2));
    }
    EXPECT_EQ(folder.size(), 5u) << "the picture beside the text is the one that was there";
}

/// Pictures elsewhere come along.
TEST_F(GltfExport, PicturesLieBesideTheText) {
    const TempFolder elsewhere;
    ASSERT_TRUE(savePng(elsewhere.path("t.png"), {1, 1, {10, 20, 30}}));
    SceneDescription scene = load(
        gltf(R"("images": [{"uri": ")" + elsewhere.path("t.png") + R"("}], "textures": [{"source": 0}],)" +
             material(R"("pbrMetallicRoughness": {"baseColorTexture": {"index": 0}})")));
    const SceneDescription opened = exported(scene, "out.gltf");
    EXPECT_EQ(pathOf(opened.textures.at(0).image.source), "t.png");
    EXPECT_EQ(readFile(folder.path("t.png")).value(), readFile(elsewhere.path("t.png")).value());
}

/// Block by block within the noise, where shapes are triangles and surfaces glTF's.
TEST_F(GltfExport, GlintScenesKeepTheirLight) {
    for (const char* name : {"cornell.json", "cornell_glass_mirror.json"}) {
        SceneDescription scene = repositoryScene(name);
        scene.options = RenderOptions();
        scene.resolution = {32, 32};
        SceneDescription opened = exported(scene);
        opened.resolution = scene.resolution;
        const Film before = renderFilm(scene, 96), after = renderFilm(opened, 96);
        for (int y = 0; y < 32; y += 16) {
            for (int x = 0; x < 32; x += 16) {
                const Estimate a = meanLuminance(before, x, y, x + 16, y + 16),
                               b = meanLuminance(after, x, y, x + 16, y + 16);
                EXPECT_TRUE(agree(a, b, 0.01))
                    << name << " " << x << " " << y << ": " << a.mean << " " << b.mean;
            }
        }
    }
}

TEST_F(GltfExport, ShapesBecomeTriangles) {
    SceneDescription scene = square();
    Object object = scene.objects.at(0);
    scene.objects.clear();
    for (const ShapeKind shape :
         {ShapeKind::Sphere, ShapeKind::Disc, ShapeKind::Rectangle, ShapeKind::Revolved}) {
        object.shape = shape;
        object.profile = {{0.0f, 1.0f}, {1.0f, -1.0f}};
        scene.objects.push_back(object);
        scene.objects.push_back(object);
    }
    const SceneDescription opened = exported(scene);
    EXPECT_THAT(warnings, ElementsAre("approximated: round shapes are triangles"));
    ASSERT_EQ(opened.objects.size(), 8u);
    const float areas[] = {4.0f * kPi, kPi, 4.0f, std::sqrt(5.0f) * kPi};
    for (size_t i = 0; i < 8; ++i) {
        const MeshData& mesh = *opened.meshes.at(static_cast<size_t>(opened.objects[i].mesh)).data;
        EXPECT_NEAR(areaOf(mesh), areas[i / 2], 1e-3f * areas[i / 2]) << i;
        for (size_t k = 0; k < mesh.indices.size(); k += 3) {
            const Vec3 &a = mesh.positions[mesh.indices[k]], &b = mesh.positions[mesh.indices[k + 1]],
                       &c = mesh.positions[mesh.indices[k + 2]];
            const Vec3 outwards = i < 2 ? a : i < 6 ? Vec3(0, 0, 1) : a + b + c;
            ASSERT_GT(glm::dot(glm::cross(b - a, c - a), outwards), 0.0f) << i;
        }
    }
    EXPECT_EQ(opened.objects[0].mesh, opened.objects[1].mesh) << "spheres share theirs";
}

/// Nodes have no shear, and mixed normals are made whole.
TEST_F(GltfExport, MeshesAreWhatTheSpecificationWants) {
    SceneDescription scene = square();
    auto mesh = std::make_shared<MeshData>(*scene.meshes[0].data);
    mesh->normals = {Vec3(0, 0, 3), Vec3(0.0f), Vec3(0, 0, 1), Vec3(0, 1, 1)};
    scene.meshes[0].data = mesh;
    scene.objects.push_back(scene.objects[0]);
    scene.objects[1].objectToWorld = {Mat3(1, 0, 0, 0.5f, -1, 0, 0, 0, 2), Vec3(1, 2, 3)};
    const SceneDescription opened = exported(scene);
    EXPECT_THAT(warnings, IsEmpty());
    ASSERT_EQ(opened.objects.size(), 2u);
    for (size_t i = 0; i < 2; ++i) {
        const MeshData& read = *opened.meshes.at(static_cast<size_t>(opened.objects[i].mesh)).data;
        for (size_t k = 0; k < 6; ++k) {
            const Vec3 was = scene.objects[i].objectToWorld.point(mesh->positions[mesh->indices[k]]);
            float nearest = INFINITY;
            for (const Vec3& p : read.positions) {
                nearest = std::min(nearest, glm::length(opened.objects[i].objectToWorld.point(p) - was));
            }
            EXPECT_LT(nearest, 1e-5f) << i << " " << k;
        }
        for (const Vec3& normal : read.normals) {
            EXPECT_GT(normal.z, 0.4f) << "mirrored, the front stays";
        }
    }
}

TEST_F(GltfExport, PicturesAreWhatTheSpecificationWants) {
    SceneDescription scene = square();
    Material& material = scene.materials[0];
    const Image8 grey{2, 1, {100, 50, 25, 200, 150, 0}, {}};
    // A linear picture becomes an sRGB one; v from the bottom is turned over in the mesh.
    material.color.texture = addTexture(&scene, grey, ColorEncoding::Linear);
    material.roughness.texture = addTexture(&scene, grey, ColorEncoding::Srgb, TextureChannel::Blue);
    material.opacity.texture = addTexture(&scene, grey, ColorEncoding::Srgb, TextureChannel::Green);
    material.alphaCutsOut = false;
    SceneDescription opened = exported(scene);
    EXPECT_THAT(warnings, IsEmpty());
    ASSERT_FALSE(opened.textures.empty());
    const Texture& color = opened.textures.at(static_cast<size_t>(opened.materials[0].color.texture));
    EXPECT_FALSE(color.isPlaced());
    ASSERT_TRUE(color.image.bytes);
    EXPECT_THAT(color.image.bytes->alpha, ElementsAre(50, 150)) << "the opacity";
    EXPECT_THAT(color.image.bytes->rgb, ElementsAre(168, 122, 88, 229, 202, 0));
    EXPECT_EQ(opened.meshes[0].data->uvs[0].y, 1.0f - scene.meshes[0].data->uvs[0].y);
    const Texture& rough = opened.textures.at(static_cast<size_t>(opened.materials[0].roughness.texture));
    ASSERT_TRUE(rough.image.bytes);
    EXPECT_THAT(rough.image.bytes->rgb, ElementsAre(255, 80, 255, 255, 0, 255)) << "the root of alpha";
    // A checkerboard is two by two pixels, of which the nearest is shown.
    scene.textures[0].image = {
        .source = Checkerboard(), .bytes = nullptr, .floats = generateCheckerboard(Checkerboard())};
    scene.textures[0].filter = TexelFilter::Nearest;
    material.opacity.texture = -1;
    opened = exported(scene);
    EXPECT_THAT(warnings, ElementsAre("approximated: pictures have eight bits"));
    EXPECT_EQ(opened.textures.at(0).filter, TexelFilter::Nearest);
    EXPECT_EQ(opened.textures[0].image.bytes->width, 2);
}

/// A ramp that rises by 0.1 m over one of the square's two metres.
TEST_F(GltfExport, BumpsBecomeNormals) {
    SceneDescription scene = square();
    Image8 ramp{8, 8, {}, {}};
    for (int i = 0; i < 64; ++i) {
        ramp.rgb.insert(ramp.rgb.end(), 3, static_cast<uint8_t>(32 * (i % 8)));
    }
    Material& material = scene.materials[0];
    material.bump.texture = addTexture(&scene, ramp, ColorEncoding::Linear);
    material.bumpHeight = 0.1f;
    scene.textures[0].scale = Vec2(2.0f);
    const SceneDescription opened = exported(scene);
    EXPECT_THAT(warnings, ElementsAre("approximated: bump maps are normal maps"));
    ASSERT_GE(opened.materials[0].normalMap.texture, 0);
    const Texture& normals = opened.textures.at(static_cast<size_t>(opened.materials[0].normalMap.texture));
    EXPECT_EQ(glm::abs(normals.scale), Vec2(2.0f));
    const auto rise = static_cast<float>(256.0 / 255.0 * 0.1);
    const uint8_t* code = &normals.image.bytes->rgb[3 * (3 * 8 + 3)];
    const Vec3 normal = glm::normalize(Vec3(code[0], code[1], code[2]) / 127.5f - Vec3(1.0f));
    EXPECT_NEAR(normal.x / normal.z, -rise, 0.01f);
    EXPECT_NEAR(normal.y, 0.0f, 0.01f);
}

TEST_F(GltfExport, MaterialsKeepWhatGltfHas) {
    Material material;
    material.name = "\"gold\"";
    material.kind = MaterialKind::Conductor;
    material.color.value = Vec3(1.0f);
    material.metal = "gold";
    material.roughness.value = 0.04f;
    const Material gold = exportedMaterial(material);
    EXPECT_THAT(warnings, ElementsAre("approximated: metals have the colour that they show from the front"));
    EXPECT_EQ(gold.name, "\"gold\"");
    EXPECT_NEAR(gold.roughness.value, 0.04f, 1e-6f);
    material.metal = "";
    material.eta.value = Vec3(1.0f / 3.0f);  // a half, from the front
    material.k.value = Vec3(2.0f * std::sqrt(0.5f) / 1.5f);
    EXPECT_NEAR(exportedMaterial(material).color.value.x, 0.5f, 1e-5f);
    material.kind = MaterialKind::Translucent;
    material.color.value = {0.25f, 0.5f, 0.125f};
    material.transmission.value = {0.5f, 0.25f, 0.125f};
    const Material sheet = exportedMaterial(material);
    EXPECT_THAT(warnings, IsEmpty());
    EXPECT_EQ(sheet.kind, MaterialKind::Translucent);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(sheet.color.value[c], material.color.value[c], 1e-6f);
        EXPECT_NEAR(sheet.transmission.value[c], material.transmission.value[c], 1e-6f);
    }
    material.kind = MaterialKind::Diffuse;
    material.emission.value = {3, 2, 1};
    material.emissionStrength = 5.0f;
    material.emitsBothSides = true;
    const Material lamp = exportedMaterial(material);
    EXPECT_EQ(lamp.emissionStrength * lamp.emission.value, Vec3(15, 10, 5));
    EXPECT_TRUE(lamp.emitsBothSides);
}

TEST_F(GltfExport, CamerasKeepTheirProjection) {
    SceneDescription scene = square();
    scene.camera.position = {1, 2, 3};
    scene.camera.target = {0, 1, -1};
    scene.resolution = {300, 200};
    SceneDescription opened = exported(scene);
    EXPECT_EQ(opened.camera.verticalFovDeg, scene.camera.verticalFovDeg);
    EXPECT_EQ(opened.resolution.width, 900) << "the shape of the picture alone";
    EXPECT_GT(glm::dot(axesOf(opened.camera).forward, axesOf(scene.camera).forward), 0.999999f);
    scene.camera.kind = ProjectionKind::Orthographic;
    scene.camera.viewHeight = 2.4f;
    scene.camera.shift = {0.5f, 0.0f};
    opened = exported(scene);
    EXPECT_THAT(warnings, IsEmpty());
    EXPECT_EQ(opened.camera.viewHeight, 2.4f);
    EXPECT_NEAR(glm::dot(opened.camera.position - scene.camera.position, axesOf(scene.camera).right), 1.2f,
                1e-5f);
}

}  // namespace
}  // namespace glint::test
