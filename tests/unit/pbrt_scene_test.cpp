// pbrt's directives: transforms, attributes, objects, includes, the camera, the film and the integrator.
#include <cmath>

#include "tests/support/pbrt_test.h"
#include "tests/support/render_scene.h"

namespace glint::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

class PbrtScene : public PbrtTest {
  protected:
    Vec3 placed(const std::string& transform, const Vec3& p) {
        // pbrt's sphere has its north in +z; Glint's in +y.
        const Affine toWorld = onlyObject(transform + " Shape \"sphere\"").objectToWorld;
        return toWorld.point(Vec3(-p.y, p.z, -p.x));
    }
    SceneDescription view(const std::string& directives) {
        SceneDescription scene = loadText(sceneText("Shape \"sphere\"", directives));
        keepWarnings(scene);
        return scene;
    }
};

TEST_F(PbrtScene, TransformsMultiplyFromTheRight) {
    expectNear(placed("Translate 1 2 3", Vec3(0.0f)), Vec3(1, 2, 3), 1e-6f);
    expectNear(placed("Translate 1 0 0 Scale 2 3 4", Vec3(1.0f)), Vec3(3, 3, 4), 1e-6f);
    expectNear(placed("Scale 2 2 2 Translate 1 0 0", Vec3(0.0f)), Vec3(2, 0, 0), 1e-6f);
    expectNear(placed("Rotate 90 0 0 2", Vec3(1, 0, 0)), Vec3(0, 1, 0), 1e-6f);
    expectNear(placed("Transform [1 0 0 0  0 2 0 0  0 0 3 0  4 5 6 1]", Vec3(1.0f)), Vec3(5, 7, 9), 1e-6f);
    expectNear(placed("Translate 1 0 0 ConcatTransform [1 0 0 0 0 1 0 0 0 0 1 0 0 5 0 1]", Vec3(0.0f)),
               Vec3(1, 5, 0), 1e-6f);
    expectNear(placed("Translate 9 9 9 Identity", Vec3(0.0f)), Vec3(0.0f), 1e-6f);
    expectNear(
        placed("Translate 1 0 0 CoordinateSystem \"a\" Translate 0 5 0 CoordSysTransform \"a\"", Vec3(0.0f)),
        Vec3(1, 0, 0), 1e-6f);
    expectNear(placed("CoordSysTransform \"camera\"", Vec3(0, 0, 1)), Vec3(0, 0, 4), 1e-5f);
    EXPECT_THAT(warnings, IsEmpty());
    expectNear(
        placed("Translate 1 0 0 ActiveTransform EndTime Translate 7 0 0 ActiveTransform All Translate 0 1 0",
               Vec3(0.0f)),
        Vec3(1, 1, 0), 1e-6f);
    EXPECT_THAT(warnings, Contains(HasSubstr("motion is left out")));
}

TEST_F(PbrtScene, AttributesEndWithTheirBlocks) {
    const SceneDescription scene = load(R"(Material "diffuse" "rgb reflectance" [1 0 0]
AttributeBegin Translate 1 0 0 Material "diffuse" "rgb reflectance" [0 1 0] Shape "sphere" AttributeEnd
TransformBegin Translate 0 2 0 Material "diffuse" "rgb reflectance" [0 0 1] TransformEnd Shape "sphere")");
    ASSERT_EQ(scene.objects.size(), 2u);
    EXPECT_EQ(scene.objects[0].objectToWorld.translation, Vec3(1, 0, 0));
    EXPECT_EQ(scene.objects[1].objectToWorld.translation, Vec3(0, 0, 0));
    EXPECT_EQ(scene.materials[0].color.value, Vec3(0, 1, 0));
    EXPECT_EQ(scene.materials[1].color.value, Vec3(0, 0, 1));
    const Object object = onlyObject("Attribute \"shape\" \"float radius\" 3 Shape \"sphere\"");
    EXPECT_NEAR(glm::length(object.objectToWorld.linear[0]), 3.0f, 1e-6f);
    EXPECT_NEAR(
        glm::length(onlyObject("Attribute \"shape\" \"float radius\" 3 Shape \"sphere\" \"float radius\" 2")
                        .objectToWorld.linear[0]),
        2.0f, 1e-6f);
}

