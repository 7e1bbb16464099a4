// Views of OpenColorIO configurations in place of the tone maps: pictures byte by byte, and what is wrong
// with a configuration.
#include <gtest/gtest.h>

#include "engine/render/ocio_view.h"
#include "engine/render/tonemap.h"
#include "tests/support/program_test.h"

namespace glint {
namespace {

using test::ProgramRun;
using test::runProgram;
using test::says;
using test::TempFolder;

/// `roles` and `spaces` are lines of a configuration; the view Swapped exchanges red and blue.
std::string configuration(const std::string& roles, const std::string& name) {
    return "ocio_profile_version: 2\nroles:\n  default: " + name + "\n" + roles +
           "file_rules:\n  - !<Rule> {name: Default, colorspace: default}\n"
           "displays:\n  Screen:\n    - !<View> {name: Plain, colorspace: " +
           name +
           "}\n    - !<View> {name: Swapped, colorspace: swapped}\n  Other:\n"
           "    - !<View> {name: Half, colorspace: half}\n"
           "active_displays: [Screen, Other]\nactive_views: []\ncolorspaces:\n  - !<ColorSpace>\n    name: " +
           name +
           "\n    bitdepth: 32f\n"
           "  - !<ColorSpace>\n    name: swapped\n    bitdepth: 32f\n"
           "    from_scene_reference: !<MatrixTransform> {matrix: [0,0,1,0, 0,1,0,0, 1,0,0,0, 0,0,0,1]}\n"
           "  - !<ColorSpace>\n    name: half\n    bitdepth: 32f\n    from_scene_reference: "
           "!<MatrixTransform> "
           "{matrix: [0.5,0,0,0, 0,0.5,0,0, 0,0,0.5,0, 0,0,0,1]}\n";
}

class Ocio : public test::ProgramTest {
  protected:
    void SetUp() override {
        if (!hasOcio()) { GTEST_SKIP() << "built without OpenColorIO"; }
        ProgramTest::SetUp();
        scene = folder.write("ball.json", R"({"glint": 1, "resolution": [32, 24],
            "camera": {"position": [0, 1, 4], "target": [0, 1, 0]},
            "materials": {"red": {"type": "diffuse", "color": [0.8, 0.3, 0.1]}},
            "objects": [{"type": "sphere", "material": "red", "center": [0.7, 1, 0], "radius": 0.9}],
            "environment": {"color": 0.7}})");
        config = folder.write("a:b.ocio", configuration("  scene_linear: lin_rec709\n", "lin_rec709"));
    }
    /// The PNG's bytes.
    std::string image(const std::vector<std::string>& more) const {
        std::vector<std::string> words{"render", scene, "-o", folder.path("p.png"), "--passes", "2"};
        words.insert(words.end(), more.begin(), more.end());
        const ProgramRun run = runProgram(words);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return TempFolder::read(folder.path("p.png"));
    }
    std::string scene, config;
};

TEST_F(Ocio, PicturesAreThoseOfTheView) {
    const std::string clamped = image({"--tone", "clamp", "--exposure", "0.5"});
    EXPECT_EQ(image({"--ocio", config, "--exposure", "0.5"}), clamped)
        << "the first view of the first display";
    EXPECT_EQ(image({"--ocio", config + ":Screen/Plain", "--exposure", "0.5"}), clamped);
    EXPECT_EQ(image({"--ocio", config + ":Other/", "--exposure", "1.5"}), clamped) << "half of a stop more";
    EXPECT_NE(image({"--ocio", config + ":Screen/Swapped", "--exposure", "0.5"}), clamped);
    const auto view = loadOcioView({config, "Screen", "Swapped"});
    ASSERT_TRUE(view) << view.error().format();
    const DisplayLook look{.exposureStops = 1.0f, .toneMap = ToneMap::Filmic, .view = *view};
    EXPECT_EQ(ToneMapper(look)({0.25f, 0.1f, -3.0f}), Vec3(0.0f, 0.2f, 0.5f));
}

TEST_F(Ocio, AcesIsAnInterchangeOfColours) {
    // The only space is ACES2065-1: what it shows of white is white, and of Rec.709's red what ACES says.
    const std::string aces = folder.write(
        "aces.ocio",
        configuration("  scene_linear: ACES2065-1\n  aces_interchange: ACES2065-1\n", "ACES2065-1"));
    const auto view = loadOcioView({aces, "", ""});
    ASSERT_TRUE(view) << view.error().format();
    const Vec3 white = (**view)(Vec3(0.5f)), red = (**view)({1.0f, 0.0f, 0.0f});
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(white[i], 0.5f, 1e-3f);
    }
    // The matrix of sRGB to ACES2065-1 with Bradford's adaptation, as ACES's own configurations have it.
    EXPECT_NEAR(red.x, 0.4396f, 1e-3f);
    EXPECT_NEAR(red.y, 0.0898f, 1e-3f);
    EXPECT_NEAR(red.z, 0.0175f, 1e-3f);
}

TEST_F(Ocio, WhatIsWrongIsSaid) {
    const auto refused = [&](const std::string& choice) {
        const ProgramRun run = runProgram({"render", scene, "-o", folder.path("p.png"), "--ocio", choice});
        EXPECT_EQ(run.exitCode, 1) << choice;
        return run.err;
    };
    EXPECT_TRUE(says(refused(config + ":Scren/Plain"), "no display 'Scren' (did you mean 'Screen'?)"));
    EXPECT_TRUE(says(refused(config + ":Screen/Filmic"), "no view 'Filmic'"));
    EXPECT_TRUE(says(refused(folder.path("none.ocio")), "none.ocio"));
    EXPECT_TRUE(says(refused(folder.write("odd.ocio", "ocio_profile_version: 9\n")), "odd.ocio"));
    const std::string before = TempFolder::read(config);
    EXPECT_EQ(runProgram({"render", scene, "-o", folder.path("p.png"), "--ocio", config, "--json", config})
                  .exitCode,
              1);
    EXPECT_EQ(TempFolder::read(config), before);
    const std::string other = folder.write("other.ocio", configuration("  scene_linear: own\n", "own"));
    const ProgramRun run =
        runProgram({"render", scene, "-o", folder.path("p.png"), "--passes", "1", "--ocio", other});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_TRUE(says(run.err, "scene_linear is taken for it"));
}

}  // namespace
}  // namespace glint
