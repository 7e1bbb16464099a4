// Portals of environments in Glint's own scenes, in pbrt's and in exports: which side is lit, what is kept,
// and what is no portal.
#include "engine/io/exporter.h"
#include "engine/io/image_io.h"
#include "engine/io/scene_json.h"
#include "engine/scene/scene_hash.h"
#include "tests/support/pbrt_test.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class PortalFiles : public PbrtTest {
  protected:
    PortalFiles() {
        EXPECT_TRUE(saveHdr(folder.path("sky.hdr"), {8, 8, std::vector<float>(size_t{3} * 64, 0.25f)}));
    }
    static std::string json(const std::string& portal) {
        return R"({"glint": 1, "objects": [{"type": "sphere", "center": [0, 0, 0], "radius": 1, "material": {"type": "diffuse"}}], "environment": {"color": 2, "portal": )" +
               portal + "}}";
    }
    std::string jsonError(const std::string& portal) {
        const auto scene = loadScene(folder.write("bad.json", json(portal)));
        return scene ? "no error" : scene.error().format();
    }
    /// Where the portal's light goes.
    static Vec3 lightOf(const SceneDescription& scene) {
        const std::vector<Vec3>& c = scene.environment.portal;
        EXPECT_EQ(c.size(), 4u);
        return c.size() == 4 ? glm::normalize(glm::cross(c[1] - c[0], c[3] - c[0])) : Vec3(0.0f);
    }
};

TEST_F(PortalFiles, JsonHasFourCorners) {
    const auto scene =
        loadScene(folder.write("a.json", json("[[0, 2, 0], [1, 2, 0], [1, 2, 3], [0, 2, 3]]")));
    ASSERT_TRUE(scene) << scene.error().format();
    EXPECT_EQ(lightOf(*scene), Vec3(0, -1, 0));
    ASSERT_TRUE(saveSceneJson(*scene, folder.path("out.json")));
    const auto opened = loadScene(folder.path("out.json"));
    ASSERT_TRUE(opened) << opened.error().format();
    EXPECT_EQ(opened->environment.portal, scene->environment.portal);
    SceneDescription open = *scene;
    open.environment.portal.clear();
    EXPECT_NE(sceneHash(open), sceneHash(*scene)) << "the picture depends on it";
    EXPECT_THAT(jsonError("[[0, 2, 0], [1, 2, 0], [1, 2, 3]]"), HasSubstr("bad.json:1:"));
    EXPECT_THAT(jsonError("[[0, 2, 0], [1, 2, 0], [1, 2, 3]]"), HasSubstr("expected its four corners"));
    EXPECT_THAT(jsonError("[[0, 2, 0], [1, 2, 0], [1, 2.1, 3], [0, 2, 3]]"), HasSubstr("no rectangle"));
    EXPECT_THAT(jsonError("[[0, 2, 0], [1, 2, 3], [1, 2, 0], [0, 2, 3]]"), HasSubstr("no rectangle"));
    EXPECT_THAT(jsonError("[[0, 2, 0], [0, 2, 0], [1, 2, 0], [1, 2, 0]]"), HasSubstr("no rectangle"));
    EXPECT_THAT(jsonError("[0, 2, 0]"), HasSubstr("bad.json:1:"));
}

/// pbrt's portals stand in the world, whatever transform the light has; their light goes against the cross
/// product of the last edge and the first.
TEST_F(PortalFiles, PbrtsFaceTheSameWay) {
    const std::string light =
        "Translate 5 5 5 Rotate 90 1 0 0 LightSource \"infinite\" \"string filename\" \"sky.hdr\" \"point3 "
        "portal\" "
        "[0 0 0 1 0 0 1 1 0 0 1 0]";
    const SceneDescription scene = load(light);
    EXPECT_THAT(scene.warnings, Not(Contains(HasSubstr("portal"))));
    EXPECT_EQ(lightOf(scene), Vec3(0, 0, 1));
    EXPECT_EQ(scene.environment.portal[0], Vec3(0, 0, 0));
    EXPECT_EQ(scene.environment.portal[2], Vec3(1, 1, 0));
    const SceneDescription mirrored =
        loadText(sceneText(light, "LookAt 0 0 5  0 0 0  0 1 0 Camera \"perspective\" "));
    EXPECT_EQ(lightOf(mirrored), Vec3(0, 0, 1));
    EXPECT_EQ(mirrored.environment.portal[2], Vec3(-1, 1, 0));
    EXPECT_THAT(
        errorOf("LightSource \"infinite\" \"string filename\" \"sky.hdr\" \"point3 portal\" [0 0 0 1 0 0 1 "
                "2 0 0 1 0]"),
        HasSubstr("no rectangle"));
    EXPECT_THAT(errorOf("LightSource \"infinite\" \"point3 portal\" [0 0 0 1 0 0]"),
                HasSubstr("no rectangle"));
}

TEST_F(PortalFiles, ExportsKeepThem) {
    SceneDescription scene = load(
        "LightSource \"infinite\" \"string filename\" \"sky.hdr\" \"point3 portal\" "
        "[0 0 2 1 0 2 1 1 2 0 1 2] Shape \"sphere\"");
    std::vector<std::string> said;
    ASSERT_TRUE(exporterOf("out.pbrt")->save(scene, folder.path("out.pbrt"), &said));
    const auto opened = loadScene(folder.path("out.pbrt"));
    ASSERT_TRUE(opened) << opened.error().format();
    EXPECT_EQ(opened->environment.portal, scene.environment.portal);
    // pbrt has no portals without an image.
    scene.environment.image = -1;
    scene.environment.color = Vec3(1, 2, 3);
    ASSERT_TRUE(exporterOf("out.pbrt")->save(scene, folder.path("even.pbrt"), &said));
    const auto even = loadScene(folder.path("even.pbrt"));
    ASSERT_TRUE(even) << even.error().format();
    EXPECT_EQ(even->environment.portal, scene.environment.portal);
    ASSERT_EQ(even->environment.image, 0);
    const std::vector<float>& rgb = even->environmentImages[0].floats->rgb;
    expectNear(Vec3(rgb[0], rgb[1], rgb[2]), Vec3(1, 2, 3), 1e-5f);
    said.clear();
    ASSERT_TRUE(exporterOf("out.xml")->save(scene, folder.path("out.xml"), &said));
    EXPECT_THAT(said, Contains(HasSubstr("not through their portals alone")));
}

}  // namespace
}  // namespace glint::test
