// How a pass is cut into launches: every pixel belongs to one thread, and launches take about as long
// as wanted.
#include <gtest/gtest.h>

#if GLINT_HAS_CUDA

#include "cuda/chunk_pacer.h"
#include "cuda/launch.h"

namespace glint {
namespace {

TEST(CudaLaunch, EveryPixelHasOneThread) {
    for (const auto& [width, height] : {std::pair{1, 1}, {8, 4}, {9, 5}, {67, 45}, {640, 3}, {3, 640}}) {
        std::vector<int> threadsOf(static_cast<size_t>(width * height), 0);
        const uint32_t threads = threadsOfPass(width, height);
        for (uint32_t i = 0; i < threads; ++i) {
            const PixelPlace at = pixelOfThread(i, width);
            ASSERT_GE(at.x, 0);
            ASSERT_GE(at.y, 0);
            if (at.x < width && at.y < height) { ++threadsOf[static_cast<size_t>(at.y * width + at.x)]; }
        }
        EXPECT_EQ(std::count(threadsOf.begin(), threadsOf.end(), 1), width * height)
            << width << "x" << height;
        EXPECT_LT(threads, static_cast<uint32_t>((width + kTileWidth) * (height + kTileHeight)));
    }
}

TEST(CudaLaunch, AWarpSeesNeighbours) {
    const PixelPlace first = pixelOfThread(32 * 100, 640);
    for (uint32_t lane = 0; lane < 32; ++lane) {
        const PixelPlace at = pixelOfThread(32 * 100 + lane, 640);
        EXPECT_LT(at.x - first.x, kTileWidth);
        EXPECT_LT(at.y - first.y, kTileHeight);
    }
}

TEST(CudaLaunch, ThePacerFindsTheLaunchThatTakesAsLongAsWanted) {
    for (const double threadsPerSecond : {1e6, 3e7, 1e9}) {
        ChunkPacer pacer;
        for (int i = 0; i < 30; ++i) {
            pacer.measured(pacer.threads(), pacer.threads() / threadsPerSecond);
        }
        const double seconds = pacer.threads() / threadsPerSecond;
        EXPECT_NEAR(seconds, ChunkPacer::kTargetSeconds, ChunkPacer::kLeast / threadsPerSecond)
            << threadsPerSecond;
    }
}

TEST(CudaLaunch, ThePacerKeepsItsBounds) {
    ChunkPacer pacer;
    for (int i = 0; i < 100; ++i) {
        pacer.measured(pacer.threads(), 0.0);
    }
    EXPECT_EQ(pacer.threads(), ChunkPacer::kMost);
    for (int i = 0; i < 100; ++i) {
        pacer.measured(pacer.threads(), 1.0);
    }
    EXPECT_EQ(pacer.threads(), ChunkPacer::kLeast);
}

TEST(CudaLaunch, TheRestOfAPassSaysNothingUnlessItTookTooLong) {
    ChunkPacer pacer;
    const uint32_t before = pacer.threads();
    pacer.measured(before / 8, 1e-4);
    EXPECT_EQ(pacer.threads(), before);
    pacer.measured(before / 8, 1.0);
    EXPECT_LT(pacer.threads(), before / 8);
}

}  // namespace
}  // namespace glint

#else
TEST(CudaLaunch, NotBuilt) { GTEST_SKIP() << "this build has no CUDA back end (GLINT_CUDA)"; }
#endif
