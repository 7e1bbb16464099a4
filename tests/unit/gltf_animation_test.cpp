// Animations of glTF files, where their nodes stand; and variants of their materials.
#include <gmock/gmock.h>

#include "tests/support/gltf_test.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// Times 1, 2 and 4; places, turns about z by 0, 90 and 180 degrees, weights, and a spline of two keys.
const std::string kKeys = kSquare + packed<float>({1, 2, 4}) + packed<float>({0, 0, 0, 2, 0, 0, 2, 4, 0}) +
                          packed<float>({0, 0, 0, 1, 0, 0, 0.70710678f, 0.70710678f, 0, 0, 1, 0}) +
                          packed<float>({0, 1, 0.5f}) + packed<float>({1, 3}) +
                          packed<float>({9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 0, 0, 4, 0, 0, 9, 9, 9});

const std::string kKeyViews = [] {
    std::string views = kViews;
    views.insert(views.find("]", views.find("byteOffset\": 80")),
                 ", {\"buffer\": 0, \"byteOffset\": 92, \"byteLength\": 188}");
    const auto accessor = [](int offset, int count, const char* type) {
        return ", {\"bufferView\": 3, \"byteOffset\": " + std::to_string(offset) +
               ", \"componentType\": 5126, \"count\": " + std::to_string(count) + ", \"type\": \"" + type +
               "\"}";
    };
    views.insert(views.rfind("]"), accessor(0, 3, "SCALAR") + accessor(12, 3, "VEC3") +
                                       accessor(48, 3, "VEC4") + accessor(96, 3, "SCALAR") +
                                       accessor(108, 2, "SCALAR") + accessor(116, 6, "VEC3"));
    return views;
}();

class GltfAnimation : public GltfTest {
  protected:
    Result<SceneDescription> open(const std::string& animations, const SceneParameters& parameters) {
        const std::string text = gltf(
            material("") + ", \"animations\": [" + animations + "]", kMesh,
            R"("nodes": [{"mesh": 0, "matrix": [2,0,0,0, 0,2,0,0, 0,0,2,0, 5,5,5,1]}])", kKeyViews, kKeys);
        return loadScene(folder.write("a.gltf", text), {.noStudio = true, .parameters = parameters});
    }
    Affine placeAt(const std::string& animations, const SceneParameters& parameters) {
        const auto scene = open(animations, parameters);
        EXPECT_TRUE(scene) << scene.error().format();
        return scene ? scene->objects.at(0).objectToWorld : Affine();
    }
    static void expectNear(const Vec3& a, const Vec3& b) {
        EXPECT_LT(glm::length(a - b), 1e-5f) << a.x << " " << a.y << " " << a.z;
    }
};

std::string animation(const char* name, const char* path, int input, int output,
                      const char* interpolation = "LINEAR") {
    return std::string(R"({"name": ")") + name +
           R"(", "channels": [{"sampler": 0, "target": {"node": 0, "path": ")" + path +
           R"("}}], "samplers": [{"input": )" + std::to_string(input) + R"(, "output": )" +
           std::to_string(output) + R"(, "interpolation": ")" + interpolation + R"("}]})";
}

TEST_F(GltfAnimation, NodesStandWhereTheyAreAtATime) {
    const std::string moves = animation("moves", "translation", 3, 4);
    const auto at = [&](const char* time) { return placeAt(moves, {{"time", time}}).translation; };
    expectNear(at("0"), Vec3(0, 0, 0));
    expectNear(at("1.5"), Vec3(1, 0, 0));
    expectNear(at("2"), Vec3(2, 0, 0));
    expectNear(at("3"), Vec3(2, 2, 0));
    expectNear(at("9"), Vec3(2, 4, 0));
    const std::string steps = animation("steps", "translation", 3, 4, "STEP");
    expectNear(placeAt(steps, {{"time", "3.9"}}).translation, Vec3(2, 0, 0));
    expectNear(placeAt(moves, {}).vector({1, 0, 0}), Vec3(1, 0, 0));  // the matrix makes room
    const auto begin = open(moves, {});
    ASSERT_TRUE(begin);
    EXPECT_THAT(begin->notes,
                Contains(HasSubstr("animation 0 \"moves\" of 1, from 1 to 4 s, stands at 1 s")));
}

TEST_F(GltfAnimation, TurnsTakeTheShortWayAndSplinesTheirTangents) {
    const std::string all = animation("moves", "translation", 3, 4) + ", " +
                            animation("turns", "rotation", 3, 5) + ", " +
                            animation("bends", "translation", 7, 8, "CUBICSPLINE");
    const auto turned = [&](const char* time) {
        return placeAt(all, {{"animation", "turns"}, {"time", time}}).vector({1, 0, 0});
    };
    expectNear(turned("1.5"), Vec3(std::sqrt(0.5f), std::sqrt(0.5f), 0));
    expectNear(turned("3"), Vec3(-std::sqrt(0.5f), std::sqrt(0.5f), 0));
    // Half way of a Hermite spline over 2 s from 0, leaving with (1, 0, 0), to 4 at rest: 0 / 2 + 2 * 1 / 8 +
    // 4 / 2.
    expectNear(placeAt(all, {{"animation", "2"}, {"time", "2"}}).translation, Vec3(2.25f, 0, 0));
}

TEST_F(GltfAnimation, WhatIsNotThereIsRefused) {
    const auto errorOf = [&](const std::string& animations, const SceneParameters& parameters) {
        const auto scene = open(animations, parameters);
        return scene ? "no error" : scene.error().format();
    };
    const std::string moves = animation("moves", "translation", 3, 4);
    EXPECT_THAT(errorOf(moves, {{"animation", "runs"}}),
                HasSubstr("there is no animation \"runs\"; the file has moves"));
    EXPECT_THAT(errorOf(moves, {{"time", "late"}}), HasSubstr("time=late: expected seconds"));
    EXPECT_THAT(errorOf(moves, {{"animation", "mover"}}), HasSubstr("(did you mean 'moves'?)"));
}

using GltfVariants = GltfTest;

TEST_F(GltfVariants, OneIsChosen) {
    const std::string text = gltf(
        R"("materials": [{"name": "red"}, {"name": "green"}, {"name": "blue"}], "extensions": {"KHR_materials_variants":
        {"variants": [{"name": "spring"}, {"name": "dusk"}, {"name": "night"}]}})",
        R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 2, "material": 0, "extensions":
        {"KHR_materials_variants": {"mappings": [{"material": 1, "variants": [0]}, {"material": 2, "variants": [1, 2]}]}}}]}])");
    const std::string path = folder.write("a.gltf", text);
    const std::pair<const char*, const char*> kShown[] = {
        {"", "red"}, {"spring", "green"}, {"dusk", "blue"}, {"2", "blue"}};
    for (const auto& [variant, shown] : kShown) {
        LoadOptions options{.noStudio = true};
        if (*variant != '\0') { options.parameters.emplace_back("variant", variant); }
        const auto scene = loadScene(path, options);
        ASSERT_TRUE(scene) << scene.error().format();
        EXPECT_EQ(scene->materials.at(static_cast<size_t>(scene->objects.at(0).material)).name, shown);
        EXPECT_THAT(scene->notes, Contains(HasSubstr("variants spring, dusk or night; shown is")));
    }
    const auto none = loadScene(path, {.parameters = {{"variant", "noon"}}});
    ASSERT_FALSE(none);
    EXPECT_THAT(none.error().format(),
                HasSubstr("there is no variant \"noon\"; the file has spring, dusk or night"));
}

}  // namespace
}  // namespace glint::test
