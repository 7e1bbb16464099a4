// pbrt scenes that are broken or made to break: one error that names its place, bounded memory, and never
// a crash.

#include "engine/io/image_io.h"
#include "tests/support/damaged_text.h"
#include "tests/support/pbrt_test.h"

namespace glint::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

using MalformedPbrt = PbrtTest;

std::string repeated(const std::string& text, size_t times) {
    std::string out;
    for (size_t i = 0; i < times; ++i) {
        out += text;
    }
    return out;
}

TEST_F(MalformedPbrt, FilesGiveOneErrorThatNamesThePlace) {
    const std::pair<std::string, const char*> contents[] = {
        {"Translate 1 2", "bad.pbrt:4:1: expected 3 finite numbers behind Translate"},
        {"Translate 1 2 much", "bad.pbrt:3:15: expected 3 finite numbers"},
        {"Translate 1 2 inf", "expected 3 finite numbers"},
        {"Translate 1 2 1.5.5", "expected 3 finite numbers"},
        {"Transform [1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", "expected 16 finite numbers behind Transform"},
        {"Transform [1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1] Shape \"sphere\"",
         "bad.pbrt:3:45: the transform is not affine"},
        {"Scale 1e19 1 1 Shape \"sphere\"", "above 1e18"},
        {"Rotate 90 0 0 0", "the rotation has no axis"},
        {"LookAt 0 0 0 0 1 0 0 1 0", "looks along its up vector"},
        {"Shape", "expected a name in quotes behind Shape"},
        {"Shape \"sphere", "expected a name in quotes behind Shape"},
        {"Texture \"a\" \"float\"", "expected three names in quotes behind Texture"},
        {"Shape \"sphere\" \"float radius\"", "expected finite numbers for \"float radius\""},
        {"Shape \"sphere\" \"float radius\" [", "expected finite numbers"},
        {"Shape \"sphere\" \"float radius\" [1 2 x]", "bad.pbrt:3:36: expected finite numbers"},
        {"Shape \"sphere\" \"float radius\" nan", "expected finite numbers"},
        {"Shape \"sphere\" \"radius\" 1", "\"radius\" declares no parameter"},
        {"Shape \"sphere\" \"string radius\" \"1\"", "expected 1 finite numbers for \"radius\""},
        {"Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"integer indices\" [0 1 9999999999]",
         "expected whole numbers below 2^31"},
        {"Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"integer indices\" [0 1 -1]",
         "the index -1 is none"},
        {"Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"integer indices\" [0 1]",
         "expected a multiple of 3"},
        {"Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1]",
         "\"P\" has 8 numbers; expected a multiple of 3"},
        {"Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1e20 0]", "a number above 1e18"},
        {"Shape \"trianglemesh\"", "has no points"},
        {"Shape \"plymesh\"", "has no \"filename\""},
        {"AttributeEnd", "AttributeEnd ends nothing"},
        {"AttributeBegin TransformEnd", "expected AttributeEnd before TransformEnd"},
        {"AttributeBegin", "bad.pbrt:3:1: AttributeBegin is not ended"},
        {"ObjectBegin \"a\" ObjectBegin \"b\"", "objects cannot be within objects"},
        {"ObjectBegin \"a\" ObjectInstance \"a\"", "instances cannot be within objects"},
        {"ObjectInstance \"a\"", "there is no object \"a\""},
        {"CoordSysTransform \"a\"", "there is no coordinate system \"a\""},
        {"WorldBegin", "the world begins twice"},
        {"17 Shape", "expected a directive, but found \"17\""},
        {"]", "expected a directive, but found \"]\""},
        {"Texture \"a\" \"matrix\" \"constant\"", "is no type of textures"},
        {"Material \"mix\" Shape \"sphere\"", "expected the names of two \"materials\""},
        {"Material \"diffuse\" \"rgb reflectance\" [1 2] Shape \"sphere\"", "\"reflectance\" is no colour"},
        {"Material \"diffuse\" \"spectrum reflectance\" [500 1 400 1] Shape \"sphere\"",
         "wavelengths rising"},
        {"Include \"bad.pbrt\"", "includes itself"},
        {"Include \"none.pbrt\"", "cannot include"},
        {repeated("AttributeBegin ", 100'000), "AttributeBegin is not ended"},
        {repeated("TransformEnd ", 100'000), "TransformEnd ends nothing"},
        {"Attribute \"shape\" \"point3 P\" [" + repeated("1 2 3 ", 100) + "]", "more than 64"},
        {"Shape \"sphere\" \"float radius\" " + repeated("[", 100'000), "expected finite numbers"}};
    for (const auto& [content, message] : contents) {
        EXPECT_THAT(errorOf(content), AllOf(HasSubstr(message), HasSubstr("bad.pbrt:")))
            << content.substr(0, 200);
    }
}

TEST_F(MalformedPbrt, CamerasComeBeforeTheirWorld) {
    const auto scene = loadScene(folder.write("bad.pbrt", "Camera \"perspective\"\n Shape \"sphere\""));
    ASSERT_FALSE(scene);
    EXPECT_THAT(scene.error().format(), HasSubstr("bad.pbrt:2:2: expected WorldBegin before Shape"));
}

TEST_F(MalformedPbrt, DeepNestingIsNoMatter) {
    constexpr size_t kLevels = 100'000;
    const SceneDescription scene = load(repeated("AttributeBegin Translate 1 0 0 ", kLevels) +
                                        "Shape \"sphere\" " + repeated("AttributeEnd ", kLevels));
    ASSERT_EQ(scene.objects.size(), 1u);
    EXPECT_EQ(scene.objects[0].objectToWorld.translation.x, 100'000.0f);
}

TEST_F(MalformedPbrt, IncludesAndInstancesStayBounded) {
    folder.write("one.pbrt", "Include \"two.pbrt\"");
    folder.write("two.pbrt", "\n Import \"one.pbrt\"");
    EXPECT_THAT(errorOf("Include \"one.pbrt\""),
                AllOf(HasSubstr("two.pbrt:2:2: "), HasSubstr("includes itself")));
    for (int i = 0; i < 12; ++i) {  // 10^12 files
        folder.write("level" + std::to_string(i) + ".pbrt",
                     repeated("Include \"level" + std::to_string(i + 1) + ".pbrt\" ", 10));
    }
    folder.write("level12.pbrt", "");
    EXPECT_THAT(errorOf("Include \"level0.pbrt\""), HasSubstr("more than 65536 of them"));
    EXPECT_THAT(errorOf("ObjectBegin \"a\" " + repeated("Shape \"sphere\" ", 3000) + "ObjectEnd " +
                        repeated("ObjectInstance \"a\" ", 3000)),
                HasSubstr("more than 4000000 objects"));
    std::string doubling = "Texture \"t0\" \"float\" \"constant\" ";
    for (int i = 1; i < 60; ++i) {
        const std::string before = "\"texture tex1\" \"t" + std::to_string(i - 1) +
                                   "\" \"texture tex2\" \"t" + std::to_string(i - 1) + "\" ";
        doubling += "Texture \"t" + std::to_string(i) + "\" \"float\" \"mix\" " + before;
    }
    EXPECT_EQ(load(doubling + "Shape \"sphere\" \"texture alpha\" \"t59\"").objects.size(), 1u);
}

TEST_F(MalformedPbrt, PackedFilesThatAreBrokenAreRefused) {
    const auto foreign = loadScene(folder.write("a.obj", gzipped("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")));
    ASSERT_FALSE(foreign);
    EXPECT_THAT(foreign.error().format(), HasSubstr("holds no directive of pbrt"));
    const std::string packed = gzipped(sceneText("Shape \"sphere\""));
    const auto cut = loadScene(folder.write("cut.pbrt.gz", packed.substr(0, packed.size() / 2)));
    ASSERT_FALSE(cut);
    EXPECT_THAT(cut.error().format(), HasSubstr("broken or cut off"));
    std::string damaged = packed;
    damaged[damaged.size() - 6] = static_cast<char>(damaged[damaged.size() - 6] ^ 1);  // its checksum
    EXPECT_FALSE(loadScene(folder.write("damaged.pbrt.gz", damaged)));
    const auto twice =
        loadScene(folder.write("twice.pbrt.gz", packed + gzipped("Shape \"disk\"")), {.noStudio = true});
    ASSERT_TRUE(twice) << twice.error().format();
    EXPECT_EQ(twice->objects.size(), 2u);
}

const std::string kGood = R"(# a scene
LookAt 0 0 5  0 0 0  0 1 0
Camera "perspective" "float fov" [40] "float lensradius" 0.1 "float focaldistance" 5
Film "rgb" "integer xresolution" [16] "integer yresolution" 9 "string filename" "a.exr"
Sampler "halton" "integer pixelsamples" 16 Integrator "volpath" "integer maxdepth" 5
WorldBegin
LightSource "infinite" "rgb L" [0.1 0.2 0.3] LightSource "spot" "point3 from" [0 5 0] "point3 to" [0 0 0] "blackbody I" 5000
Texture "board" "spectrum" "checkerboard" "float uscale" 2 "rgb tex1" [0.1 0.2 0.3] "rgb tex2" [1 1 0]
Texture "half" "float" "constant" "float value" 0.5 Texture "mixed" "spectrum" "mix" "texture tex1" "board" "texture amount" "half"
MakeNamedMaterial "gold" "string type" "conductor" "spectrum eta" "metal-Au-eta" "spectrum k" "metal-Au-k" "float roughness" 0.1
MakeNamedMaterial "red" "string type" "diffuse" "rgb reflectance" [0.9 0.1 0.1]
Material "mix" "string materials" ["gold" "red"] "float amount" 0.3
AttributeBegin Translate 1 0 0 Rotate 30 0 1 0 Scale 2 1 1
AreaLightSource "diffuse" "rgb L" [1 2 3] "float scale" 2 "bool twosided" true Shape "sphere" "float radius" 0.5 AttributeEnd
ObjectBegin "o" Material "coateddiffuse" "texture reflectance" "mixed" Shape "trianglemesh" "point3 P" [0 0 0 1 0 0 1 1 0 0 1 0]
"integer indices" [0 1 2 0 2 3] "point2 uv" [0 0 1 0 1 1 0 1] Shape "bilinearmesh" "point3 P" [0 0 0 1 0 0 0 1 0 1 1 1] ObjectEnd
ObjectInstance "o" TransformBegin ConcatTransform [1 0 0 0 0 1 0 0 0 0 1 0 3 0 0 1] ObjectInstance "o" TransformEnd
Material "dielectric" "float eta" 1.33 Shape "cylinder" "float zmax" 2 Shape "disk" "float innerradius" 0.2 "float alpha" 0.5
Shape "loopsubdiv" "integer levels" 1 "point3 P" [0 0 0 1 0 0 0 1 0 0 0 1] "integer indices" [0 2 1 0 1 3 1 2 3 2 0 3]
NamedMaterial "red" Shape "curve" "point3 P" [0 0 0 1 0 0 1 1 0 0 1 1] "float width" 0.1
Texture "d" "spectrum" "dots" "rgb inside" [1 0 0] Texture "b" "spectrum" "bilerp" "float uscale" 2 Texture "w" "float" "wrinkled"
Material "diffuse" "texture reflectance" "d" "texture displacement" "w" Shape "sphere" Material "diffuse" "texture reflectance" "b"
Shape "sphere" LightSource "projection" "string filename" "p.png" "float fov" 40
)";

TEST_F(MalformedPbrt, DamagedFilesNeverCrash) {
    ASSERT_TRUE(savePng(folder.path("p.png"), {2, 1, {255, 255, 255, 255, 0, 0}}));
    ASSERT_TRUE(loadScene(folder.write("good.pbrt", kGood)));
    constexpr std::string_view kOften = "0123456789-[]\"# .\n\\e";
    EXPECT_GT(openDamagedScenes(folder, "damaged.pbrt", kGood, kOften), 100);
}

}  // namespace
}  // namespace glint::test