TEST_F(PbrtScene, InstancesShareTheirObject) {
    const SceneDescription scene = load(R"(ObjectBegin "o" Translate 1 0 0 Shape "trianglemesh"
"point3 P" [0 0 0 1 0 0 0 1 0] Shape "sphere" ObjectEnd
AttributeBegin Scale 2 2 2 ObjectInstance "o" AttributeEnd Translate 0 0 5 ObjectInstance "o")");
    ASSERT_EQ(scene.objects.size(), 4u);
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.objects[0].objectToWorld.translation, Vec3(2, 0, 0));
    EXPECT_EQ(scene.objects[2].objectToWorld.translation, Vec3(1, 0, 5));
    EXPECT_EQ(scene.objects[0].mesh, scene.objects[2].mesh);
    EXPECT_THAT(
        load("ObjectBegin \"o\" AreaLightSource \"diffuse\" Shape \"sphere\" ObjectEnd ObjectInstance \"o\"")
            .warnings,
        Contains(HasSubstr("area lights within objects do not shine")));
}

TEST_F(PbrtScene, IncludedFilesStandInTheirPlace) {
    folder.write("part.pbrt", "Translate 1 0 0 # a comment \"[\nShape \"sphere\"\n");
    folder.write("packed.pbrt.gz", gzipped("Shape \"disk\"\n"));
    SceneDescription scene = load("Include \"part.pbrt\" Include \"packed.pbrt.gz\" Shape \"sphere\"");
    ASSERT_EQ(scene.objects.size(), 3u);
    EXPECT_EQ(scene.objects[1].shape, ShapeKind::Disc);
    EXPECT_EQ(scene.objects[2].objectToWorld.translation, Vec3(1, 0, 0));
    scene = load("Import \"part.pbrt\" Shape \"sphere\"");
    ASSERT_EQ(scene.objects.size(), 2u);
    EXPECT_EQ(scene.objects[0].objectToWorld.translation, Vec3(1, 0, 0));
    EXPECT_EQ(scene.objects[1].objectToWorld.translation, Vec3(0, 0, 0));
    const auto packed = loadScene(folder.write("b.pbrt.gz", gzipped(sceneText("Shape \"sphere\""))));
    ASSERT_TRUE(packed) << packed.error().format();
    EXPECT_EQ(packed->objects.size(), 1u);
}

TEST_F(PbrtScene, AnglesOfViewAreOfTheShorterSide) {
    const auto fov = [this](const std::string& size, const std::string& camera) {
        return view("Scale -1 1 1 Camera \"perspective\" \"float fov\" 90 " + camera + " Film \"rgb\" " +
                    size)
            .camera;
    };
    const std::string wide = R"("integer xresolution" 200 "integer yresolution" 100)";
    const std::string high = R"("integer xresolution" 100 "integer yresolution" 200)";
    EXPECT_NEAR(fov(wide, "").verticalFovDeg, 90.0f, 1e-3f);
    EXPECT_NEAR(fov(high, "").verticalFovDeg, 2.0f * std::atan(2.0f) * 180.0f / kPi, 1e-3f);
    EXPECT_EQ(fov(wide, "").horizontalScale, 1.0f);
    const Camera window = fov(wide, "\"float screenwindow\" [-2 2 -0.5 0.5]");
    EXPECT_NEAR(window.verticalFovDeg, 2.0f * std::atan(0.5f) * 180.0f / kPi, 1e-3f);
    EXPECT_NEAR(window.horizontalScale, 2.0f, 1e-4f);
    EXPECT_NEAR(fov(wide, "\"float frameaspectratio\" 4").horizontalScale, 2.0f, 1e-4f);
    EXPECT_THAT(warnings, IsEmpty());
    // The picture's middle lies its own height to the right of the axis, and half of it above.
    const Camera aside = fov(wide, "\"float screenwindow\" [-1 3 0 2]");
    expectNear(Vec3(aside.shift, 0.0f), Vec3(0.5f, 0.5f, 0.0f), 1e-6f);
    EXPECT_NEAR(aside.verticalFovDeg, 90.0f, 1e-3f);
}

