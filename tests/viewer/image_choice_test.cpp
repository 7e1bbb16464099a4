// Files that are chosen for a material's inputs in the window.
#include "viewer/model/image_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/scene/scene_fields.h"

namespace glint {
namespace {

std::vector<std::string_view> inputKeys() {
    std::vector<std::string_view> keys;
    forEachField<Material>([&]<class Member>(const Field<Material, Member>& field) {
        if constexpr (kIsInput<Member>) { keys.push_back(field.key); }
    });
    return keys;
}

TEST(ImageChoice, ColoursAreReadAsSrgbAndNumbersAsTheyAre) {
    const std::vector<std::string_view> keys = inputKeys();
    std::vector<std::string_view> colors;
    for (size_t input = 0; input < keys.size(); ++input) {
        SceneDescription scene;
        scene.materials.resize(1);
        SceneDocument document;
        document.adopt(scene);
        chooseTextureFile(&document, 0, input, "image.png");
        ASSERT_EQ(document.draft().textures.size(), 1u) << keys[input];
        if (document.draft().textures[0].encoding == ColorEncoding::Srgb) { colors.push_back(keys[input]); }
    }
    EXPECT_THAT(colors, testing::UnorderedElementsAre("color", "emission", "transmission",
                                                      "specularReflectance", "specularTint", "sheenColor"));
}

}  // namespace
}  // namespace glint
