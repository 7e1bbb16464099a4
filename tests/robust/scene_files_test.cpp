// Files that are no scenes, and files that a scene names and that are missing: what is said of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "engine/io/scene_loader.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::TempFolder;
using testing::HasSubstr;

TEST(SceneFiles, FilesThatAreNoScenesAreNamed) {
    const TempFolder folder;
    EXPECT_THAT(loadScene(folder.write("scene.xyz", "\x01\x02\x03")).error().format(),
                HasSubstr("expected Glint JSON (.json)"));
    EXPECT_THAT(loadScene(folder.path("none.json")).error().format(), HasSubstr("no such file"));
    EXPECT_THAT(loadScene(folder.path()).error().format(), HasSubstr("is a folder"));
    EXPECT_THAT(loadScene("").error().format(), HasSubstr("no such file"));
}

TEST(SceneFiles, PipesAreRefusedWithoutWaitingForAWriter) {
    const TempFolder folder;
    for (const char* const name : {"pipe", "pipe.json", "pipe.txt", "pipe.obj", "pipe.ply"}) {
        const std::string pipe = folder.path(name);
        ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
        const auto scene = loadScene(pipe);
        ASSERT_FALSE(scene) << name;
        EXPECT_THAT(scene.error().format(), HasSubstr(pipe + ": is a pipe; expected a scene file"));
    }
}

TEST(SceneFiles, APipeInPlaceOfAMeshIsRefused) {
    const TempFolder folder;
    ASSERT_EQ(::mkfifo(folder.path("pipe.obj").c_str(), 0600), 0);
    const auto scene = loadScene(folder.write("scene.txt", R"(Materials { numMaterials 1 Material { } }
        Group { numObjects 1 TriangleMesh { obj_file pipe.obj } })"));
    ASSERT_FALSE(scene);
    EXPECT_THAT(scene.error().format(), HasSubstr("is a pipe"));
}

TEST(SceneFiles, ContentDecidesWhereTheNameSaysNothing) {
    const TempFolder folder;
    EXPECT_TRUE(loadScene(folder.write("scene", "// a comment\n{\"glint\": 1}")));
    EXPECT_TRUE(loadScene(folder.write("scene.scn", "Background { color 1 1 1 }")));
    EXPECT_TRUE(loadScene(folder.write("c", "/* a */ // b\n /* c */{\"glint\": 1}")));
    const auto model =
        loadScene(folder.write("model.obj", "// no comment of OBJ's\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    ASSERT_TRUE(model) << model.error().format();
    EXPECT_THAT(model->warnings, testing::ElementsAre(HasSubstr("no statement of the OBJ format")));
}

TEST(SceneFiles, ParametersThatNothingLooksAtAreSaid) {
    const TempFolder folder;
    const std::string path = folder.write("a.json", R"({"glint": 1, "environment": {"color": 1}})");
    const auto scene = loadScene(path, {.parameters = {{"camera.fov", "40"}}});
    ASSERT_TRUE(scene) << scene.error().format();
    EXPECT_THAT(scene->warnings,
                testing::ElementsAre(HasSubstr("Glint JSON has no parameters; \"camera.fov\" sets nothing")));
    EXPECT_THAT(loadScene(path)->warnings, testing::IsEmpty());
    EXPECT_FALSE(loadScene(path, {.strict = true, .parameters = {{"a", "b"}}}));
}

TEST(SceneFiles, MissingFilesOfATextAreOneWarningOfEachKind) {
    std::string materials = "Materials { numMaterials 50\n", objects = "Group { numObjects 100\n";
    for (int i = 0; i < 50; ++i) {
        materials += "Material { texture none" + std::to_string(i) + ".png }\n";
        objects += "MaterialIndex " + std::to_string(i) + " Sphere { center " + std::to_string(3 * i) +
                   " 0 0 radius 1 }\n";
        objects += "TriangleMesh { obj_file none" + std::to_string(i) + ".obj }\n";
    }
    const TempFolder folder;
    const std::string path = folder.write("many.txt", materials + "}\n" + objects + "}");
    EXPECT_FALSE(loadScene(path, {.strict = true}));
    const auto scene = loadScene(path);
    ASSERT_TRUE(scene) << scene.error().format();
    EXPECT_THAT(scene->warnings,
                testing::ElementsAre(
                    HasSubstr("many.txt:55: meshes are missing and left out: \"none0.obj\" (and 49 more)"),
                    testing::AllOf(HasSubstr("many.txt:2: textures are missing"),
                                   HasSubstr("\"none0.png\" (and 49 more)"))));
}

TEST(SceneFiles, WarningsAreBoundedHoweverManyFilesNeedOne) {
    const TempFolder folder;
    std::string objects;
    for (int i = 0; i < 100; ++i) {
        const std::string name = std::to_string(i) + ".obj";
        folder.write(name, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2\n");
        objects += std::string(i > 0 ? "," : "") + R"({"type":"mesh","material":"m","mesh":{"file":")" +
                   name + R"("}})";
    }
    const auto scene = loadScene(folder.write("many.json", R"({"glint":1,"environment":{"color":1},
        "materials":{"m":{"type":"diffuse"}},"objects":[)" + objects +
                                                               "]}"));
    ASSERT_TRUE(scene) << scene.error().format();
    EXPECT_EQ(scene->warnings.size(), 40u);
    EXPECT_EQ(scene->warnings.back(), "and 61 more like these");
}

