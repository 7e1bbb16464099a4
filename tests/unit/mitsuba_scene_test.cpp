// Mitsuba's XML: parameters, includes, references, transforms, the camera, the film and the integrator.
#include <cmath>

#include "tests/support/mitsuba_test.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

std::string sphereAt(const std::string& transform) {
    return "<shape type='sphere'><transform name='to_world'>" + transform + "</transform></shape>";
}

class MitsubaScene : public MitsubaTest {
  protected:
    Vec3 placed(const std::string& transform, const Vec3& p) {
        return onlyObject(sphereAt(transform)).objectToWorld.point(p);
    }
    Camera cameraOf(const std::string& sensor) { return load(sensor).camera; }
    RenderOptions optionsOf(const std::string& integrator) { return load(integrator).options; }
};

TEST_F(MitsubaScene, TransformsApplyInTheirOrder) {
    expectNear(placed("<translate x='1'/><scale value='2'/>", Vec3(0.0f)), Vec3(2, 0, 0), 1e-6f);
    expectNear(placed("<scale value='2'/><translate x='1'/>", Vec3(0.0f)), Vec3(1, 0, 0), 1e-6f);
    expectNear(placed("<scale x='2' y='3'/>", Vec3(1.0f)), Vec3(2, 3, 1), 1e-6f);
    expectNear(placed("<rotate z='1' angle='90'/>", Vec3(1, 0, 0)), Vec3(0, 1, 0), 1e-6f);
    expectNear(placed("<rotate value='0,0,2' angle='90'/>", Vec3(1, 0, 0)), Vec3(0, 1, 0), 1e-6f);
    expectNear(placed("<translate value='1, 2 3'/><rotate y='1' angle='90'/>", Vec3(0.0f)), Vec3(3, 2, -1),
               1e-6f);
    expectNear(placed("<matrix value='0 0 1 5  1 0 0 6  0 1 0 7  0 0 0 1'/>", Vec3(1, 2, 3)), Vec3(8, 7, 9),
               1e-6f);
    expectNear(placed("<matrix value='2 0 0 0 3 0 0 0 4'/>", Vec3(1.0f)), Vec3(2, 3, 4), 1e-6f);
}

TEST_F(MitsubaScene, LookAtPointsZAtTheTarget) {
    const std::string look = "<lookat origin='1,2,3' target='1,2,8' up='0,1,0'/>";
    expectNear(placed(look, Vec3(0, 0, 1)), Vec3(1, 2, 4), 1e-6f);
    expectNear(placed(look, Vec3(0, 1, 0)), Vec3(1, 3, 3), 1e-6f);
    expectNear(placed(look, Vec3(1, 0, 0)), Vec3(2, 2, 3), 1e-6f);
    EXPECT_THAT(errorOf(sphereAt("<lookat origin='0,0,0' target='0,1,0' up='0,1,0'/>")),
                HasSubstr("along its up vector"));
}

TEST_F(MitsubaScene, OldNamesAreReadAsNewOnes) {
    const SceneDescription scene = loadText(
        "<scene version='0.5.0'><camera type='perspective'><float name='fov' value='90'/>"
        "<transform name='toWorld'><lookAt origin='0,0,4' target='0,0,0' up='0,1,0'/></transform></camera>"
        "<shape type='sphere'><transform name='toWorld'><translate x='3'/></transform>"
        "<bsdf type='dielectric'><float name='intIOR' value='2'/><float name='extIOR' "
        "value='1'/></bsdf></shape>"
        "</scene>");
    EXPECT_EQ(scene.objects.at(0).objectToWorld.translation, Vec3(3, 0, 0));
    EXPECT_FLOAT_EQ(scene.materials.at(0).ior.value, 2.0f);
    expectNear(scene.camera.position, Vec3(0, 0, 4), 1e-6f);
}

TEST_F(MitsubaScene, ParametersHaveDefaultsThatTheCommandReplaces) {
    const std::string text =
        "<default name='r' value='2'/><default name='radius' value='$r'/>"
        "<shape type='sphere'><float name='radius' value='$radius'/></shape>";
    EXPECT_FLOAT_EQ(load(text).objects.at(0).objectToWorld.linear[0].x, 2.0f);
    EXPECT_FLOAT_EQ(load(text, {.parameters = {{"radius", "5"}}}).objects.at(0).objectToWorld.linear[0].x,
                    5.0f);
    EXPECT_FLOAT_EQ(load(text, {.parameters = {{"r", "3"}}}).objects.at(0).objectToWorld.linear[0].x, 3.0f);
    EXPECT_THAT(load(text, {.parameters = {{"nope", "3"}}}).warnings,
                Contains(HasSubstr("no parameter \"nope\"")));
    EXPECT_THAT(errorOf("<shape type='$what'/>"),
                HasSubstr("bad.xml:2:1: the parameter \"$what\" has no value"));
}

