// Mitsuba's shapes and emitters as Glint's objects and lights.
#include <cmath>

#include "engine/io/mitsuba_environment.h"
#include "engine/io/mitsuba_normals.h"
#include "engine/io/mitsuba_serialized.h"
#include "tests/support/mitsuba_files.h"
#include "tests/support/mitsuba_test.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr const char* kTwoSided = "<bsdf type='twosided'><bsdf type='diffuse'/></bsdf>";

class MitsubaShapesTest : public MitsubaTest {
  protected:
    std::shared_ptr<const MeshData> meshOf(const std::string& type, const std::string& file,
                                           const std::string& content = "") {
        const SceneDescription scene = load("<shape type='" + type + "'><string name='filename' value='" +
                                            file + "'/>" + content + kTwoSided + "</shape>");
        warnings = scene.warnings;
        return scene.meshes.empty() ? std::make_shared<const MeshData>() : scene.meshes[0].data;
    }
};

TEST_F(MitsubaShapesTest, SpheresAndFlatShapesHaveTheirPlaces) {
    const Object sphere = onlyObject(
        "<shape type='sphere'><point name='center' x='1' y='2' z='3'/><float "
        "name='radius' value='2'/><transform name='to_world'><scale "
        "value='10'/></transform></shape>");
    EXPECT_EQ(sphere.shape, ShapeKind::Sphere);
    EXPECT_EQ(sphere.objectToWorld.translation, Vec3(10, 20, 30));
    EXPECT_EQ(sphere.objectToWorld.linear[1].y, 20.0f);
    EXPECT_EQ(onlyObject("<shape type='disk'/>").shape, ShapeKind::Disc);
    EXPECT_EQ(onlyObject("<shape type='rectangle'/>").shape, ShapeKind::Rectangle);
    const Object turned =
        onlyObject("<shape type='rectangle'><boolean name='flip_normals' value='true'/></shape>");
    EXPECT_EQ(turned.objectToWorld.linear[2], Vec3(0, 0, -1));
}

TEST_F(MitsubaShapesTest, CylindersRunFromPointToPoint) {
    const Object cylinder = onlyObject(
        "<shape type='cylinder'><point name='p0' x='1' y='0' z='0'/><point name='p1' "
        "x='1' y='0' z='4'/><float name='radius' value='0.5'/></shape>");
    EXPECT_EQ(cylinder.shape, ShapeKind::Revolved);
    ASSERT_EQ(cylinder.profile.size(), 2u);
    EXPECT_EQ(cylinder.profile[1], Vec2(0.5f, 4.0f));
    expectNear(cylinder.objectToWorld.point(Vec3(0, 4, 0)), Vec3(1, 0, 4), 1e-6f);
    EXPECT_GT(cylinder.objectToWorld.determinant(), 0.0f);
}

TEST_F(MitsubaShapesTest, CubesFaceOutwards) {
    const SceneDescription scene = load("<shape type='cube'/><shape type='cube'/>");
    ASSERT_EQ(scene.meshes.size(), 1u);
    const MeshData& cube = *scene.meshes[0].data;
    EXPECT_EQ(cube.triangleCount(), 12u);
    EXPECT_FALSE(isOpenMesh(cube));
    for (size_t i = 0; i < cube.indices.size(); i += 3) {
        const Vec3 &a = cube.positions[cube.indices[i]], &b = cube.positions[cube.indices[i + 1]],
                   &c = cube.positions[cube.indices[i + 2]];
        EXPECT_GT(glm::dot(glm::cross(b - a, c - a), a), 0.0f);
        EXPECT_EQ(glm::normalize(glm::cross(b - a, c - a)), cube.normals[cube.indices[i]]);
    }
}

/// Surfaces that are not two-sided reflect on their front alone.
TEST_F(MitsubaShapesTest, OpenOneSidedShapesHaveABlackBack) {
    folder.write("square.obj", kSquareObj);
    const std::string obj = "<shape type='obj'><string name='filename' value='square.obj'/>";
    for (const std::string& shape : {std::string("<shape type='rectangle'>"), obj}) {
        const SceneDescription scene = load(shape + "</shape>");
        ASSERT_EQ(scene.objects.size(), 2u);
        EXPECT_TRUE(scene.objects[0].frontOnly && scene.objects[1].frontOnly);
        EXPECT_EQ(scene.materials[static_cast<size_t>(scene.objects[1].material)].color.value, Vec3(0.0f));
        EXPECT_EQ(load(shape + kTwoSided + "</shape>").objects.size(), 1u);
        EXPECT_EQ(load(shape + "<bsdf type='dielectric'/></shape>").objects.size(), 1u);
    }
    EXPECT_EQ(load("<shape type='sphere'/>").objects.size(), 1u);
}

/// Two squares that meet at a right angle and share the corners of their edge.
constexpr const char* kBentObj =
    "v 0 0 0\nv 0 1 0\nv 1 1 0\nv 1 0 0\nv 0 1 1\nv 0 0 1\nf 4 3 2 1\nf 1 2 5 6\n";

