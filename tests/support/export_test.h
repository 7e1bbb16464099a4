// What tests of the exporters share: a scene is saved and opened again.
#pragma once

#include <cmath>
#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/exporter.h"
#include "engine/io/scene_loader.h"
#include "engine/scene/mesh_area.h"
#include "tests/support/film_bits.h"
#include "tests/support/render_scene.h"

namespace glint::test {

/// Opened: the fixture of the importer's tests, with `folder` and `warnings`.
template <class Opened>
class ExportTest : public Opened {
  protected:
    /// outputName: its extension is the format's.
    explicit ExportTest(std::string outputName) : outputName_(std::move(outputName)) {}

    /// The scene as it is opened from its export.
    SceneDescription exported(const SceneDescription& scene) {
        const std::string path = this->folder.path(outputName_);
        this->warnings.clear();
        const Status saved = exporterOf(path)->save(scene, path, &this->warnings);
        EXPECT_TRUE(saved) << saved.error().format();
        auto opened = loadScene(path);
        EXPECT_TRUE(opened) << opened.error().format();
        return opened ? std::move(*opened) : SceneDescription();
    }
    void expectSamePicture(SceneDescription scene) {
        scene.resolution = {40, 30};
        scene.options.filter = FilterKind::Box;
        scene.options.filterRadius = 0.5f;
        const SceneDescription opened = exported(scene);
        EXPECT_THAT(this->warnings, testing::IsEmpty());
        expectSameBits(renderPasses(scene, 3, 2), renderPasses(opened, 3, 2));
    }
    /// Turns the only object of the scene into a tube of radius 1 and length 2 with its caps, from below and
    /// from above.
    void expectCapsAreKept(SceneDescription scene) {
        Object& object = scene.objects[0];
        object.shape = ShapeKind::Revolved;
        object.capped = true;
        for (const float top : {1.0f, -1.0f}) {
            object.profile = {{1.0f, -top}, {1.0f, top}};
            const SceneDescription opened = exported(scene);
            ASSERT_EQ(opened.meshes.size(), 1u);
            EXPECT_NEAR(areaOf(*opened.meshes[0].data), 6.0f * kPi, 0.01f)
                << "sides of 4 pi, two discs of pi";
        }
    }
    /// A plane with a picture, whose texels stay in their places.
    void expectTexturedPlanesAreKept() {
        const std::string path = this->folder.write(
            "plane.json",
            R"({"glint": 1, "resolution": [24, 16], "render": {"filter": "box"}, "environment": {"color": [1, 1, 1]},
"camera": {"position": [0.3, 0.2, 3], "target": [0.3, 0.2, 0]},
"textures": {"t": {"file": ")" +
                std::string(GLINT_SOURCE_DIR) + R"(/scenes/textures/slide.png"}},
"materials": {"m": {"type": "diffuse", "color": {"texture": "t"}}},
"objects": [{"type": "plane", "material": "m"}]})");
        const auto scene = loadScene(path);
        ASSERT_TRUE(scene) << scene.error().format();
        const Film before = renderPasses(*scene, 4, 2), after = renderPasses(exported(*scene), 4, 2);
        double difference = 0.0, sum = 0.0;
        for (size_t i = 0; i < before.pixels().size(); ++i) {
            for (size_t channel = 0; channel < 3; ++channel) {
                const double value = before.pixels()[i].mean[channel];
                difference += std::fabs(after.pixels()[i].mean[channel] - value);
                sum += value;
            }
        }
        EXPECT_GT(sum, 1.0);
        // In a square of 20 km, float finds u and v to 0.001, and 0.02 was measured. A picture that is
        // stretched over the whole square differs by 1.9, one twice as large by 0.9 (from the
        // picture's texels).
        EXPECT_LE(difference, 0.05 * sum);
    }
    /// Adds a lamp of ray casting alone to the scene, and expects it back without, and with a word.
    void expectCastLightsAreLeftOut(SceneDescription scene) {
        scene.lights.clear();
        Light lamp;
        lamp.onlyRayCast = true;
        scene.lights.push_back(lamp);
        EXPECT_TRUE(exported(scene).lights.empty());
        EXPECT_THAT(this->warnings, testing::Contains("left out: lights of ray casting alone"));
    }
    static SceneDescription repositoryScene(const std::string& name) {
        auto scene = loadScene(std::string(GLINT_SOURCE_DIR) + "/scenes/" + name);
        EXPECT_TRUE(scene) << scene.error().format();
        return scene ? std::move(*scene) : SceneDescription();
    }

  private:
    std::string outputName_;
};

}  // namespace glint::test
