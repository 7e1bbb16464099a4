// What tests of the Mitsuba importer share: a folder, and scenes from texts that must open.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/builders/scene_validation.h"
#include "engine/io/scene_loader.h"
#include "tests/support/temp_folder.h"

namespace glint::test {

class MitsubaTest : public testing::Test {
  protected:
    static std::string sceneText(const std::string& content) {
        return "<scene version=\"3.0.0\">\n" + content + "\n</scene>\n";
    }
    SceneDescription load(const std::string& content, LoadOptions options = {}) {
        return loadText(sceneText(content), std::move(options));
    }
    SceneDescription loadText(const std::string& text, LoadOptions options = {}) {
        options.noStudio = true;
        auto scene = loadScene(folder.write("a.xml", text), options);
        EXPECT_TRUE(scene) << scene.error().format();
        if (!scene) { return {}; }
        EXPECT_TRUE(validateScene(*scene, EditKind::Everything));
        return std::move(*scene);
    }
    std::string errorOf(const std::string& content) {
        const auto scene = loadScene(folder.write("bad.xml", sceneText(content)));
        return scene ? "no error" : scene.error().format();
    }
    Object onlyObject(const std::string& shape) {
        const SceneDescription scene = load(shape);
        EXPECT_FALSE(scene.objects.empty());
        return scene.objects.empty() ? Object() : scene.objects[0];
    }
    /// Of a two-sided sphere.
    Material materialOf(const std::string& bsdf) {
        const SceneDescription scene = load("<shape type='sphere'>" + bsdf + "</shape>");
        warnings = scene.warnings;
        return scene.objects.empty() ? Material()
                                     : scene.materials[static_cast<size_t>(scene.objects[0].material)];
    }
    static void expectNear(const Vec3& a, const Vec3& b, float tolerance) {
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(a[c], b[c], tolerance) << c;
        }
    }

    TempFolder folder;
    std::vector<std::string> warnings;
};

/// Two triangles that make the square from (-1, -1) to (1, 1), without normals.
inline constexpr const char* kSquareObj =
    "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";

}  // namespace glint::test