TEST_F(MitsubaScene, IncludesStandWhereTheyAreNamed) {
    folder.write("part.xml",
                 "<scene version='3.0.0'><default name='x' value='7'/>"
                 "<shape type='sphere'><point name='center' x='$x'/></shape></scene>");
    folder.write("one.xml", "<shape type='sphere'><float name='radius' value='$x'/></shape>");
    const SceneDescription scene = load(
        "<default name='x' value='4'/><include filename='part.xml'/>"
        "<include filename='one.xml'/>");
    ASSERT_EQ(scene.objects.size(), 2u);
    EXPECT_EQ(scene.objects[0].objectToWorld.translation, Vec3(4, 0, 0));
    EXPECT_EQ(scene.objects[1].objectToWorld.linear[0].x, 4.0f);
}

TEST_F(MitsubaScene, FilesAreFoundInTheFoldersOfPath) {
    std::filesystem::create_directory(folder.path("meshes"));
    folder.write("meshes/square.obj", kSquareObj);
    const SceneDescription scene = load(
        "<path value='meshes'/><shape type='obj'>"
        "<string name='filename' value='square.obj'/></shape>");
    EXPECT_EQ(scene.meshes.at(0).data->triangleCount(), 2u);
    EXPECT_THAT(errorOf("<shape type='obj'><string name='filename' value='none.obj'/></shape>"),
                HasSubstr("bad.xml:2:1: the file"));
    EXPECT_THAT(
        load("<shape type='sphere'/><shape type='obj'><string name='filename' value='none.obj'/></shape>",
             {.allowMissing = true})
            .warnings,
        Contains(HasSubstr("cannot be read")));
}

TEST_F(MitsubaScene, ReferencesNameObjects) {
    const std::string red = "<bsdf type='diffuse' id='red'><rgb name='reflectance' value='1 0 0'/></bsdf>";
    const SceneDescription scene = load(
        red + "<shape type='sphere'><ref id='red'/></shape><shape type='sphere'><ref id='red'/></shape>");
    ASSERT_EQ(scene.objects.size(), 2u);
    EXPECT_EQ(scene.objects[0].material, scene.objects[1].material);
    EXPECT_EQ(scene.materials.at(0).color.value, Vec3(1, 0, 0));
    EXPECT_EQ(scene.materials.at(0).name, "red");
    EXPECT_THAT(errorOf("<shape type='sphere'><ref id='blue'/></shape>"), HasSubstr("the id \"blue\""));
}

std::string sensor(const std::string& content, const std::string& film = "") {
    return "<sensor type='perspective'><film type='hdrfilm'><integer name='width' value='200'/>"
           "<integer name='height' value='100'/>" +
           film + "</film>" + content + "</sensor>";
}

TEST_F(MitsubaScene, AnglesOfViewAreOfTheirAxis) {
    const auto fov = [this](const std::string& axis) {
        return cameraOf(
                   sensor("<float name='fov' value='90'/><string name='fov_axis' value='" + axis + "'/>"))
            .verticalFovDeg;
    };
    const float half = 2.0f * std::atan(0.5f) * 180.0f / kPi;
    EXPECT_NEAR(fov("x"), half, 1e-3f);
    EXPECT_NEAR(fov("larger"), half, 1e-3f);
    EXPECT_NEAR(fov("y"), 90.0f, 1e-3f);
    EXPECT_NEAR(fov("smaller"), 90.0f, 1e-3f);
    EXPECT_NEAR(fov("diagonal"), 2.0f * std::atan(1.0f / std::sqrt(5.0f)) * 180.0f / kPi, 1e-3f);
    // A square picture of a lens of 50 mm: 43.27 mm along the diagonal.
    const Camera square = cameraOf(
        "<sensor type='perspective'><film type='hdrfilm'><integer name='width' "
        "value='8'/><integer name='height' value='8'/></film></sensor>");
    EXPECT_NEAR(square.verticalFovDeg, 2.0f * std::atan(43.26661f / 100.0f / std::sqrt(2.0f)) * 180.0f / kPi,
                1e-3f);
}

