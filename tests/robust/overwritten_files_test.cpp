// What a run reads is never written to, whatever option names it and however its name is written; two outputs
// are never one file; and what is there already is replaced by its own kind only.
#include <fmt/format.h>

#include "engine/io/image_io.h"
#include "tests/support/gltf_files.h"
#include "tests/support/program_test.h"

namespace glint {
namespace {

using test::ProgramRun;
using test::runProgram;
using test::says;
using test::TempFolder;

namespace fs = std::filesystem;

constexpr const char* kScene = R"({ "glint": 1, "resolution": [16, 16],
    "camera": { "position": [0, 0, 4], "target": [0, 0, 0] },
    "textures": { "wood": { "file": "maps/wood.png" }, "idle": { "file": "idle.png" } },
    "materials": { "lamp": { "type": "diffuse", "color": { "texture": "wood" } } },
    "objects": [{ "type": "sphere", "material": "lamp", "center": [0, 0, 0], "radius": 1 },
                { "type": "mesh", "mesh": "quad", "material": "lamp" }],
    "meshes": { "quad": { "file": "quad.obj" } },
    "environment": { "image": { "file": "sky.hdr" } } })";

class OverwrittenFiles : public test::ProgramTest {
  protected:
    void SetUp() override {
        ProgramTest::SetUp();
        fs::create_directory(folder.path("maps"));
        const Image8 wood{2, 1, {200, 100, 50, 20, 30, 40}};
        ASSERT_TRUE(savePng(folder.path("maps/wood.png"), wood));
        ASSERT_TRUE(savePng(folder.path("idle.png"), wood));
        ASSERT_TRUE(saveHdr(folder.path("sky.hdr"), ImageF{2, 1, {1, 1, 1, 1, 1, 1}}));
        folder.write("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
        scene = folder.write("a.json", kScene);
        fs::create_symlink("maps/wood.png", folder.path("link.png"));
        fs::create_hard_link(folder.path("sky.hdr"), folder.path("other-sky.hdr"));
        for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
            if (entry.is_regular_file()) { before[entry.path()] = TempFolder::read(entry.path()); }
        }
    }

    void expectRefused(const std::vector<std::string>& words, const std::string& message) {
        const ProgramRun run = runProgram(words);
        EXPECT_EQ(run.exitCode, 1) << testing::PrintToString(words) << run.err;
        EXPECT_TRUE(says(run.err, message));
        for (const auto& [path, bytes] : before) {
            ASSERT_EQ(TempFolder::read(path), bytes) << path << " by " << testing::PrintToString(words);
        }
    }
    std::string at(const char* name) const { return folder.path(name); }

    std::string scene;
    std::map<std::string, std::string> before;
};

TEST_F(OverwrittenFiles, NoInputOfARenderIsAnOutput) {
    const auto refuse = [&](const std::vector<std::string>& more, const std::string& message) {
        std::vector<std::string> words = {"render", scene, "--passes", "1"};
        words.insert(words.end(), more.begin(), more.end());
        expectRefused(words, message);
    };
    refuse({"-o", at("maps/wood.png")}, "is a texture of the scene");
    refuse({"-o", at("maps/../maps/./wood.png")}, "is a texture of the scene");
    refuse({"-o", at("link.png")}, "is a texture of the scene");
    refuse({"-o", at("idle.png")}, "is a texture of the scene");
    refuse({"-o", at("other-sky.hdr")}, "is the scene's environment");
    refuse({"-o", at("x.png"), "--checkpoint", scene}, "is the scene");
    refuse({"-o", at("x.png"), "--checkpoint", scene, "--overwrite"}, "is the scene");
    refuse({"-o", at("x.png"), "--checkpoint", at("quad.obj"), "--overwrite"}, "is a mesh of the scene");
    refuse({"-o", at("x.png"), "--json", scene}, "is not a report");
    EXPECT_FALSE(fs::exists(at("x.png")));
}

