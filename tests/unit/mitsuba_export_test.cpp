// Scenes written as Mitsuba XML: opened again they show the same picture, bit for bit where nothing
// is approximated.
#include "tests/support/export_test.h"
#include "tests/support/mitsuba_test.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

class MitsubaExport : public ExportTest<MitsubaTest> {
  protected:
    MitsubaExport() : ExportTest("out.xml") {}
};

TEST_F(MitsubaExport, GlintScenesKeepTheirBits) {
    expectSamePicture(repositoryScene("cornell.json"));
    expectSamePicture(repositoryScene("cornell_glass_mirror.json"));
    SceneDescription glass = repositoryScene("sppm_glass_mesh.json");
    glass.options.integrator = IntegratorKind::PathTracing;
    expectSamePicture(std::move(glass));
}

TEST_F(MitsubaExport, MitsubaScenesKeepTheirBits) {
    folder.write("square.obj", kSquareObj);
    expectSamePicture(
        load(R"(<sensor type="thinlens"><float name="fov" value="50"/><float name="aperture_radius"
value="0.05"/><float name="focus_distance" value="4"/><transform name="to_world"><lookat origin="0,1,5" target="0,0,0"
up="0,1,0"/></transform></sensor>
<bsdf type="twosided" id="board"><bsdf type="diffuse"><texture type="checkerboard" name="reflectance"><rgb name="color0"
value="0.9 0.2 0.1"/><transform name="to_uv"><scale x="4" y="2"/></transform></texture></bsdf></bsdf>
<shape type="rectangle"><transform name="to_world"><rotate x="1" angle="-90"/><scale value="3"/><translate y="-1"/>
</transform><ref id="board"/></shape>
<shape type="sphere"><ref id="board"/></shape><shape type="cube"><transform name="to_world"><rotate y="1" angle="30"/>
<scale value="0.4"/><translate x="1.5"/></transform><bsdf type="plastic"/></shape>
<shape type="obj"><string name="filename" value="square.obj"/><transform name="to_world"><translate x="-1.5"/></transform>
<bsdf type="conductor"><string name="material" value="Cu"/></bsdf></shape>
<shape type="cylinder"><point name="p0" x="-2" y="-1" z="1"/><point name="p1" x="-2" y="0.5" z="1"/><float name="radius"
value="0.2"/><bsdf type="dielectric"/></shape>
<shape type="disk"><transform name="to_world"><rotate x="1" angle="90"/><translate y="3"/></transform>
<emitter type="area"><rgb name="radiance" value="5 4 3"/></emitter></shape>
<emitter type="point"><point name="position" x="2" y="3" z="2"/><rgb name="intensity" value="3"/></emitter>
<emitter type="constant"><rgb name="radiance" value="0.2 0.3 0.4"/></emitter>)"));
}

/// Facets whose front is lit and shines, and brushed spheres, which have a direction to keep.
TEST_F(MitsubaExport, MirroredShapesKeepTheirBits) {
    folder.write("square.obj", kSquareObj);
    SceneDescription scene =
        load(R"(<sensor type="perspective"><float name="fov" value="50"/><transform name="to_world">
<lookat origin="0,0,6" target="0,0,0" up="0,1,0"/></transform></sensor>
<shape type="sphere"><bsdf type="roughconductor"><float name="alpha_u" value="0.1"/><float name="alpha_v" value="0.4"/>
</bsdf></shape>
<shape type="obj"><string name="filename" value="square.obj"/><boolean name="face_normals" value="true"/>
<transform name="to_world"><translate x="-2"/></transform><emitter type="area"/></shape>
<emitter type="point"><point name="position" x="2" y="3" z="4"/><rgb name="intensity" value="30"/></emitter>)");
    for (Object& object : scene.objects) {
        object.objectToWorld = scale(Vec3(1.0f, 1.0f, -1.0f)) * object.objectToWorld;
    }
    expectSamePicture(std::move(scene));
}

TEST_F(MitsubaExport, CamerasKeepTheirProjection) {
    SceneDescription scene = repositoryScene("cornell.json");
    scene.resolution = {40, 30};
    scene.options.filter = FilterKind::Box;
    scene.camera.shift = {0.3f, -0.7f};
    SceneDescription opened = exported(scene);
    EXPECT_THAT(warnings, IsEmpty());
    EXPECT_NEAR(opened.camera.shift.x, 0.3f, 1e-6f);
    EXPECT_NEAR(opened.camera.shift.y, -0.7f, 1e-6f);
    scene.camera.kind = ProjectionKind::Orthographic;
    scene.camera.viewHeight = 2.4f;
    scene.camera.horizontalScale = 1.5f;
    opened = exported(scene);
    EXPECT_THAT(warnings, IsEmpty());
    EXPECT_EQ(opened.camera.kind, ProjectionKind::Orthographic);
    EXPECT_NEAR(opened.camera.viewHeight, 2.4f, 1e-5f);
    EXPECT_NEAR(opened.camera.horizontalScale, 1.5f, 1e-5f);
    // A step aside takes the place of the shift.
    const CameraAxes axes = axesOf(scene.camera);
    const Vec3 aside = opened.camera.position - scene.camera.position;
    EXPECT_NEAR(glm::dot(aside, axes.right), 0.3f * 2.4f * 1.5f, 1e-5f);
    EXPECT_NEAR(glm::dot(aside, axes.up), -0.7f * 2.4f, 1e-5f);
    EXPECT_NEAR(glm::dot(aside, axes.forward), 0.0f, 1e-5f);
    scene.camera.kind = ProjectionKind::Perspective;
    scene.camera.apertureDiameter = 0.1f;
    exported(scene);
    EXPECT_THAT(warnings, Contains("approximated: the lens is not shifted"));
}

TEST_F(MitsubaExport, WhatMitsubaDoesNotHaveIsSaid) {
    SceneDescription scene = repositoryScene("cornell.json");
    scene.options.filter = FilterKind::BlackmanHarris;
    scene.camera.apertureDiameter = 0.1f;
    scene.camera.apertureBlades = 6;
    scene.materials[0].kind = MaterialKind::Mixture;
    exported(scene);
    EXPECT_THAT(warnings, Contains("approximated: the filter is a Gaussian"));
    EXPECT_THAT(warnings, Contains("approximated: the aperture is round"));
    EXPECT_THAT(warnings, Contains("approximated: mixtures are their heaviest part"));
}

TEST_F(MitsubaExport, PrincipledMaterialsKeepTheirInputs) {
    SceneDescription scene = load("<shape type='sphere'/>");
    Material& paint = scene.materials[0];
    paint.kind = MaterialKind::Principled;
    paint.color.value = Vec3(0.8f, 0.2f, 0.1f);
    paint.metallic.value = 0.6f;
    paint.roughness.value = 0.25f;
    paint.clearcoat.value = 0.2f;
    paint.clearcoatRoughness.value = 0.05f;
    paint.sheenColor.value = Vec3(0.05f);
    const Material opened = exported(scene).materials.at(0);
    EXPECT_EQ(opened.kind, MaterialKind::Principled);
    EXPECT_EQ(opened.color.value, paint.color.value);
    EXPECT_EQ(opened.metallic.value, 0.6f);
    EXPECT_NEAR(opened.roughness.value, 0.25f, 1e-6f);
    EXPECT_NEAR(opened.ior.value, 1.5f, 1e-5f);
    EXPECT_NEAR(opened.clearcoat.value, 0.2f, 1e-6f);
    EXPECT_NEAR(opened.clearcoatRoughness.value, 0.05f, 1e-6f);
    expectNear(opened.sheenColor.value, Vec3(0.05f), 1e-6f);
    EXPECT_THAT(warnings, Contains(HasSubstr("approximated: principled materials")));
}

TEST_F(MitsubaExport, NamesAndColoursOfVerticesPass) {
    SceneDescription scene = load("<shape type='cube'/>");
    auto mesh = std::make_shared<MeshData>(*scene.meshes[0].data);
    for (size_t i = 0; i < mesh->positions.size(); ++i) {
        mesh->colors.emplace_back(0.25f, 0.03125f * static_cast<float>(i), 1.0f);
    }
    scene.meshes[0].data = mesh;
    scene.materials[0].color.value = Vec3(1.0f);
    scene.materials[0].name = "<red & \"$blue\">";
    const SceneDescription opened = exported(scene);
    ASSERT_EQ(opened.meshes.size(), 1u);
    EXPECT_EQ(opened.meshes[0].data->colors, mesh->colors);
    EXPECT_EQ(opened.meshes[0].data->positions, mesh->positions);
}

TEST_F(MitsubaExport, TurnedProfilesBecomeTriangles) {
    for (const CurveKind curve : {CurveKind::Bezier, CurveKind::Bspline}) {
        SceneDescription scene = load("<shape type='sphere'/>");
        Object& object = scene.objects[0];
        object.shape = ShapeKind::Revolved;
        object.curve = curve;
        object.profile = {{1.0f, -2.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {1.0f, 2.0f}};
        const SceneDescription opened = exported(scene);
        EXPECT_THAT(warnings, Contains("approximated: revolved shapes are triangles"));
        ASSERT_EQ(opened.meshes.size(), 1u);
        const MeshData& mesh = *opened.meshes[0].data;
        EXPECT_GT(mesh.triangleCount(), 8000u);
        for (size_t i = 0; i < mesh.positions.size(); ++i) {
            const Vec3 outwards(mesh.positions[i].x, 0.0f, mesh.positions[i].z);
            expectNear(mesh.normals[i], outwards, 1e-4f);
        }
        for (size_t i = 0; i < mesh.indices.size(); i += 3) {
            const Vec3 &a = mesh.positions[mesh.indices[i]], &b = mesh.positions[mesh.indices[i + 1]],
                       &c = mesh.positions[mesh.indices[i + 2]];
            EXPECT_GT(glm::dot(glm::cross(b - a, c - a), mesh.normals[mesh.indices[i]]), 0.0f);
        }
    }
}

TEST_F(MitsubaExport, GlassAbsorbsInside) {
    SceneDescription scene = load("<shape type='sphere'><bsdf type='dielectric'/></shape>");
    scene.materials[0].attenuationColor = {0.5f, 0.25f, 1.0f};
    scene.materials[0].attenuationDistance = 2.0f;
    scene.options.filter = FilterKind::Box;
    const SceneDescription opened = exported(scene);
    EXPECT_THAT(warnings, IsEmpty());
    EXPECT_THAT(opened.warnings, IsEmpty());
    expectNear(absorptionOf(opened.materials.at(static_cast<size_t>(opened.objects.at(0).material))),
               absorptionOf(scene.materials[0]), 1e-6f);
}

TEST(Exporters, AreToldByTheirEndings) {
    EXPECT_EQ(exporterOf("a.json")->name, "Glint JSON");
    EXPECT_EQ(exporterOf("a.XML")->name, "Mitsuba 3");
    EXPECT_EQ(exporterOf("a.obj"), nullptr);
    EXPECT_EQ(exporterOf("a.pbrt")->name, "pbrt-v4");
    EXPECT_EQ(listExporters(), "Glint JSON (.json), glTF (.gltf .glb), Mitsuba 3 (.xml) or pbrt-v4 (.pbrt)");
}

TEST_F(MitsubaExport, CapsOfTurnedProfilesAreKept) { expectCapsAreKept(load("<shape type='sphere'/>")); }

TEST_F(MitsubaExport, TexturedPlanesAreKept) { expectTexturedPlanesAreKept(); }

TEST_F(MitsubaExport, LightsOfRayCastingAreLeftOut) {
    expectCastLightsAreLeftOut(load("<shape type='sphere'/>"));
}

}  // namespace
}  // namespace glint::test
