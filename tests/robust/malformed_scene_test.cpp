// Malformed scene files: each gives one error that names the place and what was expected, and
// nothing crashes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/scene_loader.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::TempFolder;
using testing::HasSubstr;

struct BadScene {
    const char* name;
    std::string text;
    const char* place;    ///< what stands between the file's name and the message: ":line:column: " or ": "
    const char* message;  ///< a part of the message that only this mistake gives
};

void PrintTo(const BadScene& scene, std::ostream* out) { *out << scene.name; }

std::string nested(const char* open, int depth, const char* middle, const char* close) {
    std::string text;
    for (int i = 0; i < depth; ++i) {
        text += open;
    }
    text += middle;
    for (int i = 0; i < depth; ++i) {
        text += close;
    }
    return text;
}

void expectError(const BadScene& bad, const std::string& extension) {
    const TempFolder folder;
    const std::string path = folder.write(bad.name + extension, bad.text);
    const auto scene = loadScene(path);
    ASSERT_FALSE(scene.ok()) << "was read without an error";
    EXPECT_THAT(scene.error().format(), testing::StartsWith(path + bad.place));
    EXPECT_THAT(scene.error().format(), HasSubstr(bad.message));
}

std::string testName(const testing::TestParamInfo<BadScene>& test) { return test.param.name; }

class MalformedJson : public testing::TestWithParam<BadScene> {};

TEST_P(MalformedJson, IsOneClearError) { expectError(GetParam(), ".json"); }

std::string scene(const std::string& members) { return "{\"glint\": 1,\n" + members + "}"; }
std::string object(const std::string& members) {
    return scene("\"materials\": {\"red\": {\"type\": \"diffuse\"}},\n\"objects\": [{" + members + "}]");
}
std::string material(const std::string& members) {
    return scene("\"materials\": {\"m\": {" + members + "}}");
}

