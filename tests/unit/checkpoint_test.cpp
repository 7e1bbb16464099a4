// Checkpoints bring the film back to the last bit, belong to one scene and one set of settings, and say
// what differs.
#include "engine/render/checkpoint.h"

#include <cstring>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "tests/support/capture.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::captureOf;
using test::TempFolder;
using testing::HasSubstr;

constexpr int kWidth = 37;
constexpr int kHeight = 21;

std::vector<PixelSample> randomSamples(std::mt19937& random) {
    std::uniform_real_distribution<float> value(0.0f, 3.0f);
    std::vector<PixelSample> samples(kWidth * kHeight);
    for (PixelSample& sample : samples) {
        sample.radiance = {value(random), value(random), value(random)};
        sample.rays = 3;
    }
    samples[5] = {.radiance = Vec3(0.0f), .fault = SampleFault::NotANumber, .rays = 1};
    return samples;
}

Film filmAfter(uint32_t firstPass, uint32_t passes, Film film, std::mt19937& random) {
    for (uint32_t pass = firstPass; pass < firstPass + passes; ++pass) {
        film.commit(randomSamples(random), pass, 1);
    }
    return film;
}

SceneDescription someScene() {
    SceneDescription scene;
    scene.resolution = {kWidth, kHeight};
    scene.materials.resize(2);
    auto mesh = std::make_shared<MeshData>();
    mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh->indices = {0, 1, 2};
    scene.meshes.push_back({.name = "triangle", .source = {}, .data = mesh});
    Object object;
    object.shape = ShapeKind::Mesh;
    object.mesh = 0;
    scene.objects.push_back(object);
    auto image = std::make_shared<Image8>(Image8{1, 1, {1, 2, 3}});
    Texture texture;
    texture.image.bytes = image;
    scene.textures.push_back(texture);
    scene.materials[0].color.texture = 0;
    scene.textures.push_back(texture);  // which no material has
    scene.meshes.push_back({.name = "unplaced", .source = {}, .data = mesh});
    scene.lights.emplace_back();
    return scene;
}

void expectSameFilm(const Film& a, const Film& b) {
    EXPECT_EQ(a.width(), b.width());
    EXPECT_EQ(a.height(), b.height());
    EXPECT_EQ(a.passes(), b.passes());
    EXPECT_EQ(a.rays(), b.rays());
    EXPECT_EQ(a.faultCounts(), b.faultCounts());
    ASSERT_EQ(a.faults().size(), b.faults().size());
    for (size_t i = 0; i < a.faults().size(); ++i) {
        EXPECT_EQ(a.faults()[i].x, b.faults()[i].x);
        EXPECT_EQ(a.faults()[i].y, b.faults()[i].y);
        EXPECT_EQ(a.faults()[i].pass, b.faults()[i].pass);
        EXPECT_EQ(a.faults()[i].fault, b.faults()[i].fault);
    }
    ASSERT_EQ(a.pixels().size(), b.pixels().size());
    for (size_t i = 0; i < a.pixels().size(); ++i) {
        const FilmPixel& p = a.pixels()[i];
        const FilmPixel& q = b.pixels()[i];
        EXPECT_EQ(std::memcmp(p.mean.data(), q.mean.data(), sizeof p.mean), 0);
        EXPECT_EQ(std::memcmp(&p.luminanceM2, &q.luminanceM2, sizeof p.luminanceM2), 0);
        EXPECT_EQ(p.count, q.count);
    }
}

TEST(Checkpoint, BringsTheFilmBackExactlyAndGoesOnAsIfNothingHappened) {
    const TempFolder folder;
    const std::string path = folder.path("a.checkpoint");
    const SceneDescription scene = someScene();
    std::mt19937 random(1);
    const Film half = filmAfter(0, 5, Film(kWidth, kHeight), random);
    SessionCapture capture = captureOf(scene, half, 12.5);
    capture.curve.add({2, 5.0, 0.5, 0.4, 0.7, 0.1});
    capture.curve.add({5, 12.5, 0.25, 0.2, 0.3, 0.05});
    ASSERT_TRUE(saveCheckpoint(path, capture));
    const std::mt19937 afterHalf = random;
    const Film whole = filmAfter(5, 5, half, random);

    const Result<ResumePoint> loaded = loadCheckpoint(path, scene);
    ASSERT_TRUE(loaded) << loaded.error().format();
    expectSameFilm(loaded->film, half);
    EXPECT_EQ(loaded->renderSeconds, 12.5);
    ASSERT_EQ(loaded->curve.points().size(), 2u);
    const ConvergencePoint& last = loaded->curve.points()[1];
    EXPECT_EQ(last.passes, 5u);
    EXPECT_EQ(last.renderSeconds, 12.5);
    EXPECT_EQ(last.relativeError, 0.25);
    EXPECT_EQ(last.relativeErrorLow, 0.2);
    EXPECT_EQ(last.relativeErrorHigh, 0.3);
    EXPECT_EQ(last.relativeBias, 0.05);
    random = afterHalf;
    expectSameFilm(filmAfter(5, 5, loaded->film, random), whole);
}

