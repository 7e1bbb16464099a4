// The back ends by name, and the fall-back from CUDA: one line, and a CPU that renders.
#include "viewer/make_backend.h"

#include <gtest/gtest.h>

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
    if (gpuAtHand()) GTEST_SKIP() << "this machine has a GPU";
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

TEST(MakeBackend, AnUnknownNameIsAnErrorThatNamesTheNearest) {
    const auto backend = makeBackend("cudda", 0);
    ASSERT_FALSE(backend);
    EXPECT_NE(backend.error().message.find("did you mean 'cuda'"), std::string::npos)
        << backend.error().message;
}

}  // namespace
}  // namespace glint
