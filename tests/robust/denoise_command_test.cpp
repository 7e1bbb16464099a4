// `glint render --denoise` and the variant of `glint converge`: the error falls, the film stays, files
// say so.
#include <gtest/gtest.h>

#include "engine/io/exr_io.h"
#include "engine/report/metrics.h"
#include "tests/support/converge_test.h"

namespace glint {
namespace {

using test::ConvergeCommand;
using test::ProgramRun;
using test::runProgram;
using test::says;
using test::TempFolder;

class DenoiseCommand : public test::ProgramTest {
  protected:
    /// Of scenes/cornell.json; returns the picture's path.
    std::string render(const std::string& name, const std::vector<std::string>& more) {
        std::vector<std::string> words{"render", test::kConvergeScene, "-o", folder.path(name), "--size",
                                       "96x72"};
        words.insert(words.end(), more.begin(), more.end());
        const ProgramRun run = runProgram(words);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return folder.path(name);
    }
};

double relMse(const std::string& image, const std::string& reference) {
    const auto a = loadExrColor(image), b = loadExrColor(reference);
    if (!a || !b) { return -1.0; }
    const auto metrics = compareImages(a->color, b->color, {.ssim = false, .flip = false});
    return metrics ? metrics->relMse : -1.0;
}

TEST_F(DenoiseCommand, TheErrorFallsForEveryIntegrator) {
    const std::string reference = render("r.exr", {"--passes", "1500", "--seed", "7", "--exr-float"});
    struct Case {
        std::vector<std::string> options;
        double leastGain;
    };
    const std::vector<Case> cases{{{"--passes", "16"}, 2.0},
                                  {{"--passes", "4"}, 4.0},
                                  {{"--passes", "8", "--integrator", "sppm", "--photons", "20000"}, 1.0}};
    for (size_t i = 0; i < cases.size(); ++i) {
        std::vector<std::string> options = cases[i].options;
        options.emplace_back("--exr-float");
        const double noisy = relMse(render("n.exr", options), reference);
        options.emplace_back("--denoise");
        const double denoised = relMse(render("d.exr", options), reference);
        EXPECT_GT(denoised, 0.0);
        EXPECT_GE(noisy / denoised, cases[i].leastGain) << i;
    }
}

TEST_F(DenoiseCommand, TheFilmStaysAndFilesSaySo) {
    const std::string film = folder.path("a.glintfilm");
    const std::string noisy = render("n.png", {"--passes", "4"});
    const std::string denoised =
        render("d.png", {"--passes", "4", "--denoise", "--checkpoint", film, "--threads", "1"});
    EXPECT_NE(TempFolder::read(noisy), TempFolder::read(denoised));
    EXPECT_EQ(TempFolder::read(denoised),
              TempFolder::read(render("e.png", {"--passes", "4", "--denoise", "--threads", "3"})));
    EXPECT_EQ(TempFolder::read(noisy),
              TempFolder::read(render("m.png", {"--passes", "4", "--resume", film})));
    const auto plain = loadExr(render("n.exr", {"--passes", "4"}));
    const auto marked = loadExr(render("d.exr", {"--passes", "4", "--denoise"}));
    ASSERT_TRUE(plain && marked);
    EXPECT_FALSE(plain->attributes.contains("denoised"));
    EXPECT_EQ(marked->attributes.at("denoised"), "yes");
    EXPECT_EQ(marked->channels.size(), 3u) << "no layer that was not asked for";
}

TEST_F(ConvergeCommand, PrintsWhatDenoisingGains) {
    // A reference of passes, since one of seconds is as noisy as the machine is slow.
    const std::string reference = folder.path("r.exr");
    const ProgramRun rendered =
        runProgram({"render", test::kConvergeScene, "-o", reference, "--size", "16x12", "--passes", "2000",
                    "--seed", "7", "--exr-float", "--aov", "standard-error"});
    ASSERT_EQ(rendered.exitCode, 0) << rendered.err;
    const ProgramRun run = converge({"--reference", reference, "--passes", "6", "--points", "4", "--seeds",
                                     "2", "--integrators", "pt,pt:denoise=on"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_TRUE(says(run.out, "path denoise=on: relMSE "));
    EXPECT_TRUE(says(run.out, " at 6 passes, "));
    const auto all = summary();
    ASSERT_EQ(all["variants"].size(), 2u);
    const auto error = [&](size_t variant) {
        return all["variants"][variant]["curve"][3]["rel_mse"]["mean"].get<double>();
    };
    EXPECT_LT(error(1), error(0));
    EXPECT_TRUE(says(converge(with({"--integrators", "pt:denoise=maybe"}), "other").err, "on or off"));
}

}  // namespace
}  // namespace glint