TEST_F(MitsubaScene, CropWindowsAndPrincipalPointsShiftThePicture) {
    const SceneDescription scene = load(
        sensor("<float name='fov' value='90'/><float name='principal_point_offset_x' value='0.1'/><float "
               "name='principal_point_offset_y' value='0.05'/>",
               "<integer name='crop_width' value='50'/><integer name='crop_height' value='40'/><integer "
               "name='crop_offset_x' value='30'/><integer name='crop_offset_y' value='10'/>"));
    EXPECT_THAT(scene.warnings, testing::Not(Contains(HasSubstr("approximated"))));
    EXPECT_EQ(scene.resolution, (Resolution{50, 40}));
    // 40 of 200 pixels; the window's middle is 45 pixels left of and 20 above the picture's, and the
    // principal point puts 20 right of and 5 below it in the picture's middle.
    EXPECT_NEAR(scene.camera.verticalFovDeg, 2.0f * std::atan(0.2f) * 180.0f / kPi, 1e-4f);
    EXPECT_NEAR(scene.camera.shift.x, (-45.0f + 20.0f) / 40.0f, 1e-6f);
    EXPECT_NEAR(scene.camera.shift.y, (20.0f - 5.0f) / 40.0f, 1e-6f);
    EXPECT_THAT(errorOf(sensor("", "<integer name='crop_offset_x' value='10'/>")),
                HasSubstr("reaches beyond the picture of 200 x 100"));
}

TEST_F(MitsubaScene, OrthographicPicturesAreTwoUnitsWide) {
    const SceneDescription scene = load(
        "<sensor type='orthographic'><transform name='to_world'><scale x='3' y='3'/><lookat origin='1,2,9' "
        "target='1,2,0' up='0,1,0'/></transform><film type='hdrfilm'><integer name='width' value='200'/>"
        "<integer name='height' value='100'/><integer name='crop_width' value='100'/><integer "
        "name='crop_height' value='50'/></film></sensor>");
    EXPECT_THAT(scene.warnings, testing::Not(Contains(HasSubstr("approximated"))));
    const Camera& camera = scene.camera;
    EXPECT_EQ(camera.kind, ProjectionKind::Orthographic);
    EXPECT_NEAR(camera.viewHeight, 1.5f, 1e-5f) << "6 m are 200 pixels, of which 50 are seen";
    EXPECT_NEAR(camera.shift.x, -1.0f, 1e-6f);
    EXPECT_NEAR(camera.shift.y, 0.5f, 1e-6f);
    EXPECT_EQ(camera.horizontalScale, 1.0f);
    EXPECT_EQ(camera.position, Vec3(1, 2, 9));
    EXPECT_EQ(camera.target, Vec3(1, 2, 0));
}

TEST_F(MitsubaScene, CamerasLookAlongZ) {
    const Camera camera = cameraOf(
        "<sensor type='thinlens'><float name='aperture_radius' value='0.5'/><float name='focus_distance' "
        "value='3'/><transform name='to_world'><lookat origin='1,0,0' target='1,0,-1' "
        "up='0,1,0'/></transform>"
        "</sensor>");
    expectNear(camera.position, Vec3(1, 0, 0), 1e-6f);
    EXPECT_EQ(camera.target, Vec3(1, 0, -1));
    expectNear(camera.up, Vec3(0, 1, 0), 1e-6f);
    EXPECT_FLOAT_EQ(camera.apertureDiameter, 1.0f);
    EXPECT_FLOAT_EQ(camera.focalDistance, 3.0f);
}

/// As old exporters write them.
TEST_F(MitsubaScene, ACameraThatMirrorsMirrorsTheScene) {
    const SceneDescription scene = load(
        "<shape type='sphere'><point name='center' x='1' y='2' z='3'/></shape>"
        "<emitter type='point'><point name='position' x='4'/></emitter>"
        "<emitter type='directional'><vector name='direction' x='1'/></emitter>"
        "<sensor type='perspective'><transform name='to_world'><scale x='-1'/><lookat origin='0,0,9' "
        "target='0,0,0' up='0,1,0'/></transform></sensor>");
    expectNear(scene.objects.at(0).objectToWorld.translation, Vec3(-1, 2, 3), 1e-5f);
    expectNear(scene.lights.at(0).position, Vec3(-4, 0, 0), 1e-5f);
    expectNear(scene.lights.at(1).direction, Vec3(-1, 0, 0), 1e-5f);
    expectNear(scene.camera.position, Vec3(0, 0, 9), 1e-6f);
    expectNear(glm::normalize(scene.camera.target - scene.camera.position), Vec3(0, 0, -1), 1e-5f);
}

