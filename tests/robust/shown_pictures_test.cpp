// What `glint render` shows where a file states no exposure, and as the original would have.
#include <gtest/gtest.h>

#include "engine/io/atomic_file.h"
#include "engine/io/image_io.h"
#include "tests/support/program_test.h"

namespace glint {
namespace {

using test::ProgramRun;
using test::runProgram;
using test::says;

class ShownPictures : public test::ProgramTest {
  protected:
    /// A room in which everything has that radiance, but for a black ball.
    std::string room(const std::string& radiance) {
        return folder.write("room.txt",
                            "PerspectiveCamera { center 0 0 5 direction 0 0 -1 up 0 1 0 angle 40 "
                            "width 24 height 24 aperture 0.5 focalLength 5 }\n"
                            "Background { color " +
                                radiance + " " + radiance + " " + radiance +
                                " }\n"
                                "Materials { numMaterials 1 Material { color 0 0 0 } }\n"
                                "Group { numObjects 1 Sphere { center 0 0 0 radius 1 } }\n");
    }
    ProgramRun render(const std::string& output, std::vector<std::string> more, const std::string& scene) {
        std::vector<std::string> all{"render", scene, "-o", folder.path(output), "--passes", "4"};
        all.insert(all.end(), more.begin(), more.end());
        const ProgramRun run = runProgram(all);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return run;
    }
    int corner(const std::string& picture) {
        const auto image = loadImage8(folder.path(picture));
        EXPECT_TRUE(image) << image.error().format();
        return image ? (*image)->rgb[0] : -1;
    }
    std::string bytes(const std::string& file) {
        const auto read = readFile(folder.path(file));
        return read ? *read : "";
    }
};

TEST_F(ShownPictures, WhatWouldBeWhiteOrBlackGetsAnExposure) {
    EXPECT_TRUE(
        says(render("white.png", {}, room("40")).out, "exposure -5.67 stops: the picture is white without"));
    EXPECT_NEAR(corner("white.png"), 230, 10);
    EXPECT_TRUE(says(render("black.png", {}, room("0.01")).out,
                     "exposure +6.33 stops: the picture is black without"));
    EXPECT_NEAR(corner("black.png"), 230, 10);
    EXPECT_FALSE(says(render("plain.png", {}, room("0.5")).out, "exposure"));
    EXPECT_EQ(corner("plain.png"), 188);
    // What the user states stays, and so does all that is not for the eye.
    render("off.png", {"--no-auto-exposure"}, room("40"));
    EXPECT_EQ(corner("off.png"), 255);
    render("stated.png", {"--exposure", "0"}, room("40"));
    EXPECT_EQ(bytes("stated.png"), bytes("off.png"));
    render("a.hdr", {}, room("40"));
    render("b.hdr", {"--no-auto-exposure"}, room("40"));
    EXPECT_EQ(bytes("a.hdr"), bytes("b.hdr"));
}

TEST_F(ShownPictures, AsTheOriginalIsAPresetThatOptionsChange) {
    const std::string scene = room("0.5");
    render("preset.hdr", {"--as-original"}, scene);
    render("spelt.hdr", {"--depth", "20", "--filter", "box", "--filter-radius", "1"}, scene);
    render("usual.hdr", {}, scene);
    EXPECT_EQ(bytes("preset.hdr"), bytes("spelt.hdr"));
    EXPECT_NE(bytes("preset.hdr"), bytes("usual.hdr"));
    render("preset.png", {"--as-original"}, scene);
    EXPECT_EQ(corner("preset.png"), 128) << "no gamma";
    render("tone.png", {"--as-original", "--tone", "srgb"}, scene);
    EXPECT_EQ(corner("tone.png"), 188);
}

}  // namespace
}  // namespace glint
