// The references of `glint converge` as its users meet them: made, used again, given, refused.
#include <filesystem>
#include <limits>

#include "engine/io/exr_io.h"
#include "tests/support/converge_test.h"
#include "tests/support/formula_images.h"

namespace glint {
namespace {

using nlohmann::json;
using test::ProgramRun;
using test::says;
using test::TempFolder;

using ConvergeReference = test::ConvergeCommand;

TEST_F(ConvergeReference, TheReferenceSaysWhatItIsAndIsUsedAgain) {
    ASSERT_EQ(converge(with({"--integrators", "pt,sppm:photons=500"})).exitCode, 0);
    const auto reference = loadExr(file("reference.exr"));
    ASSERT_TRUE(reference);
    for (const char* channel : {"R", "standardError.R", "standardError.Y"}) {
        EXPECT_NE(reference->find(channel), nullptr) << channel;
    }
    for (const char* name : {"sceneHash", "referenceMethod", "referenceSeconds", "referenceStandardError",
                             "referenceSeeds", "setting.maxDepth"}) {
        EXPECT_TRUE(reference->attributes.contains(name)) << name;
    }
    const json first = summary();
    EXPECT_EQ(first["reference"]["method"], "path");
    EXPECT_GT(first["reference"]["mse"].get<double>(), 0.0);
    EXPECT_FALSE(first["reference"]["cached"].get<bool>());
    EXPECT_NEAR(first["reference"]["ratio_to_smallest_error"].get<double>(),
                first["reference"]["relative_error"].get<double>() /
                    first["reference"]["smallest_error_reported"].get<double>(),
                1e-9);
    EXPECT_TRUE(first["variants"][0]["same_method_as_reference"].get<bool>());
    EXPECT_FALSE(first["variants"][1]["same_method_as_reference"].get<bool>());
    for (const json& seed : first["plan"]["seeds"]) {
        for (const json& taken : first["reference"]["seeds"]) {
            EXPECT_NE(seed, taken);
        }
    }

    removeResults();
    const ProgramRun again = converge(with({"--integrators", "pt"}));
    ASSERT_EQ(again.exitCode, 0) << again.err;
    EXPECT_TRUE(says(again.err, "used again"));
    EXPECT_TRUE(summary()["reference"]["cached"].get<bool>());
    EXPECT_EQ(summary()["variants"][0]["curve"][3]["mse"]["mean"],
              first["variants"][0]["curve"][3]["mse"]["mean"])
        << "the same passes against the same reference";

    const ProgramRun given = converge(
        {"--reference", file("reference.exr"), "--passes", "2", "--seeds", "1", "--integrators", "pt"},
        "given");
    ASSERT_EQ(given.exitCode, 0) << given.err;
    EXPECT_TRUE(loadExr(file("reference.exr", "given"))) << "the folder is complete by itself";
    EXPECT_TRUE(summary("given")["variants"][0]["final"]["variance"].is_null()) << "one seed has no spread";
}

TEST_F(ConvergeReference, SeedsOfAGivenReferenceAreLeftOut) {
    const std::string image = folder.path("own.exr");
    ASSERT_EQ(test::runProgram({"render", test::kConvergeScene, "--size", "16x12", "--passes", "4", "--seed",
                                "0", "--integrator", "path", "--aov", "standard-error", "-o", image})
                  .exitCode,
              0);
    const ProgramRun run = converge(
        {"--reference", image, "--passes", "2", "--seeds", "2", "--seed", "0", "--integrators", "pt"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(summary()["plan"]["seeds"], (json{1, 2}));
    EXPECT_GT(summary()["reference"]["mse"].get<double>(), 0.0) << "by its luminance's standard error";
    EXPECT_TRUE(says(run.out, "16 bits"));
}

TEST_F(ConvergeReference, WrongReferencesAreRefusedOrWarnedOf) {
    const auto rendered = [&](const std::string& name, std::vector<std::string> more) {
        std::vector<std::string> words = {"render", test::kConvergeScene, "--passes", "1",
                                          "-o",     folder.path(name)};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(test::runProgram(words).exitCode, 0);
        return folder.path(name);
    };
    const auto with = [&](const std::string& reference, std::vector<std::string> more = {}) {
        std::vector<std::string> words = {"--reference", reference, "--passes",      "1",
                                          "--seeds",     "1",       "--integrators", "pt"};
        words.insert(words.end(), more.begin(), more.end());
        return converge(words);
    };
    const ProgramRun size = with(rendered("size.exr", {"--size", "8x8"}));
    EXPECT_EQ(size.exitCode, 1);
    EXPECT_TRUE(says(size.err, "8x8"));
    const ProgramRun depth = with(rendered("depth.exr", {"--size", "16x12", "--depth", "2"}));
    EXPECT_EQ(depth.exitCode, 1);
    EXPECT_TRUE(says(depth.err, "maxDepth 2"));
    const ImageF broken = test::flatImage(16, 12, std::numeric_limits<float>::quiet_NaN());
    ASSERT_TRUE(saveExr(folder.path("nan.exr"), test::exrOf(broken)));
    const ProgramRun notFinite = with(folder.path("nan.exr"));
    EXPECT_EQ(notFinite.exitCode, 1);
    EXPECT_TRUE(says(notFinite.err, "is nan"));
    const std::string moved = rendered("moved.exr", {"--size", "16x12", "--fov", "20"});
    const ProgramRun other = with(moved);
    EXPECT_EQ(other.exitCode, 1);
    EXPECT_TRUE(says(other.err, "another scene"));
    EXPECT_FALSE(std::filesystem::exists(folder.path("run"))) << "a refused run leaves nothing";
    const ProgramRun forced = with(moved, {"--any-reference"});
    EXPECT_EQ(forced.exitCode, 0) << forced.err;
    for (const std::string& text :
         {forced.out, TempFolder::read(file("summary.json")), TempFolder::read(file("index.html"))}) {
        EXPECT_TRUE(text.find("MAY NOT SHOW THIS SCENE") != std::string::npos);
    }
    EXPECT_EQ(with(folder.path("none.exr")).exitCode, 1);
    EXPECT_EQ(with(folder.write("text.exr", "no picture at all")).exitCode, 1);
    EXPECT_EQ(with(test::kConvergeScene).exitCode, 1);
}

TEST_F(ConvergeReference, AReferenceOfUnknownOriginHasNoFloor) {
    const ImageF plain = test::flatImage(16, 12, 0.25f);
    ASSERT_TRUE(saveExr(folder.path("plain.exr"), test::exrOf(plain)));
    const ProgramRun run = converge({"--reference", folder.path("plain.exr"), "--passes", "2", "--seeds", "1",
                                     "--integrators", "pt", "--subtract-reference"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_TRUE(summary()["reference"]["mse"].is_null());
    EXPECT_FALSE(summary()["reference"]["subtracted"].get<bool>());
    EXPECT_TRUE(says(run.out, "nothing vouches for it"));
    EXPECT_TRUE(says(run.out, "no floor"));
    EXPECT_FALSE(says(TempFolder::read(file("plot.svg")), "own error"));
}

TEST_F(ConvergeReference, CtrlCBeforeThereIsAReferenceMeasuresNothing) {
    const ProgramRun run = converge({"--make-reference", "100000", "--time", "100000"}, "run", "pilot of");
    EXPECT_EQ(run.exitCode, 130) << run.err;
    EXPECT_TRUE(says(run.err, "nothing was measured"));
    EXPECT_FALSE(std::filesystem::exists(folder.path("run")));
}

TEST_F(ConvergeReference, TheReferenceIsAsPreciseAsItSaysOrSaysHowFarItCame) {
    // Precise enough: by its own spread, which is what the file carries.
    const ProgramRun precise = converge({"--make-reference", "1000", "--passes", "4", "--seeds", "2",
                                         "--integrators", "pt", "--points", "2", "--pictures", "0"});
    ASSERT_EQ(precise.exitCode, 0) << precise.err;
    EXPECT_EQ(summary()["reference"]["ended_by"], "precision");
    EXPECT_LT(summary()["reference"]["ratio_to_smallest_error"].get<double>(), 0.2) << "a tenth was foretold";
    EXPECT_TRUE(says(precise.err, "the reference's own error is"));
    EXPECT_FALSE(says(precise.err, "would take"));
    // Not precise enough for four times the passes and more: it is made again.
    const ProgramRun longer =
        converge({"--make-reference", "1000", "--passes", "40", "--seeds", "1", "--integrators", "pt",
                  "--points", "2", "--pictures", "0", "--overwrite"});
    ASSERT_EQ(longer.exitCode, 0) << longer.err;
    EXPECT_TRUE(says(longer.err, "is replaced"));
    EXPECT_LT(summary()["reference"]["ratio_to_smallest_error"].get<double>(), 0.2);
    // Out of time: that, and what a tenth would take.
    const ProgramRun hurried = converge({"--make-reference", "0.001", "--passes", "64", "--seeds", "2",
                                         "--integrators", "pt", "--points", "2", "--pictures", "0"},
                                        "hurried");
    ASSERT_EQ(hurried.exitCode, 0) << hurried.err;
    EXPECT_EQ(summary("hurried")["reference"]["ended_by"], "time");
    EXPECT_TRUE(says(hurried.err, "which would take about"));
    EXPECT_TRUE(says(hurried.out, "more than a tenth"));
    EXPECT_TRUE(says(hurried.out, "A tenth would take one of about"));
}

TEST_F(ConvergeReference, ABiasedReferenceIsMarkedEverywhere) {
    const ProgramRun run =
        converge({"--make-reference", "0.05", "--reference-variant", "sppm:photons=500", "--passes", "2",
                  "--seeds", "1", "--integrators", "pt", "--pictures", "0"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const std::string mark = "whose bias is not in its error bar";
    EXPECT_TRUE(says(run.out, mark));
    EXPECT_TRUE(says(TempFolder::read(file("summary.json")), mark));
    EXPECT_NE(TempFolder::read(file("index.html")).find(mark), std::string::npos);
    EXPECT_TRUE(says(TempFolder::read(file("plot.svg")), "reference&#39;s own noise (bias unknown)"));
    const auto reference = loadExr(file("reference.exr"));
    ASSERT_TRUE(reference);
    EXPECT_TRUE(says(reference->attributes.at("referenceRemarks"), mark));
}

}  // namespace
}  // namespace glint