const BadScene kBadJson[] = {
    {"empty", "", ": ", "is empty"},
    {"blank", " \n\t\n", ": ", "is empty"},
    {"junk",
     std::string("\x7f"
                 "ELF\0\1\2\3",
                 8),
     ":1:1: ", "expected a value"},
    {"array", "[1, 2]", ":1:1: ", "\"the scene\" is an array; expected an object"},
    {"cut_object", "{\"glint\": 1", ":1:1: ", "never closed"},
    {"cut_string", "{\"glint\": 1, \"title\": \"abc", ":1:23: ", "this string is never closed"},
    {"cut_comment", "{ /* abc", ":1:3: ", "this comment is never closed"},
    {"after_the_end", "{\"glint\": 1}\n}", ":2:1: ", "unexpected '}' after the end"},
    {"no_comma", "{\"glint\": 1\n\"title\": \"\"}", ":2:1: ", "expected ',' or '}' after a value"},
    {"trailing_comma", "{\"glint\": 1,}", ":1:12: ", "a comma before '}'"},
    {"no_colon", "{\"glint\" 1}", ":1:10: ", "expected ':' after the key"},
    {"bare_key", "{glint: 1}", ":1:2: ", "expected a key in double quotes or '}', not 'g'"},
    {"bare_word", scene("\"title\": Cornell"), ":2:10: ", "unknown word 'Cornell'"},
    {"twice", scene("\"title\": \"a\", \"title\": \"b\""), ":2:15: ", "stands twice"},
    {"control", "{\"glint\": 1, \"title\": \"a\nb\"}", ":1:25: ", "inside a string"},
    {"escape", scene("\"title\": \"a\\qb\""), ":2:12: ", "unknown escape"},
    {"unicode", scene("\"title\": \"a\\u12g4\""), ":2:12: ", "four hexadecimal digits"},
    {"nan", scene("\"environment\": {\"strength\": NaN}"), ":2:29: ", "must be finite"},
    {"plus", scene("\"environment\": {\"strength\": +1}"), ":2:29: ", "is not a number as JSON writes it"},
    {"leading_zero", scene("\"environment\": {\"strength\": 01}"),
     ":2:29: ", "is not a number as JSON writes it"},
    {"deep", nested("[", 100000, "", "]"), ":1:66: ", "nested deeper than 64"},
    {"deep_objects", nested("{\"a\":", 100000, "1", "}"), ":1:", "nested deeper than 64"},
    {"version_missing", "{\"title\": \"\"}", ":1:1: ", "has no \"glint\""},
    {"version_newer", "{\"glint\": 2}", ":1:11: ", "a whole number from 1 to 1"},
    {"unknown_key", scene("\"camra\": {}"),
     ":2:1: ", "unknown key \"camra\" of the scene (did you mean 'camera'?)"},
    {"wrong_type", scene("\"camera\": 7"), ":2:11: ", "\"camera\" is 7; expected an object"},
    {"short_vector", scene("\"camera\": {\"position\": [1, 2]}"), ":2:24: ", "has 2 of 3 numbers"},
    {"long_vector", scene("\"camera\": {\"position\": [1, 2, 3, 4]}"), ":2:34: ", "more than 3 numbers"},
    {"text_number", scene("\"camera\": {\"verticalFovDeg\": \"40\"}"),
     ":2:30: ", "is \"40\"; expected an angle"},
    {"wide_view", scene("\"camera\": {\"verticalFovDeg\": 200}"), ":2:30: ", "between 0 and 180 degrees"},
    {"huge", scene("\"camera\": {\"focalDistance\": 1e39}"), ":2:29: ", "32-bit float"},
    {"huge_exponent", scene("\"camera\": {\"focalDistance\": 1e999999999999}"), ":2:29: ", "32-bit float"},
    {"negative_aperture", scene("\"camera\": {\"apertureDiameter\": -1}"), ":2:32: ", "a number >= 0"},
    {"two_blades", scene("\"camera\": {\"apertureBlades\": 2}"), ":2:30: ", "is less than 3"},
    {"no_view", scene("\"camera\": {\"position\": [1, 1, 1], \"target\": [1, 1, 1]}"),
     ":2:11: ", "the same point"},
    {"no_pixels", scene("\"resolution\": [0, 10]"), ":2:16: ", "from 1 to 32768"},
    {"too_many_pixels", scene("\"resolution\": [32768, 32768]"), ":2:15: ", "too many"},
    {"half_pixels", scene("\"resolution\": [10.5, 10]"), ":2:16: ", "a whole number"},
    {"filter", scene("\"render\": {\"filter\": \"gausian\"}"), ":2:22: ", "did you mean 'gaussian'"},
    {"material_type", material("\"type\": \"difuse\""), ":2:29: ", "did you mean 'diffuse'"},
    {"no_material_type", material("\"color\": 1"), ":2:20: ", "has no \"type\""},
    {"key_of_other_type", material("\"type\": \"diffuse\", \"ior\": 2"),
     ":2:40: ", "unknown key \"ior\" of diffuse"},
    {"bright_color", material("\"type\": \"diffuse\", \"color\": [1.5, 0, 0]"),
     ":2:50: ", "a reflectance from 0 to 1"},
    {"hex_color", material("\"type\": \"diffuse\", \"color\": \"#ff00\""), ":2:49: ", "\"#rrggbb\""},
    {"ior", material("\"type\": \"dielectric\", \"ior\": 0"), ":2:50: ", "an index of refraction"},
    {"metal", material("\"type\": \"conductor\", \"metal\": \"goldd\""), ":2:51: ", "did you mean 'gold'"},
    {"eta_alone", material("\"type\": \"conductor\", \"eta\": 1"), ":2:49: ", "belong together"},
    {"weights", material("\"type\": \"mixture\", \"weights\": [0, 0, 0]"), ":2:51: ", "are all 0"},
    {"negative_emission", material("\"type\": \"diffuse\", \"emission\": -1"), ":2:52: ", "a number >= 0"},
    {"no_such_texture", material("\"type\": \"diffuse\", \"color\": {\"texture\": \"wood\"}"),
     ":2:61: ", "no texture is called \"wood\""},
    {"missing_file", object("\"type\": \"mesh\", \"material\": \"red\", \"mesh\": {\"file\": \"none.ply\"}"),
     ":3:57: ", "--allow-missing"},
    {"no_such_material", object("\"type\": \"sphere\", \"material\": \"rde\""),
     ":3:44: ", "did you mean 'red'"},
    {"no_material", object("\"type\": \"sphere\""), ":3:13: ", "has no \"material\""},
    {"shape", object("\"type\": \"cube\", \"material\": \"red\""), ":3:22: ", "unknown type \"cube\""},
    {"negative_radius", object("\"type\": \"sphere\", \"material\": \"red\", \"radius\": -1"),
     ":3:61: ", "a number > 0"},
    {"zero_normal", object("\"type\": \"disc\", \"material\": \"red\", \"normal\": [0, 0, 0]"),
     ":3:59: ", "no direction"},
    {"flat_rectangle",
     object("\"type\": \"rectangle\", \"material\": \"red\", \"edgeU\": [1, 0, 0], \"edgeV\": [2, 0, 0]"),
     ":3:13: ", "parallel"},
    {"flat_transform",
     object("\"type\": \"sphere\", \"material\": \"red\", \"transform\": {\"scale\": [1, 0, 1]}"),
     ":3:64: ", "flattened"},
    {"two_steps_in_one",
     object("\"type\": \"sphere\", \"material\": \"red\", \"transform\": [{\"scale\": 2, \"translate\": [0, "
            "0, 0]}]"),
     ":3:65: ", "has 2 keys"},
    {"no_such_mesh", object("\"type\": \"mesh\", \"material\": \"red\", \"mesh\": \"bunny\""),
     ":3:57: ", "no \"meshes\""},
    {"generator",
     object("\"type\": \"mesh\", \"material\": \"red\", \"mesh\": {\"generator\": \"torus-nkot\"}"),
     ":3:57: ", "torus-knot"},
    {"absurd_count",
     object("\"type\": \"mesh\", \"material\": \"red\", \"mesh\": {\"generator\": \"sphere\", "
            "\"triangleCount\": 1e18}"),
     ":3:98: ", "a whole number"},
    {"vertex_number",
     object("\"type\": \"mesh\", \"material\": \"red\", \"mesh\": {\"positions\": [[0,0,0]], \"triangles\": "
            "[[0, 0, 1]]}"),
     ":3:103: ", "from 0 to 0"},
    {"normal_count",
     object("\"type\": \"mesh\", \"material\": \"red\",\n\"mesh\": {\"positions\": [[0,0,0]], \"normals\": "
            "[], \"triangles\": []}"),
     ":4:45: ", "0 entries for 1 positions"},
    {"light_type", scene("\"lights\": [{\"type\": \"area\"}]"), ":2:21: ", "unknown type \"area\" of light"},
    {"light_place", scene("\"lights\": [{\"type\": \"point\"}]"), ":2:12: ", "has no \"position\""},
    {"spot_angles",
     scene("\"lights\": [{\"type\": \"spot\", \"position\": [0,0,0], \"coneAngleDeg\": 20, "
           "\"coneFalloffStartDeg\": 30}]"),
     ":2:", "from 0 to \"coneAngleDeg\""},
    {"sky", scene("\"environment\": {\"image\": {\"generator\": \"sky\", \"width\": 100000}}"),
     ":2:56: ", "from 16 to 8192"},
};

