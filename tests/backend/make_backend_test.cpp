// The back ends by name, and the fall-back from CUDA: one line, and a CPU that renders.
#include "viewer/base/make_backend.h"

#include <cstdio>
#include <filesystem>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "engine/base/log.h"

#if GLINT_HAS_CUDA
#include "cuda/device.h"
#endif

namespace glint {
namespace {

bool gpuAtHand() {
#if GLINT_HAS_CUDA
    return openGpu().ok();
#else
    return false;
#endif
}

TEST(MakeBackend, CpuByName) {
    const auto backend = makeBackend("cpu", 3);
    ASSERT_TRUE(backend);
    EXPECT_EQ((*backend)->name(), "CPU, 3 threads");
}

TEST(MakeBackend, CudaWithoutADeviceFallsBackWithOneLine) {
    if (gpuAtHand()) { GTEST_SKIP() << "this machine has a GPU"; }
    uint64_t seen = 0;
    recentLogLines(&seen);
    const uint64_t before = seen;
    const auto backend = makeBackend("cuda", 2);
    ASSERT_TRUE(backend);
    EXPECT_EQ((*backend)->name(), "CPU, 2 threads");
    const std::vector<LogLine> lines = recentLogLines(&seen);
    ASSERT_EQ(seen, before + 1);
    const LogLine& line = lines.back();
    EXPECT_EQ(line.level, LogLevel::Warning);
    EXPECT_EQ(line.text.find('\n'), std::string::npos);
    EXPECT_NE(line.text.find("CUDA: "), std::string::npos) << line.text;
    EXPECT_NE(line.text.find("rendering on the CPU"), std::string::npos) << line.text;
}

/// The program's standard error and exit code after `glint <arguments>`.
std::pair<std::string, int> runProgram(const std::string& arguments) {
    const std::string command = std::string(GLINT_PROGRAM) + " " + arguments + " 2>&1 >/dev/null";
    std::string text;
    FILE* pipe = popen(command.c_str(), "r");
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) {
        text.push_back(static_cast<char>(c));
    }
    const int status = pclose(pipe);
    return {text, WIFEXITED(status) ? WEXITSTATUS(status) : -1};
}

TEST(MakeBackend, TheProgramFallsBackWithOneLineAndRenders) {
    if (gpuAtHand()) { GTEST_SKIP() << "this machine has a GPU"; }
    if (std::string(GLINT_PROGRAM).empty()) { GTEST_SKIP() << "the program was not built"; }
    for (const std::string integrator : {"path", "sppm"}) {
        std::filesystem::remove("fallback.png");
        const auto [text, code] = runProgram("render " GLINT_SOURCE_DIR
                                             "/scenes/cornell.json -o fallback.png --size 16x16 --passes 1 "
                                             "--backend cuda --integrator " +
                                             integrator);
        EXPECT_EQ(code, 0) << text;
        const size_t first = text.find("CUDA: ");
        ASSERT_NE(first, std::string::npos) << text;
        EXPECT_EQ(text.find("CUDA: ", first + 1), std::string::npos) << text;
        EXPECT_NE(text.find("rendering on the CPU"), std::string::npos) << text;
        EXPECT_TRUE(std::filesystem::exists("fallback.png"));
    }
}

TEST(MakeBackend, AnUnknownNameIsAnErrorThatNamesTheNearest) {
    const auto backend = makeBackend("cudda", 0);
    ASSERT_FALSE(backend);
    EXPECT_NE(backend.error().message.find("did you mean 'cuda'"), std::string::npos)
        << backend.error().message;
}

}  // namespace
}  // namespace glint