TEST_F(MitsubaScene, FilmsHaveSizesAndFilters) {
    SceneDescription scene = load(sensor("", "<rfilter type='box'/>"));
    EXPECT_EQ(scene.resolution, (Resolution{200, 100}));
    EXPECT_EQ(scene.options.filter, FilterKind::Box);
    EXPECT_FLOAT_EQ(scene.options.filterRadius, 0.5f);
    scene = load(sensor(""));
    EXPECT_EQ(scene.options.filter, FilterKind::Gaussian);
    EXPECT_FLOAT_EQ(scene.options.filterRadius, 1.5f);
    scene = load(sensor("", "<rfilter type='lanczos'/>"));
    EXPECT_THAT(scene.warnings, Contains(HasSubstr("approximated: the reconstruction filter")));
    EXPECT_EQ(load("<sensor type='perspective'/>").resolution, (Resolution{768, 576}));
}

/// Mitsuba counts edges: 1 is what the camera sees shine, which takes no scattering.
TEST_F(MitsubaScene, DepthsCountScatteringEvents) {
    const auto depth = [this](const std::string& type, const std::string& value) {
        return optionsOf("<integrator type='" + type + "'><integer name='max_depth' value='" + value +
                         "'/></integrator>")
            .maxDepth;
    };
    EXPECT_EQ(depth("path", "1"), 0);
    EXPECT_EQ(depth("path", "2"), 1);
    EXPECT_EQ(depth("path", "8"), 7);
    EXPECT_EQ(depth("path", "0"), 0);
    EXPECT_EQ(depth("path", "-1"), 1024);
    EXPECT_EQ(optionsOf("<integrator type='direct'/>").maxDepth, 1);
    const RenderOptions inner = optionsOf(
        "<integrator type='moment'><integrator type='path'><integer "
        "name='max_depth' value='3'/></integrator></integrator>");
    EXPECT_EQ(inner.maxDepth, 2);
    const SceneDescription photons = load(
        "<integrator type='sppm'><float name='initial_radius' value='0.5'/><integer name='photon_count' "
        "value='1000'/></integrator>");
    EXPECT_EQ(photons.options.integrator, IntegratorKind::Sppm);
    EXPECT_EQ(photons.sppm.radiusWorld, 0.5f);
    EXPECT_EQ(photons.sppm.photonsPerPass, 1000u);
}

TEST_F(MitsubaScene, PartsOfScenesAreLitAndSeen) {
    const auto scene = loadScene(folder.write("part.xml", sceneText("<shape type='sphere'/>")));
    ASSERT_TRUE(scene) << scene.error().format();
    EXPECT_TRUE(validateScene(*scene, EditKind::Everything));
    ASSERT_GE(scene->environment.image, 0);
    EXPECT_TRUE(scene->environmentImages[static_cast<size_t>(scene->environment.image)].isRead());
}

TEST_F(MitsubaScene, WhatIsLeftOutIsSaid) {
    const SceneDescription scene = load(
        "<shape type='sphere'><float name='wobble' value='1'/><medium name='interior' "
        "type='homogeneous'/></shape><film type='x'/>");
    EXPECT_THAT(scene.warnings, Contains(HasSubstr("a.xml:2: \"wobble\" of shape \"sphere\" is left out")));
    EXPECT_THAT(scene.warnings, Contains(HasSubstr("media are left out")));
    EXPECT_THAT(scene.warnings, Contains(HasSubstr("<film> of the scene is left out")));
}

TEST_F(MitsubaScene, AnimationsStandAsAtTheirFirstTime) {
    const SceneDescription scene = load(
        "<shape type='sphere'><animation name='toWorld'><transform time='0'><translate x='2'/></transform>"
        "<transform time='1'><translate x='7'/></transform></animation></shape>");
    EXPECT_EQ(scene.objects.at(0).objectToWorld.translation, Vec3(2, 0, 0));
    EXPECT_THAT(scene.warnings, Contains(HasSubstr("as at their first time")));
}

}  // namespace
}  // namespace glint::test