TEST(Checkpoint, TellsAboutItself) {
    const TempFolder folder;
    const std::string path = folder.path("a.checkpoint");
    std::mt19937 random(2);
    ASSERT_TRUE(
        saveCheckpoint(path, captureOf(someScene(), filmAfter(0, 3, Film(kWidth, kHeight), random), 1.0)));
    const Result<CheckpointInfo> info = readCheckpointInfo(path);
    ASSERT_TRUE(info) << info.error().format();
    EXPECT_EQ(info->passes, 3u);
    EXPECT_EQ(info->glintVersion, GLINT_VERSION);
    EXPECT_EQ(info->settings, renderSettings(someScene()));
    EXPECT_EQ(info->hashes, hashSceneParts(someScene()));
}

TEST(Checkpoint, NamesWhatDiffers) {
    const TempFolder folder;
    const std::string path = folder.path("a.checkpoint");
    ASSERT_TRUE(saveCheckpoint(path, captureOf(someScene(), Film(kWidth, kHeight), 0.0)));
    const auto refusal = [&](auto edit) {
        SceneDescription scene = someScene();
        edit(scene);
        const Result<ResumePoint> result = loadCheckpoint(path, scene);
        return result ? std::string("accepted") : result.error().format();
    };
    EXPECT_EQ(refusal([](SceneDescription&) {}), "accepted");
    EXPECT_EQ(refusal([](SceneDescription& s) { s.title = s.path = s.materials[0].name = "other"; }),
              "accepted");
    EXPECT_THAT(refusal([](SceneDescription& s) { s.camera.focalDistance = 9.0f; }),
                HasSubstr("the camera differs"));
    EXPECT_THAT(refusal([](SceneDescription& s) { s.objects[0].objectToWorld.translation.x = 1e-6f; }),
                HasSubstr("the geometry differs"));
    EXPECT_THAT(refusal([](SceneDescription& s) {
                    auto mesh = std::make_shared<MeshData>(*s.meshes[0].data);
                    mesh->positions[1].x = 2.0f;
                    s.meshes[0].data = mesh;
                }),
                HasSubstr("the geometry differs"));
    EXPECT_THAT(refusal([](SceneDescription& s) { s.materials[1].emission.value = Vec3(1.0f); }),
                HasSubstr("the materials differ"));
    EXPECT_THAT(refusal([](SceneDescription& s) {
                    s.textures[0].image.bytes = std::make_shared<Image8>(Image8{1, 1, {1, 2, 4}});
                }),
                HasSubstr("the textures differ"));
    EXPECT_THAT(refusal([](SceneDescription& s) { s.environment.rotationDeg = 1.0f; }),
                HasSubstr("the lights differ"));
    // What nothing uses is not in the picture.
    EXPECT_EQ(refusal([](SceneDescription& s) {
                  s.textures[1].image.bytes = nullptr;
                  s.meshes[1].data = nullptr;
              }),
              "accepted");
    const auto withUvs = [](SceneDescription& s) {
        auto mesh = std::make_shared<MeshData>(*s.meshes[0].data);
        mesh->uvs = {{0, 0}, {1, 0}, {0, 1}};
        s.meshes[0].data = mesh;
    };
    EXPECT_THAT(refusal(withUvs), HasSubstr("the geometry differs"));
    SceneDescription plain = someScene();
    plain.materials[0].color.texture = -1;
    const Hash128 before = sceneHash(plain);
    withUvs(plain);
    EXPECT_EQ(sceneHash(plain), before) << "no texture needs them";
    const std::string several = refusal([](SceneDescription& s) {
        s.options.maxDepth = 8;
        s.resolution.width = 38;
        s.options.filter = FilterKind::Box;
    });
    EXPECT_THAT(several, HasSubstr("maxDepth is 64 in the checkpoint and 8 now"));
    EXPECT_THAT(several, HasSubstr("width is 37 in the checkpoint and 38 now"));
    EXPECT_THAT(several, HasSubstr("filter is blackman-harris in the checkpoint and box now"));
}

