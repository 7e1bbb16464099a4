// What tests of the glTF importer share: a folder, and scenes from texts that must open.
#pragma once

#include <gtest/gtest.h>

#include "engine/builders/scene_validation.h"
#include "engine/io/scene_loader.h"
#include "tests/support/gltf_files.h"
#include "tests/support/temp_folder.h"

namespace glint::test {

class GltfTest : public testing::Test {
  protected:
    SceneDescription load(const std::string& text, const std::string& name = "a.gltf") {
        auto scene = loadScene(folder.write(name, text), {.noStudio = true});
        EXPECT_TRUE(scene) << scene.error().format();
        if (!scene) { return {}; }
        EXPECT_TRUE(validateScene(*scene, EditKind::Everything));
        return std::move(*scene);
    }
    Material only(const std::string& members) {
        const SceneDescription scene = load(gltf(material(members)));
        return scene.materials.empty() ? Material() : scene.materials[0];
    }
    TempFolder folder;
};

}  // namespace glint::test
