// Mitsuba scenes that are broken or made to break: one error that names its place, bounded memory, and never
// a crash.

#include "engine/io/image_io.h"
#include "tests/support/damaged_text.h"
#include "tests/support/mitsuba_test.h"

namespace glint::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

using MalformedMitsuba = MitsubaTest;

std::string repeated(const std::string& text, size_t times) {
    std::string out;
    for (size_t i = 0; i < times; ++i) {
        out += text;
    }
    return out;
}

TEST_F(MalformedMitsuba, FilesGiveOneErrorThatNamesThePlace) {
    const std::pair<std::string, const char*> contents[] = {
        {"<shape type='sphere'>", "bad.xml:3:"},
        {"<shape type='sphere'></bsdf>", "bad.xml:2:"},
        {"<shape type='nothing'/>", "bad.xml:2:1: Glint has no shape \"nothing\""},
        {"<shape type='sphere'><bsdf type='nothing'/></shape>",
         "bad.xml:2:22: Glint has no bsdf \"nothing\""},
        {"<emitter type='nothing'/>", "Glint has no emitter \"nothing\""},
        {"<sensor type='nothing'/>", "Glint has no sensor \"nothing\""},
        {"<shape type='sphere'><float name='radius' value='much'/></shape>", "\"much\" is no finite number"},
        {"<shape type='sphere'><float name='radius' value='inf'/></shape>", "\"inf\" is no finite number"},
        {"<shape type='sphere'><point name='center' value='1 2'/></shape>", "2 numbers; expected 1 or 3"},
        {"<shape type='sphere'><boolean name='flip_normals' value='7'/></shape>", "neither true nor false"},
        {"<shape type='sphere'><transform name='to_world'><matrix value='1 2'/></transform></shape>",
         "2 numbers; expected 9 or 16"},
        {"<shape type='sphere'><transform name='to_world'><rotate angle='3'/></transform></shape>",
         "no axis"},
        {"<shape type='sphere'><transform name='to_world'><bend/></transform></shape>",
         "<bend> is no transform"},
        {"<shape type='sphere'><transform name='to_world'><matrix value='1 0 0 0 0 1 0 0 0 0 1 0 1 1 1 1'/>"
         "</transform></shape>",
         "not affine"},
        {"<emitter type='constant'><rgb name='radiance' value='#12'/></emitter>", "is no colour"},
        {"<emitter type='constant'><spectrum name='radiance' value='400:1 300:2'/></emitter>",
         "wavelengths rising"},
        {"<shape type='obj'/>", "has no \"filename\""},
        {"<shape type='instance'/>", "names no shapegroup"},
        {"<shape type='sphere'><bsdf type='twosided'/></shape>", "holds no bsdf"},
        {"<bsdf type='twosided' id='a'><ref id='b'/></bsdf><bsdf type='twosided' id='b'><ref id='a'/></bsdf>"
         "<shape type='sphere'><ref id='a'/></shape>",
         "in a circle"},
        {"<include filename='bad.xml'/>", "bad.xml:2:1: \""},
        {"<include filename='none.xml'/>", "cannot include"},
        {repeated("<a>", 100'000) + repeated("</a>", 100'000), "nested deeper than 100 levels"},
        {repeated("<a>", 100'000), "bad.xml:"}};
    for (const auto& [content, message] : contents) {
        EXPECT_THAT(errorOf(content), AllOf(HasSubstr(message), HasSubstr("bad.xml")))
            << content.substr(0, 200);
    }
}

TEST_F(MalformedMitsuba, EntitiesAreNotExpanded) {
    std::string text = "<!DOCTYPE scene [<!ENTITY a0 'aaaaaaaaaa'>";
    for (int i = 1; i < 12; ++i) {
        text +=
            "<!ENTITY a" + std::to_string(i) + " '" + repeated("&a" + std::to_string(i - 1) + ";", 10) + "'>";
    }
    text += "]><scene version='3.0.0'>&a11;</scene>";
    const auto scene = loadScene(folder.write("bomb.xml", text));
    ASSERT_FALSE(scene);
    EXPECT_THAT(scene.error().format(), HasSubstr("declares entities"));
}

TEST_F(MalformedMitsuba, IncludesAndParametersStayBounded) {
    folder.write("one.xml", "<scene version='3.0.0'><include filename='two.xml'/></scene>");
    folder.write("two.xml", "<scene version='3.0.0'><include filename='one.xml'/></scene>");
    EXPECT_THAT(errorOf("<include filename='one.xml'/>"), HasSubstr("two.xml:1:24: \""));
    std::string doubling = "<default name='p0' value='0123456789'/>";
    for (int i = 1; i < 60; ++i) {
        const std::string before = "$p" + std::to_string(i - 1);
        doubling += "<default name='p" + std::to_string(i) + "' value='" + before + " " + before + "'/>";
    }
    EXPECT_THAT(errorOf(doubling), HasSubstr("more than 256 MiB"));
    for (int i = 0; i < 12; ++i) {  // 10^11 elements
        folder.write("level" + std::to_string(i) + ".xml",
                     "<scene version='3.0.0'>" +
                         repeated("<include filename='level" + std::to_string(i + 1) + ".xml'/>", 10) +
                         "</scene>");
    }
    folder.write("level12.xml", "<scene version='3.0.0'>" + repeated("<a/>", 10'000) + "</scene>");
    EXPECT_THAT(errorOf("<include filename='level6.xml'/>"), HasSubstr("more than 4000000 elements"));
}

const std::string kGood = R"(<scene version="2.1.0"><default name="r" value="1"/>
<integrator type="path"><integer name="max_depth" value="5"/></integrator>
<sensor type="thinlens"><float name="fov" value="40"/><float name="aperture_radius" value="0.1"/>
<transform name="to_world"><lookat origin="0,0,5" target="0,0,0" up="0,1,0"/></transform>
<film type="hdrfilm"><integer name="width" value="16"/><integer name="height" value="9"/></film></sensor>
<texture type="checkerboard" id="board"><rgb name="color0" value="#336699"/><float name="color1" value="0.5"/>
<transform name="to_uv"><scale x="2" y="3"/><rotate z="1" angle="30"/></transform></texture>
<bsdf type="twosided" id="two"><bsdf type="roughplastic"><float name="alpha" value="0.2"/>
<ref name="diffuse_reflectance" id="board"/></bsdf></bsdf>
<bsdf type="mask" id="cut"><float name="opacity" value="0.5"/><bsdf type="blendbsdf"><float name="weight" value="0.3"/>
<bsdf type="diffuse"/><bsdf type="conductor"><string name="material" value="Au"/></bsdf></bsdf></bsdf>
<shape type="shapegroup" id="group"><shape type="cube"><ref id="two"/></shape><shape type="disk"/></shape>
<shape type="instance"><ref id="group"/><transform name="to_world"><rotate y="1" angle="20"/></transform></shape>
<shape type="sphere"><float name="radius" value="$r"/><ref id="cut"/><emitter type="area">
<spectrum name="radiance" value="400:1, 500:2.5, 700:1"/></emitter></shape>
<shape type="cylinder"><point name="p1" x="1" y="2" z="3"/><bsdf type="dielectric"><string name="int_ior"
value="water"/></bsdf></shape><emitter type="spot"><float name="cutoff_angle" value="30"/><blackbody name="intensity"
temperature="5000K"/></emitter><emitter type="constant"><rgb name="radiance" value="0.1 0.2,0.3"/></emitter><emitter type="projector"><texture
type="bitmap" name="irradiance"><string name="filename" value="p.png"/></texture><float name="fov" value="30"/></emitter>
<shape type="sphere"><animation name="to_world"><transform time="0"><translate x="1"/></transform></animation></shape></scene>)";

TEST_F(MalformedMitsuba, DamagedFilesNeverCrash) {
    ASSERT_TRUE(savePng(folder.path("p.png"), {2, 1, {255, 255, 255, 255, 0, 0}}));
    ASSERT_TRUE(loadScene(folder.write("good.xml", kGood)));
    constexpr std::string_view kOften = "0123456789-<>/=\"' .,$&e";
    EXPECT_GT(openDamagedScenes(folder, "damaged.xml", kGood, kOften), 40);
}

}  // namespace
}  // namespace glint::test