/// What a scene's files name themselves, and no scene remembers by its name.
TEST_F(OverwrittenFiles, WhatTheFilesOfASceneReadIsAnInputToo) {
    const auto refuse = [&](const char* opened, const char* output) {
        before[at(output)] = TempFolder::read(at(output));
        expectRefused({"render", at(opened), "--passes", "1", "-o", at("x.png"), "--checkpoint", at(output),
                       "--overwrite"},
                      "is a part of the scene, which is read");
    };
    folder.write("model.mtl", "newmtl red\nKd 1 0 0\n");
    folder.write("model.obj", "mtllib model.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
    refuse("model.obj", "model.mtl");
    folder.write("model.bin", test::packed<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}));
    folder.write("model.gltf", R"({ "asset": { "version": "2.0" }, "scenes": [{ "nodes": [0] }],
        "nodes": [{ "mesh": 0 }], "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 } }] }],
        "buffers": [{ "uri": "model.bin", "byteLength": 36 }],
        "bufferViews": [{ "buffer": 0, "byteLength": 36 }],
        "accessors": [{ "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                        "min": [0, 0, 0], "max": [1, 1, 0] }] })");
    refuse("model.gltf", "model.bin");
    folder.write("part.xml", R"(<scene version="3.0.0"><shape type="sphere"/></scene>)");
    folder.write("whole.xml", R"(<scene version="3.0.0"><include filename="part.xml"/></scene>)");
    refuse("whole.xml", "part.xml");
}

/// What the window opens later is an input when it saves at its end.
TEST_F(OverwrittenFiles, WhatAWindowOpensLaterIsAnInputToo) {
    ProgramRun run =
        runProgram({"render", scene, "-o", at("x.png"), "--passes", "1", "--checkpoint", at("a.glintfilm")});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const std::string wood = at("maps/wood.png"), old = TempFolder::read(wood);
    const std::string empty = folder.write("e.json", R"({ "glint": 1, "resolution": [8, 8],
        "camera": { "position": [0, 0, 4], "target": [0, 0, 0] }, "environment": { "color": 1 } })");
    const std::string script = folder.write("drop.txt", "drop \"" + scene + "\"\nwait jobs\nwait passes 2\n");
    const std::vector<std::string> runs[] = {
        {"view", at("a.glintfilm"), "--headless", "--passes", "2", "--output", wood},
        {"view", at("a.glintfilm"), "--headless", "--passes", "2", "--screenshot", wood},
        {"view", empty, "--headless", "--passes", "3", "--script", script, "--output", wood}};
    for (const std::vector<std::string>& words : runs) {
        run = runProgram(words);
        if (run.exitCode == 2 && says(run.err, "this build has no window")) { GTEST_SKIP(); }
        EXPECT_NE(run.exitCode, 0) << testing::PrintToString(words);
        EXPECT_TRUE(says(run.err, "is a texture of the scene"));
        EXPECT_EQ(TempFolder::read(wood), old) << testing::PrintToString(words);
    }
}

TEST_F(OverwrittenFiles, AConvergeReportIsNoneOfItsFolder) {
    fs::create_directory(at("cv"));
    for (const char* name : {"reference.exr", "plot.svg", "index.html", "pictures"}) {
        expectRefused({"converge", scene, "--make-reference", "0.1", "--passes", "1", "--integrators", "pt",
                       "--out", at("cv"), "--json", at("cv/") + name},
                      "two outputs go to one file");
    }
}