TEST_F(PbrtScene, CamerasStandWhereTheirTransformSays) {
    Camera camera =
        view(
            "Scale -1 1 1 LookAt 1 2 3  1 2 -7  0 1 0 Camera \"perspective\" \"float lensradius\" 0.25 "
            "\"float focaldistance\" 4 Film \"rgb\"")
            .camera;
    expectNear(camera.position, Vec3(1, 2, 3), 1e-5f);
    EXPECT_EQ(camera.target, Vec3(1, 2, -7));
    expectNear(camera.up, Vec3(0, 1, 0), 1e-6f);
    EXPECT_NEAR(camera.apertureDiameter, 0.5f, 1e-6f);
    EXPECT_NEAR(camera.focalDistance, 4.0f, 1e-5f);
    // pbrt's own space: it looks along +z, +x is on the right, and so x is turned over.
    const SceneDescription own =
        loadText(sceneText("Translate 1 2 3 Shape \"sphere\" LightSource \"point\" LightSource \"distant\" "
                           "\"point3 to\" [1 0 0]",
                           "Translate 0 0 2 Camera \"perspective\" "));
    expectNear(own.objects.at(0).objectToWorld.translation, Vec3(-1, 2, 3), 1e-6f);
    expectNear(own.lights.at(0).position, Vec3(-1, 2, 3), 1e-6f);
    expectNear(own.lights.at(1).direction, Vec3(-1, 0, 0), 1e-6f);
    expectNear(own.camera.position, Vec3(0, 0, -2), 1e-6f);
    expectNear(glm::normalize(own.camera.target - own.camera.position), Vec3(0, 0, 1), 1e-6f);
    for (const char* kind : {"realistic", "spherical"}) {
        camera = view("Scale -1 1 1 LookAt 0 0 5 0 0 0 0 1 0 Camera \"" + std::string(kind) + "\" ").camera;
        EXPECT_THAT(warnings, Contains(HasSubstr("approximated: "))) << kind;
        expectNear(glm::normalize(camera.target - camera.position), Vec3(0, 0, -1), 1e-4f);
    }
    EXPECT_THAT(loadText("Shape \"sphere\"").camera.position, testing::Not(Vec3(0, 1, 5)));
}

TEST_F(PbrtScene, ParallelRaysShowTheirWindow) {
    const Camera camera = view(
                              "Scale -2 2 2 LookAt 0 0 5 0 0 0 0 1 0 Camera \"orthographic\" "
                              "\"float screenwindow\" [-4 4 -1 3] Film \"rgb\" \"integer xresolution\" 200 "
                              "\"integer yresolution\" 100")
                              .camera;
    EXPECT_THAT(warnings, IsEmpty());
    EXPECT_EQ(camera.kind, ProjectionKind::Orthographic);
    EXPECT_NEAR(camera.viewHeight, 2.0f, 1e-5f);  // the world is twice as large for the camera
    EXPECT_EQ(camera.horizontalScale, 1.0f);
    expectNear(Vec3(camera.shift, 0.0f), Vec3(0.0f, 0.25f, 0.0f), 1e-6f);
    expectNear(camera.position, Vec3(0, 0, 5), 1e-5f);
    expectNear(glm::normalize(camera.target - camera.position), Vec3(0, 0, -1), 1e-5f);
}

