// The program as its users meet it: exit codes, messages, files that cannot be written, reports.
#include <nlohmann/json.hpp>

#include "engine/report/convergence_variant.h"
#include "tests/support/program_test.h"

namespace glint {
namespace {

using test::ProgramRun;
using test::runProgram;
using test::says;
using test::TempFolder;

using CommandLine = test::ProgramTest;

const std::string kCornell = GLINT_SOURCE_DIR "/scenes/cornell.json";

TEST_F(CommandLine, HelpAndVersionSucceed) {
    for (const char* command : {"view", "render", "info", "diff", "convert", "bench"}) {
        const ProgramRun help = runProgram({command, "--help"});
        EXPECT_EQ(help.exitCode, 0);
        EXPECT_TRUE(says(help.out, "--help"));
    }
    EXPECT_TRUE(says(runProgram({"--help"}).out, "Exit codes"));
    EXPECT_TRUE(says(runProgram({"--version"}).out, "glint 0"));
}

TEST_F(CommandLine, UnknownOptionsNameTheNearest) {
    const ProgramRun option = runProgram({"render", kCornell, "-o", folder.path("a.png"), "--pases", "3"});
    EXPECT_EQ(option.exitCode, 1);
    EXPECT_TRUE(says(option.err, "--passes"));
    const ProgramRun command = runProgram({"rendr", kCornell});
    EXPECT_EQ(command.exitCode, 1);
    EXPECT_TRUE(says(command.err, "'render'"));
    const ProgramRun aov = runProgram({"render", kCornell, "-o", folder.path("a.exr"), "--aov", "albedoo"});
    EXPECT_EQ(aov.exitCode, 1);
    EXPECT_TRUE(says(aov.err, "albedo'"));
}

TEST_F(CommandLine, BadValuesAreRefusedWithOneMessage) {
    const std::string out = folder.path("a.png");
    const std::vector<std::vector<std::string>> bad = {
        {"--passes", "0"},
        {"--passes", "many"},
        {"--size", "12"},
        {"--size", "0x5"},
        {"--time", "-1"},
        {"--filter", "sinc"},
        {"--tone", "loud"},
        {"--threads", "0"},
        {"--backend", "gpu"},
        {"--camera-target", "1,2"},
        {"--aov", "depth"},
        {"--checkpoint-every", "5s"},
        {"--fov", "180"},
        {"--sampler", "halton"},
        {"--exposure", "bright"},
        {"--resume", folder.path("none")},
        {"--exposure", "nan"},
        {"--time", "nan"},
        {"--focus", "inf"},
        {"--pass", "3"},
        {"--checkpoint", out},
        {"--checkpoint-every", "0"},
        {"--checkpoint-every", "often"},
        {"--checkpoint-every", "-3"},
        {"--checkpoint-every", "2m"},
    };
    for (const auto& words : bad) {
        std::vector<std::string> arguments = {"render", kCornell, "-o", out};
        arguments.insert(arguments.end(), words.begin(), words.end());
        const ProgramRun run = runProgram(arguments);
        EXPECT_EQ(run.exitCode, 1) << words[0] << " " << words[1] << ": " << run.err;
        EXPECT_FALSE(run.err.empty());
    }
    EXPECT_EQ(folder.size(), 0u) << "a refused run must leave nothing behind";
}

/// As scripts give them whose variable is not set.
TEST_F(CommandLine, EmptyValuesAreRefused) {
    for (const char* option :
         {"--filter", "--size", "--fov", "--resume", "--checkpoint", "--checkpoint-every", "--passes",
          "--time", "--pixel", "--aov", "--tone", "--camera-target"}) {
        const ProgramRun run = runProgram({"render", kCornell, "-o", folder.path("a.png"), option, ""});
        EXPECT_EQ(run.exitCode, 1) << option << ": " << run.err;
        EXPECT_TRUE(says(run.err, option)) << run.err;
    }
    EXPECT_EQ(runProgram({"render", "", "-o", folder.path("a.png")}).exitCode, 1);
    EXPECT_EQ(runProgram({"render", kCornell, "-o", ""}).exitCode, 1);
    EXPECT_EQ(folder.size(), 0u);
}

TEST_F(CommandLine, WordsOfSettingsIgnoreCase) {
    const std::string out = folder.path("a.png");
    for (const char* name : {"PT", "Sppm", "ptt", "sppn"}) {
        const ProgramRun run = runProgram(
            {"render", kCornell, "-o", out, "--integrator", name, "--size", "8x8", "--passes", "1"});
        const bool isRight = std::string_view(name) == "PT" || std::string_view(name) == "Sppm";
        EXPECT_EQ(run.exitCode, isRight ? 0 : 1) << name << run.err;
        EXPECT_EQ(says(run.err, "did you mean '"), !isRight) << name << run.err;
    }
    EXPECT_TRUE(parseVariant("PT:sampler=Independent"));
}

TEST_F(CommandLine, ANameThatIsOnlyAnEndingLacksTheRest) {
    const std::vector<std::vector<std::string>> commands = {{"render", kCornell, "-o", ".png"},
                                                            {"render", kCornell, "-o", folder.path(".exr")},
                                                            {"convert", kCornell, folder.path(".json")}};
    for (const std::vector<std::string>& words : commands) {
        const ProgramRun run = runProgram(words);
        EXPECT_EQ(run.exitCode, 1);
        EXPECT_TRUE(says(run.err, "expected a name before the ending"));
    }
}

/// Four passes of a picture without noise.
TEST_F(CommandLine, AnErrorOfZeroIsNotUnknown) {
    const std::string scene = folder.write("dark.json", R"({ "glint": 1, "resolution": [8, 8],
        "camera": { "position": [0, 0, 4], "target": [0, 0, 0] } })");
    const ProgramRun run =
        runProgram({"render", scene, "-o", folder.path("a.png"), "--passes", "4", "--error", "0.01"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_TRUE(says(run.out, "picture error 0.00 %"));
    EXPECT_TRUE(says(run.out, "an error below 1 % is confirmed by more passes only"));
    EXPECT_FALSE(says(run.out, "not known"));
}

TEST_F(CommandLine, BadScenesAreRefusedWithTheirPlace) {
    const std::string scene =
        folder.write("bad.json", "{ \"glint\": 1,\n  \"camera\": { \"positon\": [0, 1, 2] }\n}\n");
    for (const char* command : {"render", "info"}) {
        std::vector<std::string> arguments = {command, scene};
        if (std::string(command) == "render") {
            arguments.insert(arguments.end(), {"-o", folder.path("a.png")});
        }
        const ProgramRun run = runProgram(arguments);
        EXPECT_EQ(run.exitCode, 1);
        EXPECT_TRUE(says(run.err, "bad.json:2:"));
        EXPECT_TRUE(says(run.err, "position"));
    }
    EXPECT_EQ(runProgram({"info", folder.path("missing.json")}).exitCode, 1);
}

TEST_F(CommandLine, WhatCannotBeWrittenIsRefusedBeforeRendering) {
    // So many passes that the test would not end if it began to render.
    const std::vector<std::string> render = {"render", kCornell, "--passes", "100000000"};
    const auto with = [&](std::vector<std::string> more) {
        std::vector<std::string> all = render;
        all.insert(all.end(), more.begin(), more.end());
        return runProgram(all);
    };
    const std::string nowhere = folder.path("no/such/folder/a.png");
    EXPECT_EQ(with({"-o", nowhere}).exitCode, 1);
    EXPECT_TRUE(says(with({"-o", nowhere}).err, "does not exist"));
    EXPECT_EQ(with({"-o", folder.path()}).exitCode, 1);
    EXPECT_EQ(with({"-o", folder.path("a.bmp")}).exitCode, 1);
    EXPECT_EQ(with({}).exitCode, 1);
    EXPECT_EQ(with({"-o", folder.path("a.png"), "--checkpoint", nowhere}).exitCode, 1);
    EXPECT_EQ(with({"-o", folder.path("a.png"), "--json", nowhere}).exitCode, 1);
}

TEST_F(CommandLine, AFullDiskIsAFailedRun) {
    const std::vector<std::string> render = {"render", kCornell, "-o",       folder.path("a.png"),
                                             "--size", "16x16",  "--passes", "1"};
    for (const char* option : {"--json", "--checkpoint"}) {
        std::vector<std::string> arguments = render;
        arguments.insert(arguments.end(), {option, "/dev/full"});
        const ProgramRun run = runProgram(arguments);
        EXPECT_EQ(run.exitCode, 2) << option;
        EXPECT_TRUE(says(run.err, "/dev/full"));
    }
    EXPECT_FALSE(TempFolder::read(folder.path("a.png")).empty()) << "the picture must be saved all the same";
}

TEST_F(CommandLine, ConvertedScenesGiveTheSameImage) {
    const std::string converted = folder.path("copy.json");
    ASSERT_EQ(runProgram({"convert", kCornell, converted}).exitCode, 0);
    const auto image = [&](const std::string& scene, const char* name) {
        const std::string out = folder.path(name);
        const ProgramRun run = runProgram({"render", scene, "-o", out, "--size", "40x40", "--passes", "2"});
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return TempFolder::read(out);
    };
    EXPECT_EQ(image(kCornell, "a.hdr"), image(converted, "b.hdr"));

    const std::string object = folder.write("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    const std::string scene = folder.path("quad.json");
    ASSERT_EQ(runProgram({"convert", object, scene}).exitCode, 0);
    EXPECT_EQ(image(object, "c.hdr"), image(scene, "d.hdr"));
}

TEST_F(CommandLine, ConvertRefusesWhatItCannotReadOrWrite) {
    EXPECT_EQ(runProgram({"convert", folder.path("none.obj"), folder.path("a.json")}).exitCode, 1);
    EXPECT_EQ(runProgram({"convert", kCornell, folder.path("a.obj")}).exitCode, 1);
    EXPECT_EQ(runProgram({"convert", kCornell, folder.path("no/folder/a.json")}).exitCode, 1);
    EXPECT_EQ(runProgram({"convert", kCornell}).exitCode, 1);
    EXPECT_EQ(folder.size(), 0u);
}

TEST_F(CommandLine, RenderWritesImagesAndAReport) {
    for (const char* name : {"a.png", "a.hdr", "a.exr", "b.PNG", "b.Hdr"}) {
        const std::string image = folder.path(name);
        const ProgramRun run =
            runProgram({"render", kCornell, "-o", image, "--size", "32x24", "--passes", "3", "--json", "-"});
        ASSERT_EQ(run.exitCode, 0) << run.err;
        EXPECT_FALSE(TempFolder::read(image).empty());
        const auto report = nlohmann::json::parse(run.out, nullptr, false);
        ASSERT_FALSE(report.is_discarded()) << run.out;
        EXPECT_EQ(report["passes"], 3);
        EXPECT_EQ(report["width"], 32);
        EXPECT_EQ(report["height"], 24);
        EXPECT_GT(report["render_seconds"].get<double>(), 0.0);
    }
    const std::string json = folder.path("report.json");
    const ProgramRun run =
        runProgram({"render", kCornell, "-o", folder.path("b.exr"), "--size", "16x16", "--passes", "2",
                    "--aov", "albedo,depth,standard-error", "--json", json});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_FALSE(nlohmann::json::parse(TempFolder::read(json), nullptr, false).is_discarded());
    EXPECT_TRUE(says(TempFolder::read(folder.path("b.exr")), "albedo.R"));
}

TEST_F(CommandLine, ThreadsChangeNoByteOfTheImage) {
    const auto image = [&](const char* threads) {
        const std::string path = folder.path(std::string("t") + threads + ".exr");
        const ProgramRun run =
            runProgram({"render", kCornell, "-o", path, "--exr-float", "--size", "40x30", "--passes", "4",
                        "--threads", threads, "--checkpoint", path + ".film"});
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return path;
    };
    // The EXR says how long it took, so the films are compared by rendering on from them: see the resume
    // test. Here the tone-mapped pictures are, which hold nothing but pixels.
    const auto png = [&](const char* threads) {
        const std::string path = folder.path(std::string("t") + threads + ".png");
        EXPECT_EQ(runProgram({"render", kCornell, "-o", path, "--size", "40x30", "--passes", "4", "--threads",
                              threads})
                      .exitCode,
                  0);
        return TempFolder::read(path);
    };
    EXPECT_FALSE(TempFolder::read(image("1")).empty());
    const std::string one = png("1");
    EXPECT_EQ(one, png("2"));
    EXPECT_EQ(one, png("3"));
}

TEST_F(CommandLine, ADroppedSampleNamesTheCommandThatRepeatsIt) {
    const std::string scene = folder.write("it's bright.json", R"({ "glint": 1,
        "camera": { "position": [0, 0, 3], "target": [0, 0, 0], "verticalFovDeg": 40 },
        "materials": { "lamp": { "type": "diffuse", "emission": 3e38, "emissionStrength": 10 } },
        "objects": [{ "type": "sphere", "material": "lamp", "center": [0, 0, 0], "radius": 0.9 }] })");
    const ProgramRun run = runProgram({"render", scene, "-o", folder.path("a.png"), "--passes", "1", "--size",
                                       "8x8", "--camera-position", "0,0,4", "--fov", "20"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_TRUE(says(run.err, "it'\\''s bright.json' --size 8x8 --camera-position 0,0,4 --fov 20 --pixel "))
        << run.err;
    const ProgramRun replay = runProgram({"render", scene, "--size", "8x8", "--camera-position", "0,0,4",
                                          "--fov", "20", "--pixel", "4,4", "--pass", "0"});
    EXPECT_EQ(replay.exitCode, 0) << replay.err;
    EXPECT_TRUE(says(replay.out, "dropped: infinite")) << replay.out;
}

TEST_F(CommandLine, ReplayPrintsThePathOfOnePixel) {
    const ProgramRun run =
        runProgram({"render", kCornell, "--size", "32x32", "--pixel", "16,20", "--pass", "5"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_TRUE(says(run.out, "radiance"));
    EXPECT_EQ(runProgram({"render", kCornell, "--size", "32x32", "--pixel", "32,0"}).exitCode, 1);
    EXPECT_EQ(runProgram({"render", kCornell, "--pixel", "middle"}).exitCode, 1);
}

}  // namespace
}  // namespace glint
