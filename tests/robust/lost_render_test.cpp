// A render is never lost: not when nothing can be said any more, not by a signal, not by a name that cannot
// be written. What was rendered is saved, and what cannot be saved is not rendered.
#include <algorithm>
#include <cmath>

#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <unistd.h>

#include "engine/io/image_io.h"
#include "tests/support/program_test.h"

namespace glint {
namespace {

using test::ProgramRun;
using test::runProgram;
using test::RunSetup;
using test::says;
using test::TempFolder;

using LostRender = test::ProgramTest;

const std::string kCornell = GLINT_SOURCE_DIR "/scenes/cornell.json";
const std::string kFurnace = GLINT_SOURCE_DIR "/scenes/furnace.json";

void openAs(int stream, const char* file) {
    const int opened = ::open(file, O_WRONLY);
    ::dup2(opened, stream);
    ::close(opened);
}

/// A pipe whose reader has gone.
void breakPipe(int stream) {
    int ends[2];
    if (::pipe(ends) != 0) { _exit(126); }
    ::dup2(ends[1], stream);
    ::close(ends[0]);
    ::close(ends[1]);
}

/// Of the children that have ended.
double processorSecondsOfChildren() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

struct Stream {
    const char* name;
    std::function<void(int stream)> before;
};
const std::vector<Stream> kUnwritable{
    {"full", [](int stream) { openAs(stream, "/dev/full"); }},
    {"closed", [](int stream) { ::close(stream); }},
    {"without a reader", breakPipe},
};

TEST_F(LostRender, MessagesThatCannotBeWrittenCostNothing) {
    const std::string image = folder.path("a.png"), film = folder.path("a.film");
    for (const Stream& stream : kUnwritable) {
        const ProgramRun run = runProgram({"render", kCornell, "-o", image, "--size", "32x32", "--passes",
                                           "8", "--checkpoint", film, "--verbose"},
                                          {.before = [&] { stream.before(STDERR_FILENO); }});
        EXPECT_EQ(run.exitCode, 0) << stream.name;
        EXPECT_TRUE(loadImage(image)) << stream.name;
        EXPECT_TRUE(says(TempFolder::read(film), "FILM")) << stream.name;
        std::filesystem::remove(image);
        std::filesystem::remove(film);
    }
}

TEST_F(LostRender, ResultsThatCannotBePrintedAreAFailureAfterSaving) {
    const std::string image = folder.path("a.png");
    for (const Stream& stream : kUnwritable) {
        for (const bool alsoErrors : {false, true}) {
            const ProgramRun run = runProgram(
                {"render", kCornell, "-o", image, "--size", "32x32", "--passes", "2"}, {.before = [&] {
                    stream.before(STDOUT_FILENO);
                    if (alsoErrors) { stream.before(STDERR_FILENO); }
                }});
            EXPECT_EQ(run.exitCode, 2) << stream.name;
            EXPECT_TRUE(loadImage(image)) << stream.name;
            std::filesystem::remove(image);
        }
    }
}

TEST_F(LostRender, EveryCommandWritesItsFilesWhenItCannotSaySo) {
    const std::string image = folder.path("a.hdr");
    ASSERT_EQ(runProgram({"render", kFurnace, "-o", image, "--size", "16x16", "--passes", "2"}).exitCode, 0);
    const auto file = [&](const char* name) { return folder.path(name); };
    const std::vector<std::pair<std::vector<std::string>, std::string>> commands = {
        {{"info", kFurnace, "--json", file("info.json")}, file("info.json")},
        {{"diff", image, image, "--json", file("diff.json")}, file("diff.json")},
        {{"convert", kFurnace, file("converted.json")}, file("converted.json")},
        {{"stress", "--quick", "--filter", "recurrence", "--html", file("stress.html")}, file("stress.html")},
        {{"bench", "passes", kFurnace, "--size", "16", "--json", file("bench.json")}, file("bench.json")},
        {{"view", kFurnace, "--headless", "--size", "96x64", "--passes", "1", "--output", file("view.png")},
         file("view.png")},
        {{"converge", kFurnace, "--size", "8x8", "--make-reference", "0.05", "--passes", "2", "--seeds", "2",
          "--integrators", "pt", "--out", file("converge")},
         file("converge/summary.json")},
    };
    for (const auto& [words, result] : commands) {
        const ProgramRun run = runProgram(words, {.before = [] { openAs(STDERR_FILENO, "/dev/full"); }});
        EXPECT_EQ(run.exitCode, 0) << words[0];
        EXPECT_FALSE(TempFolder::read(result).empty()) << words[0];
    }
}

TEST_F(LostRender, SignalsSave) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) {
        const std::string image = folder.path("a.png"), film = folder.path("a.film");
        const ProgramRun run = runProgram({"render", kCornell, "-o", image, "--size", "48x48", "--passes",
                                           "10000000", "--checkpoint", film},
                                          {.signalAfter = "pass ", .signal = signal});
        EXPECT_EQ(run.exitCode, 130) << signal;
        EXPECT_TRUE(loadImage(image)) << signal;
        EXPECT_TRUE(says(TempFolder::read(film), "FILM")) << signal;
        std::filesystem::remove(image);
        std::filesystem::remove(film);
    }
}