/// A crop window shows the pixels that it has of the whole picture.
TEST_F(PbrtScene, CropWindowsShowTheirPixels) {
    const std::string world = R"(LightSource "infinite" "rgb L" [0.1 0.2 0.3]
AreaLightSource "diffuse" Shape "sphere" "float radius" 0.7)";
    const auto filmOf = [&](const std::string& crop) {
        const SceneDescription scene = loadText(sceneText(
            world,
            "Translate 0.5 0.2 4 Camera \"perspective\" \"float fov\" 50 PixelFilter \"box\" Film \"rgb\" "
            "\"integer xresolution\" 64 \"integer yresolution\" 32 " +
                crop + " "));
        EXPECT_THAT(scene.warnings, IsEmpty());
        return std::pair(scene.resolution, renderFilm(scene, 16));
    };
    const auto [wholeSize, whole] = filmOf("");
    for (const char* crop :
         {"\"float cropwindow\" [0.25 0.75 0.5 1]", "\"integer pixelbounds\" [16 48 16 32]"}) {
        const auto [size, part] = filmOf(crop);
        ASSERT_EQ(size, (Resolution{32, 16}));
        for (int block = 0; block < 8; ++block) {
            const int x = block % 4 * 8, y = block / 4 * 8;
            EXPECT_NEAR(meanLuminance(part, x, y, x + 8, y + 8).mean,
                        meanLuminance(whole, 16 + x, 16 + y, 24 + x, 24 + y).mean, 0.02)
                << crop << block;
        }
    }
    EXPECT_THAT(loadScene(folder.write("none.pbrt",
                                       sceneText("", "Film \"rgb\" \"float cropwindow\" [0.5 0.5 0 1] ")))
                    .error()
                    .format(),
                HasSubstr("holds no pixel"));
}

/// A bright sphere in pbrt's +x and +y is on the right and at the top of its picture.
TEST_F(PbrtScene, PicturesAreNotMirrored) {
    const std::string world = R"(AttributeBegin AreaLightSource "diffuse" "rgb L" [2 2 2]
Translate 1 1 0 Shape "sphere" "float radius" 0.3 AttributeEnd)";
    const std::string film =
        R"(Film "rgb" "integer xresolution" 16 "integer yresolution" 16 PixelFilter "box" )";
    const auto brightest = [&](const std::string& camera) {
        const SceneDescription scene = loadText(sceneText(world, camera + film));
        const Film image = renderFilm(scene, 4);
        for (const bool isRight : {false, true}) {
            for (const bool isLow : {false, true}) {
                const int x = isRight ? 8 : 0, y = isLow ? 8 : 0;
                if (meanLuminance(image, x, y, x + 8, y + 8).mean > 0.01) {
                    return std::string(isLow ? "low " : "high ") + (isRight ? "right" : "left");
                }
            }
        }
        return std::string("nowhere");
    };
    const std::string camera = "Camera \"perspective\" \"float fov\" 60 ";
    EXPECT_EQ(brightest("Translate 0 0 4 " + camera), "high right");
    // From +z, pbrt's right is -x unless the file mirrors it.
    EXPECT_EQ(brightest("LookAt 0 0 4 0 0 0 0 1 0 " + camera), "high left");
    EXPECT_EQ(brightest("Scale -1 1 1 LookAt 0 0 4 0 0 0 0 1 0 " + camera), "high right");
    EXPECT_EQ(brightest("LookAt 0 0 4 0 0 0 0 -1 0 " + camera), "low right");
}

TEST_F(PbrtScene, FilmsHaveSizesFiltersAndExposures) {
    const std::string camera = kRightHanded;
    SceneDescription scene = view(camera + R"(Film "rgb" "integer xresolution" 20 "integer yresolution" 10)");
    EXPECT_EQ(scene.resolution, (Resolution{20, 10}));
    EXPECT_EQ(scene.options.filter, FilterKind::Gaussian);
    EXPECT_FLOAT_EQ(scene.options.filterRadius, 1.5f);
    EXPECT_EQ(view(camera).resolution, (Resolution{1280, 720}));
    scene = view(camera + "PixelFilter \"box\" \"float xradius\" 0.5 \"float yradius\" 0.5");
    EXPECT_EQ(scene.options.filter, FilterKind::Box);
    EXPECT_FLOAT_EQ(scene.options.filterRadius, 0.5f);
    view(camera + "PixelFilter \"mitchell\"");
    EXPECT_THAT(warnings, Contains(HasSubstr("the filter is a Gaussian")));
    view(camera + R"(Film "gbuffer" "string sensor" "canon_eos_5d" "float whitebalance" 5000)");
    EXPECT_THAT(warnings, AllOf(Contains(HasSubstr("sensor")), Contains(HasSubstr("white is balanced")),
                                Contains(HasSubstr("another kind"))));
    const SceneDescription exposed = loadText(sceneText(
        "LightSource \"point\" LightSource \"infinite\" AreaLightSource \"diffuse\" Shape \"sphere\"",
        R"(Camera "perspective" "float shutterclose" 0.5 Film "rgb" "float iso" 400 "float maxcomponentvalue" 7 )"));
    EXPECT_FLOAT_EQ(exposed.lights.at(0).strength, 2.0f);
    EXPECT_FLOAT_EQ(exposed.environment.strength, 2.0f);
    EXPECT_FLOAT_EQ(exposed.materials.at(0).emissionStrength, 2.0f);
    EXPECT_FLOAT_EQ(exposed.options.fireflyClamp, 7.0f);
    EXPECT_THAT(exposed.notes, Contains(HasSubstr("exposure")));
}