TEST(SceneFiles, WhereNothingShinesTheMessageNamesWhatWouldInThatFormat) {
    const TempFolder folder;
    const auto warningsOf = [&](const std::string& name, const std::string& text) {
        const auto scene = loadScene(folder.write(name, text));
        EXPECT_TRUE(scene) << scene.error().format();
        return scene ? scene->warnings : std::vector<std::string>();
    };
    const std::string ball = "Group { numObjects 1 Sphere { center 0 0 0 radius 1 } }";
    EXPECT_THAT(warningsOf("dark.txt", "Background { color 0 0 0 }\n" + ball),
                testing::ElementsAre(HasSubstr("a Lights block, or a Background that is not black")));
    EXPECT_THAT(warningsOf("lit.txt", ball), testing::IsEmpty());
    // The material that shines is on no object, and the light is switched off.
    EXPECT_THAT(warningsOf("dark.json", R"({"glint":1,"materials":{"a":{"type":"diffuse"},
        "b":{"type":"diffuse","emission":1}},"lights":[{"type":"point","position":[0,0,9],"intensity":0}],
        "objects":[{"type":"sphere","material":"a"}]})"),
                testing::ElementsAre(HasSubstr("\"lights\", or an \"environment\" that is not black")));
    EXPECT_THAT(warningsOf("lit.json", R"({"glint":1,"materials":{"b":{"type":"diffuse","emission":1}},
        "objects":[{"type":"sphere","material":"b"}]})"),
                testing::IsEmpty());
}

TEST(SceneFiles, MissingFilesAreWarningsWhenAllowed) {
    const TempFolder folder;
    const std::string path = folder.write("scene.json", R"({"glint": 1, "materials": {"m": {"type": "diffuse",
                  "color": {"texture": {"file": "a.png"}, "fallback": [0.1, 0.2, 0.3]}}},
               "objects": [{"type": "sphere", "material": "m"},
                           {"type": "mesh", "material": "m", "mesh": {"file": "a.ply"}}],
               "environment": {"image": {"file": "a.exr"}}})");
    EXPECT_FALSE(loadScene(path));
    const auto loaded = loadScene(path, {.allowMissing = true});
    ASSERT_TRUE(loaded.ok()) << loaded.error().format();
    EXPECT_THAT(loaded->warnings,
                testing::ElementsAre(HasSubstr("files are missing and left out: \"a.ply\" (and 2 more)")));
    EXPECT_EQ(loaded->materials.at(0).color.texture, -1);
    EXPECT_EQ(loaded->materials[0].color.value, Vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(loaded->objects.size(), 1u) << "the sphere";
    EXPECT_EQ(loaded->environment.image, -1);
}

}  // namespace
}  // namespace glint