TEST_F(OverwrittenFiles, NoInputOfAnyOtherCommandIsAnOutput) {
    const std::string wood = at("maps/wood.png");
    expectRefused({"info", "--json", scene, at("a.json")}, "is not a report");
    expectRefused({"diff", "--json", wood, at("idle.png"), at("link.png")}, "is not a report");
    expectRefused({"convert", scene, at("maps/../a.json")}, "is the scene");
    before[at("part.xml")] = "<scene version=\"3.0.0\"/>";
    folder.write("part.xml", before[at("part.xml")]);
    expectRefused({"convert", scene, at("part.xml")}, "is there already");
    before[at("part.gltf")] = "{\"asset\": {\"version\": \"2.0\", \"generator\": \"Blender\"}}";
    folder.write("part.gltf", before[at("part.gltf")]);
    expectRefused({"convert", scene, at("part.gltf")}, "is there already");
    for (int times = 0; times < 2; ++times) {
        for (const char* own : {"own.xml", "own.gltf", "own.glb"}) {
            const ProgramRun run = runProgram({"convert", scene, at(own)});
            EXPECT_EQ(run.exitCode, 0) << "its own is replaced: " << run.err;
        }
    }
    EXPECT_FALSE(fs::exists(at("own-2.bin"))) << "the buffer is the same";
    before[at("notes.json")] = "{\"notes\": 1}";
    folder.write("notes.json", before[at("notes.json")]);
    expectRefused({"convert", scene, at("notes.json")}, "is there already");
    expectRefused({"bench", "passes", scene, "--json", scene}, "is not a report");
    expectRefused({"stress", "--quick", "--filter", "recurrence", "--html", scene}, "is not a page");
    expectRefused({"view", scene, "--headless", "--passes", "1", "--output", wood},
                  "is a texture of the scene");
    expectRefused({"view", scene, "--headless", "--passes", "1", "--screenshot", wood},
                  "is a texture of the scene");
    expectRefused({"view", scene, "--headless", "--passes", "1", "--json", scene}, "is not a report");
    fs::create_directory(at("out"));
    fs::copy_file(wood, at("out/flip.png"));
    before[at("out/flip.png")] = TempFolder::read(wood);
    expectRefused({"diff", at("out/flip.png"), wood, "--maps", at("out")}, "is the picture in question");
    fs::rename(at("sky.hdr"), at("out/plot.png"));
    before.erase(at("sky.hdr"));
    const auto refuseConvergeBeside = [&](const std::string& environment, const std::string& message) {
        const std::string moved = folder.write("moved.json", R"({ "glint": 1, "resolution": [8, 8],
            "camera": { "position": [0, 0, 4], "target": [0, 0, 0] },
            "environment": { "image": { "file": ")" + environment +
                                                                 R"(" } } })");
        expectRefused({"converge", moved, "--make-reference", "0.1", "--passes", "1", "--out", at("out"),
                       "--overwrite", "--integrators", "pt"},
                      message);
    };
    refuseConvergeBeside("out/plot.png", "is the scene's environment");
    fs::create_directories(at("out/pictures/older"));
    fs::rename(at("out/plot.png"), at("out/pictures/older/sky.png"));
    refuseConvergeBeside("out/pictures/older/sky.png", "holds the scene's environment");
    fs::create_symlink("out/pictures/older/sky.png", at("linked.png"));
    refuseConvergeBeside("linked.png", "holds the scene's environment");
}

TEST_F(OverwrittenFiles, TwoOutputsAreNeverOneFile) {
    fs::current_path(folder.path());
    fs::create_symlink("zz.png", at("same.png"));
    for (const std::string& other : {std::string("./zz.png"), at("zz.png"), at("same.png")}) {
        expectRefused({"render", scene, "--passes", "1", "-o", "zz.png", "--checkpoint", other},
                      "two outputs go to one file");
        expectRefused({"render", scene, "--passes", "1", "-o", other, "--checkpoint", "zz.png"},
                      "two outputs go to one file");
    }
    expectRefused({"stress", "--quick", "--filter", "recurrence", "--html", "s.x", "--json", "./s.x"},
                  "two outputs go to one file");
    EXPECT_EQ(
        runProgram({"render", scene, "--passes", "1", "-o", "zz.png", "--checkpoint", "/dev/null"}).exitCode,
        0);
    fs::current_path("/");
}

TEST_F(OverwrittenFiles, ReportsReplaceReportsAndEmptyFilesOnly) {
    const std::string report = folder.write("report.json", "");
    for (const char* command : {"info", "info"}) {
        EXPECT_EQ(runProgram({command, scene, "--json", report}).exitCode, 0);
        EXPECT_TRUE(says(TempFolder::read(report), "\"report\": \"info\""));
    }
    EXPECT_EQ(runProgram({"diff", at("idle.png"), at("idle.png"), "--json", report}).exitCode, 0);
    EXPECT_TRUE(says(TempFolder::read(report), "\"report\": \"diff\""));
    EXPECT_EQ(runProgram({"info", scene, "--json", "/dev/null"}).exitCode, 0);
}

