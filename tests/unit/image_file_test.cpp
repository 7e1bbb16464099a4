// Snapshots as image files: what each format keeps.
#include "engine/render/image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/exr_io.h"
#include "engine/io/image_io.h"
#include "engine/scene/scene_hash.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::TempFolder;
using testing::HasSubstr;

SceneDescription someScene() {
    SceneDescription scene;
    scene.resolution = {3, 2};
    scene.lights.emplace_back();
    return scene;
}

FilmSnapshot someSnapshot() {
    FilmSnapshot snapshot;
    snapshot.width = 3;
    snapshot.height = 2;
    snapshot.passes = 7;
    snapshot.renderSeconds = 1.25;
    snapshot.relativeError = 0.015625;
    for (int i = 0; i < 18; ++i) {
        snapshot.radiance.push_back(0.1f * static_cast<float>(i));
    }
    snapshot.standardError.assign(6, 0.25f);
    std::vector<AovSample> samples(6);
    for (uint32_t i = 0; i < 6; ++i) {
        samples[i] = {.albedo = Vec3(0.5f),
                      .shadingNormal = {0.0f, 1.0f, 0.0f},
                      .geometricNormal = {0.0f, 0.0f, 1.0f},
                      .depth = 1e6f + static_cast<float>(i),
                      .objectId = 16777217u + i,
                      .materialId = i};
    }
    auto aovs = std::make_shared<AovFilm>(3, 2);
    aovs->commit(samples, 1);
    snapshot.aovs = aovs;
    return snapshot;
}

TEST(ImageFile, ExrKeepsRadianceLayersAndMetadata) {
    const TempFolder folder;
    const std::string path = folder.path("picture.EXR");
    const FilmSnapshot snapshot = someSnapshot();
    const uint32_t all =
        kAovAlbedo | kAovShadingNormal | kAovGeometricNormal | kAovDepth | kAovObjectId | kAovMaterialId;
    const ImageOptions options{.exrColor = ExrPixelType::Float, .aovs = all};
    const Status saved = saveImage(path, snapshot, someScene(), options);
    ASSERT_TRUE(saved) << saved.error().format();

    const Result<ExrImage> loaded = loadExr(path);
    ASSERT_TRUE(loaded) << loaded.error().format();
    const auto image = loadExrColor(path);
    ASSERT_TRUE(image);
    EXPECT_EQ(image->color.rgb, snapshot.radiance);
    for (const char* name :
         {"albedo.R", "albedo.G", "albedo.B", "normal.X", "normal.Y", "normal.Z", "geometricNormal.Z",
          "depth.Z", "objectId.id", "materialId.id", "standardError.Y"}) {
        EXPECT_NE(loaded->find(name), nullptr) << name;
    }
    EXPECT_EQ(loaded->find("normal.Y")->floats[4], 1.0f);
    EXPECT_EQ(loaded->find("depth.Z")->floats[5], 1e6f + 5.0f);
    EXPECT_EQ(loaded->find("objectId.id")->ids[5], 16777222u);  // more than a float can tell apart
    EXPECT_EQ(loaded->find("standardError.Y")->floats[0], 0.25f);
    EXPECT_EQ(loaded->attributes.at("sceneHash"), sceneHash(someScene()).hex());
    EXPECT_EQ(loaded->attributes.at("passes"), "7");
    EXPECT_EQ(loaded->attributes.at("renderSeconds"), "1.25");
    EXPECT_EQ(loaded->attributes.at("relativeError"), "0.015625");
    EXPECT_EQ(loaded->attributes.at("glintVersion"), GLINT_VERSION);
    EXPECT_EQ(loaded->attributes.at("setting.maxDepth"), "64");
}

TEST(ImageFile, PngAndHdrAndRefusals) {
    const TempFolder folder;
    const FilmSnapshot snapshot = someSnapshot();
    const SceneDescription scene = someScene();
    ASSERT_TRUE(saveImage(folder.path("a.png"), snapshot, scene, {.look = {.toneMap = ToneMap::Clamp}}));
    const auto png = loadImage8(folder.path("a.png"));
    ASSERT_TRUE(png);
    EXPECT_EQ((*png)->rgb[5], 128);   // 0.5 * 255 + 0.5
    EXPECT_EQ((*png)->rgb[17], 255);  // 1.7 is cut
    ASSERT_TRUE(saveImage(folder.path("a.hdr"), snapshot, scene, {}));
    const auto hdr = loadImageF(folder.path("a.hdr"));
    ASSERT_TRUE(hdr);
    EXPECT_NEAR((*hdr)->rgb[17], 1.7f, 1.7f / 128.0f);

    const Status wrong = saveImage(folder.path("a.gif"), snapshot, scene, {});
    ASSERT_FALSE(wrong);
    EXPECT_THAT(wrong.error().format(), HasSubstr("expected .png, .hdr or .exr"));
    FilmSnapshot withoutLayers = snapshot;
    withoutLayers.aovs = nullptr;
    EXPECT_FALSE(saveImage(folder.path("b.exr"), withoutLayers, scene, {.aovs = kAovDepth}));
    EXPECT_FALSE(saveImage(folder.path("b.png"), FilmSnapshot{}, scene, {}));
    EXPECT_EQ(folder.size(), 2u);
}

}  // namespace
}  // namespace glint