TEST(Checkpoint, EveryFieldOfTheSceneCounts) {
    const Hash128 plain = sceneHash(someScene());
    const auto changes = [&](auto edit) {
        SceneDescription scene = someScene();
        edit(scene);
        return !(sceneHash(scene) == plain);
    };
    using S = SceneDescription&;
    EXPECT_FALSE(changes([](S) {}));
    EXPECT_TRUE(changes([](S s) { s.camera.position.x += 1.0f; }));
    EXPECT_TRUE(changes([](S s) { s.camera.target.y += 1.0f; }));
    EXPECT_TRUE(changes([](S s) { s.camera.up.x += 1.0f; }));
    EXPECT_TRUE(changes([](S s) { s.camera.verticalFovDeg += 1.0f; }));
    EXPECT_TRUE(changes([](S s) { s.camera.horizontalScale += 1.0f; }));
    EXPECT_TRUE(changes([](S s) { s.camera.apertureDiameter += 1.0f; }));
    EXPECT_TRUE(changes([](S s) { s.camera.apertureBlades = 5; }));
    EXPECT_TRUE(changes([](S s) { s.camera.bladeRotationDeg = 5.0f; }));
    EXPECT_TRUE(changes([](S s) { s.objects[0].frontOnly = true; }));
    EXPECT_TRUE(changes([](S s) { s.objects[0].material = 1; }));
    EXPECT_TRUE(changes([](S s) { s.objects[0].shape = ShapeKind::Disc; }));
    EXPECT_TRUE(changes([](S s) { s.objects[0].objectToWorld.linear[1][2] = 0.5f; }));
    EXPECT_TRUE(changes([](S s) { s.objects.push_back(s.objects[0]); }));
    EXPECT_TRUE(changes([](S s) { s.materials[0].kind = MaterialKind::Plastic; }));
    EXPECT_TRUE(changes([](S s) { s.materials[0].color.texture = 1; }));
    EXPECT_TRUE(changes([](S s) { s.materials[0].metal = "silver"; }));
    EXPECT_TRUE(changes([](S s) { s.materials[0].roughness.value = 0.1f; }));
    EXPECT_TRUE(changes([](S s) { s.materials[0].thin = true; }));
    EXPECT_TRUE(changes([](S s) { s.materials[0].mixtureWeights.value.y = 1.0f; }));
    EXPECT_TRUE(changes([](S s) { s.materials[0].emissionStrength = 2.0f; }));
    EXPECT_TRUE(changes([](S s) { s.materials[0].emitsBothSides = true; }));
    EXPECT_TRUE(changes([](S s) { s.textures[0].flipV = true; }));
    EXPECT_TRUE(changes([](S s) { s.textures[0].scale.x = 2.0f; }));
    EXPECT_TRUE(changes([](S s) { s.textures[0].encoding = ColorEncoding::Linear; }));
    EXPECT_TRUE(changes([](S s) { s.lights[0].coneAngleDeg = 2.0f; }));
    EXPECT_TRUE(changes([](S s) { s.environment.color = Vec3(1.0f); }));
    EXPECT_TRUE(changes([](S s) { s.options.seed = 1; }));
    EXPECT_TRUE(changes([](S s) { s.options.fireflyClamp = 1.0f; }));
}

TEST(ContentHash, IsStable) {
    // Checkpoints of one version must open in the next one: these values may never change.
    ContentHash hash;
    hash.add("glint");
    hash.add(1.5f);
    EXPECT_EQ(hash.finish().hex(), "73e11f8acbd345bd2ae1e6569ab7bdfe");
    ContentHash split;
    split.add("ab");
    split.add("c");
    ContentHash other;
    other.add("a");
    other.add("bc");
    EXPECT_FALSE(split.finish() == other.finish());
}

}  // namespace
}  // namespace glint