TEST_F(OverwrittenFiles, AShorterFilmDoesNotReplaceALongerOne) {
    const std::string film = at("a.film"), image = at("x.png");
    const auto render = [&](const char* passes, const std::vector<std::string>& more = {}) {
        std::vector<std::string> words = {"render",       scene, "-o",       image,
                                          "--checkpoint", film,  "--passes", passes};
        words.insert(words.end(), more.begin(), more.end());
        return runProgram(words);
    };
    ASSERT_EQ(render("8").exitCode, 0);
    const std::string longer = TempFolder::read(film);
    const ProgramRun shorter = render("4");
    EXPECT_EQ(shorter.exitCode, 1);
    EXPECT_TRUE(says(shorter.err, "holds a film of 8 passes"));
    EXPECT_TRUE(says(shorter.err, "--overwrite"));
    EXPECT_EQ(TempFolder::read(film), longer);
    const std::string empty = folder.write("e.json", R"({ "glint": 1, "resolution": [8, 8],
        "camera": { "position": [0, 0, 4], "target": [0, 0, 0] } })");
    expectRefused({"render", empty, "-o", image, "--checkpoint", film, "--passes", "4"},
                  "holds a film of 8 passes");
    EXPECT_EQ(TempFolder::read(film), longer) << "of another scene";
    EXPECT_EQ(render("8").exitCode, 0) << "one as long";
    EXPECT_EQ(render("12", {"--resume", film}).exitCode, 0);
    EXPECT_EQ(render("2", {"--overwrite"}).exitCode, 0);
    const std::string notes = folder.write("notes.txt", "not a checkpoint");
    const ProgramRun other =
        runProgram({"render", scene, "-o", image, "--checkpoint", notes, "--passes", "4"});
    EXPECT_EQ(other.exitCode, 1);
    EXPECT_TRUE(says(other.err, "is not a Glint checkpoint"));
    EXPECT_EQ(TempFolder::read(notes), "not a checkpoint");
}

TEST_F(OverwrittenFiles, AFilmDoesNotReplaceOneOfAnotherScene) {
    const std::string film = at("a.film"), image = at("x.png");
    ASSERT_EQ(runProgram({"render", scene, "-o", image, "--checkpoint", film, "--passes", "2"}).exitCode, 0);
    before[film] = TempFolder::read(film);
    const std::string other = folder.write("e.json", R"({ "glint": 1, "resolution": [8, 8],
        "camera": { "position": [0, 0, 4], "target": [0, 0, 0] } })");
    expectRefused({"render", other, "-o", image, "--checkpoint", film, "--passes", "8"},
                  "holds a film of another scene, a.json");
    const auto render = [&](const std::string& path, const std::vector<std::string>& more) {
        std::vector<std::string> words = {"render", path, "-o", image, "--passes", "8", "--checkpoint", film};
        words.insert(words.end(), more.begin(), more.end());
        return runProgram(words).exitCode;
    };
    EXPECT_EQ(render(scene, {"--seed", "7"}), 0) << "the same file, with other settings";
    EXPECT_EQ(render(folder.write("copy.json", TempFolder::read(scene)), {}), 0) << "shows the same";
    EXPECT_EQ(render(other, {"--overwrite"}), 0);
}

TEST_F(OverwrittenFiles, TheWindowSavesOverNoInput) {
    const auto script = [&](const std::string& text) { return folder.write("script.txt", text); };
    const std::string wood = at("maps/wood.png");
    const std::string saves = fmt::format(
        "wait finished\nopen \"Checkpoint\"\nwait frames 3\n"
        "set \"Scene file\" {0}\nclick \"Save scene\"\nwait jobs\nexpect message \"is the scene, which is "
        "read\"\n"
        "set \"PNG file\" {1}\nclick \"Save PNG\"\nwait jobs\nexpect message \"is a texture of the scene\"\n"
        "set \"Checkpoint file\" {0}\nclick \"Checkpoint/Save\"\nwait jobs\nexpect message \"is the scene\"\n"
        "set \"Checkpoint file\" {2}\nclick \"Checkpoint/Save\"\nwait frames 3\nclick \"Replace\"\nwait "
        "jobs\nexpect message \"is not a Glint "
        "checkpoint\"\n",
        scene, wood, folder.write("notes.txt", "text"));
    const ProgramRun run =
        runProgram({"view", scene, "--headless", "--passes", "2", "--script", script(saves)});
    if (run.exitCode == 2 && says(run.err, "this build has no window")) { GTEST_SKIP(); }
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(TempFolder::read(at("notes.txt")), "text");
    const std::string self = script("wait finished\nscreenshot \"" + at("script.txt") + "\"\n");
    expectRefused({"view", scene, "--headless", "--passes", "2", "--script", self}, "is the script");
    const std::string waits = script("wait finished\n");
    expectRefused({"view", scene, "--headless", "--passes", "2", "--script", waits, "--screenshot", wood},
                  "is a texture of the scene");
}

}  // namespace
}  // namespace glint