TEST_F(MitsubaShapesTest, NormalsFollowTheShape) {
    folder.write("bent.obj", kBentObj);
    const auto isSmooth = [](const MeshData& mesh) {
        return std::ranges::any_of(mesh.normals,
                                   [](const Vec3& n) { return std::fabs(n.x) > 0.1f && n.z > 0.1f; });
    };
    EXPECT_TRUE(isSmooth(*meshOf("obj", "bent.obj")));
    EXPECT_TRUE(meshOf("obj", "bent.obj", "<boolean name='face_normals' value='true'/>")->normals.empty());
    EXPECT_TRUE(isSmooth(*meshOf("obj", "bent.obj", "<float name='max_smooth_angle' value='100'/>")));
    EXPECT_FALSE(isSmooth(*meshOf("obj", "bent.obj", "<float name='max_smooth_angle' value='60'/>")));
    const auto plain = meshOf("obj", "bent.obj");
    const auto flipped = meshOf("obj", "bent.obj", "<boolean name='flip_normals' value='true'/>");
    EXPECT_EQ(flipped->indices[1], plain->indices[2]);
    EXPECT_EQ(flipped->normals[0], -plain->normals[0]);
    // A mirror turns computed normals to its other side, as in Mitsuba.
    const auto mirrored = meshOf("obj", "bent.obj", "<transform name='to_world'><scale x='-1'/></transform>");
    EXPECT_EQ(mirrored->indices[1], plain->indices[2]);
}

TEST_F(MitsubaShapesTest, FilesWithNormalsStayFiles) {
    folder.write("n.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n");
    const SceneDescription scene = load("<shape type='obj'><string name='filename' value='n.obj'/></shape>");
    EXPECT_EQ(pathOf(scene.meshes.at(0).source), "n.obj");
    EXPECT_TRUE(scene.meshes[0].data);
}

TEST_F(MitsubaShapesTest, GroupsArePlacedByInstances) {
    const SceneDescription scene = load(
        "<shape type='shapegroup' id='g'><shape type='sphere'><point name='center' x='1'/></shape>"
        "<shape type='sphere'/></shape>"
        "<shape type='instance'><ref id='g'/></shape><shape type='instance'><ref id='g'/><transform "
        "name='to_world'><scale value='2'/><translate y='5'/></transform></shape>");
    ASSERT_EQ(scene.objects.size(), 4u);
    EXPECT_EQ(scene.objects[0].objectToWorld.translation, Vec3(1, 0, 0));
    EXPECT_EQ(scene.objects[2].objectToWorld.translation, Vec3(2, 5, 0));
}

TEST_F(MitsubaShapesTest, ShapesShine) {
    const SceneDescription scene = load(
        "<shape type='sphere'><emitter type='area'><rgb name='radiance' "
        "value='1 2 3'/></emitter></shape><shape type='sphere'/>");
    const auto materialOfObject = [&](size_t i) {
        return scene.materials[static_cast<size_t>(scene.objects.at(i).material)];
    };
    EXPECT_EQ(materialOfObject(0).emission.value, Vec3(1, 2, 3));
    EXPECT_FALSE(materialOfObject(0).emitsBothSides);
    EXPECT_FALSE(materialOfObject(1).emissive());
}

TEST_F(MitsubaShapesTest, AttributesOfMeshesAreColours) {
    const auto colors = [this](const std::string& properties, const std::string& faces,
                               const std::string& name, const std::string& bsdf) {
        folder.write("a.ply",
                     "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                     "property float z\n" +
                         properties +
                         "element face 1\nproperty list uchar int "
                         "vertex_indices\n" +
                         faces + "end_header\n" +
                         (properties.empty() ? "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 0.25\n"
                                             : "0 0 0 1 0 0\n1 0 0 0 0.5 0\n0 1 0 0 0 1\n3 0 1 2\n"));
        const std::string texture =
            "<texture type='mesh_attribute'><string name='name' value='" + name + "'/></texture>";
        const SceneDescription scene = load(
            "<texture type='mesh_attribute' id='t'><string name='name' value='" + name +
            "'/></texture><shape type='ply'><string name='filename' value='a.ply'/>" + bsdf + "</shape>");
        return scene.meshes.at(0).data->colors;
    };
    const std::string properties = "property float color_0\nproperty float color_1\nproperty float color_2\n";
    const auto vertices = colors(properties, "", "vertex_color",
                                 "<bsdf type='diffuse'><ref name='reflectance' id='t'/></bsdf>");
    ASSERT_EQ(vertices.size(), 3u);
    EXPECT_EQ(vertices[1], Vec3(0, 0.5f, 0));
    const auto faces = colors("", "property float weight_0\n", "face_weight",
                              "<bsdf type='blendbsdf'><ref name='weight' id='t'/><bsdf type='diffuse'><rgb "
                              "name='reflectance' value='1 0 0'/></bsdf><bsdf type='diffuse'><rgb "
                              "name='reflectance' value='0 1 0'/></bsdf></bsdf>");
    ASSERT_EQ(faces.size(), 3u);
    EXPECT_EQ(faces[0], Vec3(0.75f, 0.25f, 0));
}