INSTANTIATE_TEST_SUITE_P(Robust, MalformedJson, testing::ValuesIn(kBadJson), testName);

class MalformedText : public testing::TestWithParam<BadScene> {};

TEST_P(MalformedText, IsOneClearError) { expectError(GetParam(), ".txt"); }

std::string group(const std::string& objects) {
    return "Materials { numMaterials 1 Material { } }\nGroup { numObjects 1\n" + objects + " }";
}

const BadScene kBadText[] = {
    {"empty", "", ": ", "is empty"},
    {"junk", std::string("\0\1\2\3", 4), ":1:1: ", "is not known in a scene"},
    {"block", "Camera { }", ":1:1: ", "'Camera' is not known in a scene"},
    {"block_name", "Backgrund { }", ":1:1: ", "did you mean 'Background'"},
    {"second", "Background { }\nBackground { }", ":2:1: ", "a second 'Background'"},
    {"no_brace", "Background color 1 1 1", ":1:12: ", "expected '{' after Background, not 'color'"},
    {"cut", "Background { color 1 1", ":1:23: ", "not the end of the file"},
    {"word_for_number", "Background { color 1 red 1 }",
     ":1:22: ", "expected a number of the background's color, not 'red'"},
    {"nan", "Background { color 1 nan 1 }", ":1:22: ", "expected a finite number"},
    {"huge", "Background { color 1 1e60 1 }", ":1:22: ", "expected a finite number"},
    {"negative_color", "Background { color 1 -1 1 }", ":1:20: ", "is negative"},
    {"angle", "PerspectiveCamera { angle 200 }", ":1:27: ", "between 0 and 180"},
    {"width", "PerspectiveCamera { width 1e9 }", ":1:27: ", "a whole number from 1 to 16384"},
    {"camera_field", "PerspectiveCamera { centre 0 0 0 }", ":1:21: ", "did you mean 'center'"},
    {"fewer_materials", "Materials { numMaterials 2 Material { } }",
     ":1:41: ", "expected 'Material' after 1 of 2 materials"},
    {"more_materials", "Materials { numMaterials 1 Material { } Material { } }",
     ":1:41: ", "expected '}' after 1 materials"},
    {"absurd_materials", "Materials { numMaterials 99999999999 }", ":1:26: ", "a whole number"},
    {"type", "Materials { numMaterials 1 Material { type 0 0 0 } }", ":1:44: ", "type is 0 0 0"},
    {"texture_name", "Materials { numMaterials 1 Material { texture } }",
     ":1:47: ", "expected the path of a texture"},
    {"light", "Lights { numLights 1 SpotLight { } }", ":1:22: ", "expected PointLight or DirectionalLight"},
    {"light_direction", "Lights { numLights 1 DirectionalLight { direction 0 0 0 } }",
     ":1:51: ", "no direction"},
    {"index", group("MaterialIndex 1 Sphere { radius 1 }"), ":3:15: ", "a whole number from 0 to 0"},
    {"fewer_objects", group(""), ":2:1: ", "has 0 objects; numObjects promised 1"},
    {"more_objects", group("Sphere { radius 1 } Sphere { radius 1 }"), ":3:21: ", "more than the 1 objects"},
    {"open_group", "Group { numObjects 1", ":1:1: ", "never closed"},
    {"object", group("Cube { }"), ":3:1: ", "'Cube' is not known in Group"},
    {"radius", group("Sphere { radius -2 }"), ":3:17: ", "a radius > 0"},
    {"no_radius", group("Sphere { }"), ":3:1: ", "has no radius"},
    {"plane", group("Plane { normal 0 0 0 offset 1 }"), ":3:16: ", "no direction"},
    {"triangle", group("Triangle { vertex0 0 0 0 vertex1 1 0 0 }"), ":3:1: ", "lacks a vertex"},
    {"mesh", group("TriangleMesh { obj_file none.obj }"),
     ":3:25: ", "the mesh \"none.obj\" is missing, and nothing else is there"},
    {"flat", group("Transform { Scale 1 0 1 Sphere { radius 1 } }"), ":3:1: ", "flattens"},
    {"projective", group("Transform { Matrix4f { 1 0 0 0 0 1 0 0 0 0 1 1 0 0 0 1 } Sphere { radius 1 } }"),
     ":3:13: ", "projective"},
    {"rotate", group("Transform { Rotate { 0 0 0 90 } Sphere { radius 1 } }"), ":3:22: ", "no direction"},
    {"deep", group(nested("Transform { ", 10000, "Sphere { radius 1 }", "}")),
     ":3:", "nested deeper than 64"},
    {"deep_groups", nested("Group { numObjects 1 ", 10000, "", "}"), ":1:", "nested deeper than 64"},
    {"bezier", group("BezierCurve { controls [ 0 0 0 ] [ 1 1 1 ] }"), ":3:1: ", "3k + 1"},
    {"control", group("BezierCurve { controls [ 0 0 ] }"), ":3:30: ", "expected a number of a control point"},
};

