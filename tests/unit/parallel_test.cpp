// Loops on the render threads: every index once, what a body throws, and no team of threads for a
// serial loop.
#include "engine/base/parallel.h"

#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <omp.h>

namespace glint {
namespace {

TEST(Parallel, EveryIndexIsPassedOnce) {
    for (const int64_t count : {0, 1, 7, 1000}) {
        for (const int64_t chunk : {0, 1, 3, 2000}) {
            std::vector<std::atomic<int>> passed(static_cast<size_t>(count));
            parallelChunks(count, chunk, 2, [&](int64_t begin, int64_t end) {
                for (int64_t i = begin; i < end; ++i) {
                    ++passed[static_cast<size_t>(i)];
                }
            });
            for (const std::atomic<int>& times : passed) {
                EXPECT_EQ(times, 1) << count << " by " << chunk;
            }
        }
    }
}

TEST(Parallel, WhatABodyThrowsIsThrownHere) {
    for (const int threads : {1, 2}) {
        const auto fail = [](int64_t begin, int64_t) {
            if (begin == 5) { throw std::runtime_error("five"); }
        };
        EXPECT_THROW(parallelChunks(10, 1, threads, fail), std::runtime_error);
    }
}

/// A team takes memory; where there is none, the OpenMP library ends the program.
TEST(Parallel, ASerialLoopStartsNoTeam) {
    parallelChunks(10, 1, 1, [](int64_t, int64_t) { EXPECT_EQ(omp_get_level(), 0); });
    parallelChunks(10, 100, 2, [](int64_t, int64_t) { EXPECT_EQ(omp_get_level(), 0) << "one chunk"; });
    parallelChunks(10, 1, 2, [](int64_t, int64_t) { EXPECT_EQ(omp_get_level(), 1); });
}

}  // namespace
}  // namespace glint