TEST_F(MitsubaShapesTest, SerializedMeshesOfBothVersionsAreRead) {
    folder.write("three.serialized", serializedFile(3, {serializedTriangle<float>(0x1003, "", 1.0f)}));
    folder.write("four.serialized",
                 serializedFile(4, {serializedTriangle<float>(0x1003, std::string("one\0", 4), 1.0f),
                                    serializedTriangle<double>(0x2003, std::string("two\0", 4), 2.0f)}));
    const auto three = meshOf("serialized", "three.serialized");
    ASSERT_EQ(three->triangleCount(), 1u);
    EXPECT_EQ(three->positions[1], Vec3(1, 0, 0));
    EXPECT_EQ(three->normals[0], Vec3(0, 0, 1));
    EXPECT_EQ(three->uvs[1], Vec2(1, 0));
    const auto four = meshOf("serialized", "four.serialized", "<integer name='shape_index' value='1'/>");
    EXPECT_EQ(four->positions[1], Vec3(2, 0, 0));
}

TEST_F(MitsubaShapesTest, BrokenSerializedMeshesAreRefused) {
    const std::string good =
        serializedFile(4, {serializedTriangle<float>(0x1003, std::string("\0", 1), 1.0f)});
    const auto messageOf = [](const std::string& bytes, int number = 0) {
        const auto mesh = parseSerialized(bytes, "a.serialized", number);
        return mesh ? std::string("none") : mesh.error().format();
    };
    EXPECT_EQ(messageOf(good), "none");
    EXPECT_THAT(messageOf(good, 1), HasSubstr("has 1 meshes; there is no mesh 1"));
    EXPECT_THAT(messageOf("abcdefghijk"), HasSubstr("no serialized Mitsuba mesh"));
    EXPECT_THAT(messageOf(std::string(good).replace(2, 1, "\x09")), HasSubstr("version 9"));
    EXPECT_THAT(messageOf(good.substr(0, 20) + good.substr(good.size() - 12)), HasSubstr("cut off"));
    const std::string index = serializedTriangle<float>(0x1003, std::string("\0", 1), 1.0f);
    EXPECT_THAT(messageOf(serializedFile(4, {std::string(index).replace(index.size() - 4, 1, "\x07")})),
                HasSubstr("there is no vertex 7"));
    EXPECT_THAT(
        messageOf(serializedFile(4, {std::string(index).replace(5, 8, packed<uint64_t>({1ull << 40}))})),
        HasSubstr("there cannot be"));
    EXPECT_THAT(
        messageOf(serializedFile(4, {std::string(index).replace(5, 8, packed<uint64_t>({1ull << 25}))})),
        HasSubstr("cut off"));
}

TEST_F(MitsubaShapesTest, LightsHaveTheirPlaces) {
    const SceneDescription scene = load(
        "<emitter type='point'><point name='position' x='1'/><rgb name='intensity' value='3'/></emitter>"
        "<emitter type='spot'><transform name='to_world'><lookat origin='0,5,0' target='0,0,0' up='1,0,0'/>"
        "</transform><float name='cutoff_angle' value='40'/><float name='beam_width' value='40'/></emitter>"
        "<emitter type='directional'><vector name='direction' x='1'/><rgb name='irradiance' "
        "value='2'/></emitter>"
        "<shape type='sphere'/>");
    ASSERT_EQ(scene.lights.size(), 3u);
    EXPECT_EQ(scene.lights[0].position, Vec3(1, 0, 0));
    EXPECT_EQ(scene.lights[0].color, Vec3(3.0f));
    expectNear(scene.lights[1].direction, Vec3(0, -1, 0), 1e-6f);
    EXPECT_EQ(scene.lights[1].coneAngleDeg, 40.0f);
    EXPECT_EQ(scene.lights[2].direction, Vec3(1, 0, 0));
}

TEST(MitsubaEnvironment, MapsAreTurnedAndLaidOutAnew) {
    EXPECT_NEAR(*turnAboutY(rotate(Vec3(0, 1, 0), 0.5f)), 0.5f * 180.0f / kPi, 1e-3f);
    EXPECT_FALSE(turnAboutY(rotate(Vec3(1, 0, 0), 0.5f)));
    ImageF map{8, 5, {}};
    for (int y = 0; y < map.height; ++y) {
        map.rgb.insert(map.rgb.end(), 24, static_cast<float>(y));
    }
    // Row 0 is at the pole, row 4 at the other one: the value is 4 theta / pi.
    const ImageF rows = withCentredRows(map);
    EXPECT_EQ(rows.height, 10);
    EXPECT_NEAR(rows.rgb[0], 4.0f * 0.05f, 1e-5f);
    EXPECT_NEAR(rows.rgb[9 * 24], 4.0f * 0.95f, 1e-5f);
    // Turned over, bottom up.
    const ImageF turned = turnedMap(map, rotate(Vec3(1, 0, 0), kPi), true);
    EXPECT_NEAR(turned.rgb[0], 4.0f * 0.95f, 1e-4f);
}

}  // namespace
}  // namespace glint::test