/// Both count scattering events: 0 is what the camera sees shine.
TEST_F(PbrtScene, DepthsCountScatteringEvents) {
    const auto options = [this](const std::string& integrator) {
        return view(kRightHanded + integrator).options;
    };
    EXPECT_EQ(options("Integrator \"path\" \"integer maxdepth\" 0").maxDepth, 0);
    EXPECT_EQ(options("Integrator \"volpath\" \"integer maxdepth\" 7").maxDepth, 7);
    EXPECT_EQ(options("").maxDepth, 5);
    EXPECT_EQ(options("Integrator \"bdpt\"").integrator, IntegratorKind::PathTracing);
    EXPECT_EQ(options("Integrator \"ambientocclusion\"").integrator, IntegratorKind::AmbientOcclusion);
    const SceneDescription photons = view(std::string(kRightHanded) +
                                          "Integrator \"sppm\" \"float radius\" 0.5 \"integer "
                                          "photonsperiteration\" 1000 \"integer maxdepth\" 3");
    EXPECT_EQ(photons.options.integrator, IntegratorKind::Sppm);
    EXPECT_EQ(photons.options.maxDepth, 3);
    EXPECT_EQ(photons.sppm.radiusWorld, 0.5f);
    EXPECT_EQ(photons.sppm.photonsPerPass, 1000u);
}

/// Of a white sphere in a white environment, one event shows the environment and as much on the sphere.
TEST_F(PbrtScene, OneEventIsDirectLight) {
    const auto mean = [this](const std::string& depth) {
        const SceneDescription scene = loadText(sceneText(
            "LightSource \"infinite\" Material \"diffuse\" \"rgb reflectance\" [0.5 0.5 0.5] Shape "
            "\"sphere\" \"float "
            "radius\" 3",
            R"(LookAt 0 0 5 0 0 0 0 1 0 Camera "perspective" "float fov" 20 Film "rgb" "integer xresolution" 4
"integer yresolution" 4 Integrator "path" "integer maxdepth" )" +
                depth + " "));
        return meanLuminance(renderFilm(scene, 64)).mean;
    };
    EXPECT_EQ(mean("0"), 0.0);
    EXPECT_NEAR(mean("1"), 0.5, 0.01);
    EXPECT_NEAR(mean("5"), 0.5, 0.01);
}

TEST_F(PbrtScene, WhatIsLeftOutIsSaid) {
    const SceneDescription scene = load(R"(Shape "sphere" "float wobble" 1 "matrix4 odd" [1 2 3]
Wobble "a" "float b" [1 2] 3
MakeNamedMedium "fog" "string type" "homogeneous" MediumInterface "fog" "" MediumInterface "fog"
Shape "sphere" Camera "perspective")");
    EXPECT_EQ(scene.objects.size(), 2u);
    EXPECT_THAT(scene.warnings, Contains(HasSubstr("a.pbrt:3: \"wobble\" of Shape \"sphere\" is left out")));
    EXPECT_THAT(scene.warnings, Contains(AllOf(HasSubstr("a.pbrt:4: directives that pbrt does not have"),
                                               HasSubstr("Wobble"))));
    EXPECT_THAT(scene.warnings, Contains(HasSubstr("parameters of a type")));
    EXPECT_THAT(scene.warnings, Contains(HasSubstr("media are left out but within glass")));
    EXPECT_THAT(scene.warnings, Contains(HasSubstr("within the world are left out")));
}

}  // namespace
}  // namespace glint::test