INSTANTIATE_TEST_SUITE_P(Robust, MalformedText, testing::ValuesIn(kBadText), testName);

/// Loads `text` cut short and with single bytes changed: the result may be a scene or an error, never a crash
/// or a hang.
void damage(const std::string& text, const std::string& extension, size_t step, bool cutsMayBeScenes) {
    const TempFolder folder;
    const std::string name = "damaged" + extension;
    uint32_t state = 1;
    for (size_t at = 0; at < text.size(); at += step) {
        EXPECT_TRUE(!loadScene(folder.write(name, text.substr(0, at))) || cutsMayBeScenes) << "cut at " << at;
        state = state * 1664525u + 1013904223u;
        std::string flipped = text;
        flipped[at] = static_cast<char>(state >> 24);
        const auto scene = loadScene(folder.write(name, flipped), {.allowMissing = true});
        if (!scene.ok()) { EXPECT_FALSE(scene.error().message.empty()); }
    }
}

TEST(DamagedScene, JsonNeverCrashes) {
    damage(TempFolder::read(GLINT_SOURCE_DIR "/scenes/cornell.json"), ".json", 7, false);
    damage(TempFolder::read(GLINT_SOURCE_DIR "/scenes/veach_mis.json"), ".json", 13, false);
}

TEST(DamagedScene, TextNeverCrashes) {
    const std::string text =
        "Materials { numMaterials 2 Material { color 1 0 0 type 1 1 1 refr 1.5 } Material { emission 1 1 1 "
        "shininess 20} }\n"
        "Group { numObjects 3 MaterialIndex 1 Sphere { center 0 1 2 radius 3 } Transform { Translate 1 2 3 "
        "Rotate { 0 1 0"
        " 30 } Scale 1 2 3 Matrix4f { 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 } Group { numObjects 1 Plane { normal "
        "0 1 0 offset"
        " -2 } } } Triangle { vertex0 0 0 0 vertex1 1 0 0 vertex2 0 1 0 } }";
    const TempFolder folder;
    ASSERT_TRUE(loadScene(folder.write("whole.txt", text)));
    const std::string opening = "Lights { numLights 1 PointLight { position 0 0 0 color 1 1 1 } } ";
    damage(opening + text, ".txt", 3, true);  // A cut between two blocks leaves a scene.
}

}  // namespace
}  // namespace glint