TEST_F(LostRender, ASignalThatComesTwiceAtOnceSaves) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const std::string image = folder.path("a.png");
        const ProgramRun run =
            runProgram({"render", kCornell, "-o", image, "--size", "400x400", "--passes", "10000000"},
                       {.signalAfter = "pass ", .signal = signal, .signalsTwice = true});
        EXPECT_EQ(run.exitCode, 130) << run.err;
        EXPECT_TRUE(loadImage(image)) << run.err;
        std::filesystem::remove(image);
    }
}

TEST_F(LostRender, AnInterruptedStressRunSavesWhatItHas) {
    const std::string page = folder.path("y.html"), json = folder.path("y.json");
    // Nothing that it prints says when; it takes much longer than this.
    const auto interruptTwice = [] {
        const pid_t program = getpid();
        if (fork() == 0) {
            sleep(2);
            kill(program, SIGINT);
            usleep(50'000);
            kill(program, SIGINT);
            _exit(0);
        }
    };
    const ProgramRun run =
        runProgram({"stress", "--quick", "--html", page, "--json", json}, {.before = interruptTwice});
    EXPECT_EQ(run.exitCode, 130) << run.err;
    EXPECT_THAT(TempFolder::read(page), testing::StartsWith("<!doctype html>"));
    EXPECT_THAT(TempFolder::read(json), testing::HasSubstr("\"cases\""));
}

TEST_F(LostRender, AnInterruptedComparisonIsSaved) {
    const std::string image = folder.path("a.png"), both = folder.path("b.png");
    ASSERT_TRUE(savePng(image, Image8{64, 64, std::vector<uint8_t>(size_t{3} * 64 * 64, 99)}));
    const ProgramRun run = runProgram({"beside", image, kCornell, "-o", both, "--passes", "1000000"},
                                      {.signalAfter = "pass ", .signal = SIGINT});
    EXPECT_EQ(run.exitCode, 130) << run.err;
    EXPECT_TRUE(loadImage(both)) << run.err;
}

TEST_F(LostRender, AnOutputThatCannotBeWrittenDoesNotCostTheOthers) {
    const std::string full = folder.path("full.png"), page = folder.path("full.html");
    std::filesystem::create_symlink("/dev/full", full);
    std::filesystem::create_symlink("/dev/full", page);
    const std::vector<std::string> runs[] = {
        {"render", kCornell, "-o", full, "--size", "8x8", "--passes", "1"},
        {"stress", "--quick", "--filter", "recurrence", "--html", page}};
    for (std::vector<std::string> words : runs) {
        const std::string json = folder.path("of-" + words[0] + ".json");
        words.insert(words.end(), {"--json", json});
        const ProgramRun run = runProgram(words);
        EXPECT_EQ(run.exitCode, 2) << run.err;
        EXPECT_TRUE(says(run.err, "No space left on device"));
        EXPECT_THAT(TempFolder::read(json), testing::HasSubstr("\"report\"")) << words[0];
    }
}

TEST_F(LostRender, HangingUpIsIgnoredWhereItWas) {
    const ProgramRun run = runProgram(
        {"render", kCornell, "-o", folder.path("a.png"), "--size", "16x16", "--passes", "100"},
        {.signalAfter = "pass ", .signal = SIGHUP, .before = [] { std::signal(SIGHUP, SIG_IGN); }});
    EXPECT_EQ(run.exitCode, 0) << run.err;
}

TEST_F(LostRender, ASignalBeforeAnythingIsRenderedIsSaid) {
    // It waits from before the program's first instruction.
    const RunSetup setup{.before = [] {
        sigset_t set;
        sigemptyset(&set);
        sigaddset(&set, SIGINT);
        sigprocmask(SIG_BLOCK, &set, nullptr);
        raise(SIGINT);
    }};
    const ProgramRun run = runProgram(
        {"render", kCornell, "-o", folder.path("a.png"), "--size", "16x16", "--passes", "2"}, setup);
    EXPECT_EQ(run.exitCode, 130);
    EXPECT_TRUE(says(run.err, "interrupted"));
    EXPECT_EQ(folder.size(), 0u);
}

TEST_F(LostRender, ASignalInTheFirstPassGivesThatPass) {
    // A limit of processor time ends in the first pass: it comes after what reading the scene takes, and the
    // pass is made so large that it takes four seconds, sanitizers or not.
    const std::string image = folder.path("a.png");
    const auto render = [&](int width, const char* passes, const RunSetup& setup) {
        return runProgram({"render", kCornell, "-o", image, "--size",
                           fmt::format("{}x{}", width, width * 3 / 4), "--passes", passes},
                          setup);
    };
    const auto seconds = [&](int width) {
        const double before = processorSecondsOfChildren();
        EXPECT_EQ(render(width, "1", {}).exitCode, 0);
        return processorSecondsOfChildren() - before;
    };
    const double start = seconds(16), pass = std::max(0.005, seconds(320) - start);
    const double limit = std::ceil(start + 0.5);
    const int width = std::min(8000, static_cast<int>(320 * std::sqrt((limit - start + 4.0) / pass)));
    std::filesystem::remove(image);
    const ProgramRun run = render(width, "100", {.before = [limit] {
                                      const rlimit most{static_cast<rlim_t>(limit), RLIM_INFINITY};
                                      setrlimit(RLIMIT_CPU, &most);
                                  }});
    EXPECT_EQ(run.exitCode, 130) << run.err;
    EXPECT_TRUE(says(run.err, "interrupted in the first pass"));
    EXPECT_TRUE(says(run.out, " 1 passes in"));
    EXPECT_TRUE(loadImage(image));
}

TEST_F(LostRender, AnInterruptedHeadlessWindowSaves) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const std::string image = folder.path("a.exr"), window = folder.path("w.png");
        const ProgramRun run = runProgram({"view", kFurnace, "--headless", "--size", "96x64", "--passes",
                                           "100000000", "--output", image, "--screenshot", window},
                                          {.signalAfter = "pass ", .signal = signal});
        if (says(run.err, "this build has no window")) { GTEST_SKIP(); }
        EXPECT_EQ(run.exitCode, 130) << run.err;
        EXPECT_TRUE(loadImage(image)) << signal;
        EXPECT_TRUE(loadImage(window)) << signal;
        std::filesystem::remove(image);
        std::filesystem::remove(window);
    }
}

TEST_F(LostRender, LongNamesAreWrittenOrRefusedBeforeRendering) {
    const auto render = [&](const std::string& name, const std::vector<std::string>& more = {}) {
        std::vector<std::string> words = {"render", kCornell, "-o", folder.path(name), "--size", "16x16"};
        words.insert(words.end(), more.begin(), more.end());
        return runProgram(words);
    };
    const std::string longest = std::string(251, 'a') + ".png";
    EXPECT_EQ(render(longest, {"--passes", "1"}).exitCode, 0);
    EXPECT_TRUE(loadImage(folder.path(longest)));
    // So many passes that the test would not end if it began to render.
    const std::vector<std::string> endless = {"--passes", "100000000"};
    EXPECT_EQ(render("a" + longest, endless).exitCode, 1);
    EXPECT_EQ(render(".png", endless).exitCode, 1);
    const ProgramRun numbered = render(longest, {"--passes", "100000000", "--checkpoint-every", "1"});
    EXPECT_EQ(numbered.exitCode, 1) << "its numbered pictures have longer names";
    EXPECT_TRUE(says(numbered.err, "-000001.png"));
}

}  // namespace
}  // namespace glint
