// A process that is killed at any moment while it saves leaves the old file or the new one, never a
// broken one.
#include <atomic>
#include <chrono>
#include <random>

#include <gtest/gtest.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): kill is POSIX
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "engine/io/atomic_file.h"
#include "engine/render/checkpoint.h"
#include "tests/support/capture.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::captureOf;
using test::TempFolder;

/// Runs `save(n)` for n = 0, 1, … in a child until it is killed after `microseconds`; returns how many saves
/// it finished. The child only saves: it never returns into the test program.
template <class Save>
uint32_t killWhileSaving(unsigned microseconds, Save save) {
    void* shared = ::mmap(nullptr, sizeof(std::atomic<uint32_t>), PROT_READ | PROT_WRITE,
                          MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    auto* finished = new (shared) std::atomic<uint32_t>(0);
    const pid_t child = ::fork();
    if (child == 0) {
        for (uint32_t n = 0;; ++n) {
            save(n);
            finished->fetch_add(1);
        }
    }
    ::usleep(microseconds);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const uint32_t count = finished->load();
    ::munmap(shared, sizeof(std::atomic<uint32_t>));
    return count;
}

/// How long one save takes here and now, in microseconds: kills are to fall into saves, and to let
/// some finish.
template <class Save>
unsigned microsecondsOf(Save save) {
    constexpr unsigned kSaves = 8;
    const auto start = std::chrono::steady_clock::now();
    for (unsigned n = 0; n < kSaves; ++n) {
        save(n);
    }
    const auto all =
        std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - start);
    return 1 + static_cast<unsigned>(all.count()) / kSaves;
}

TEST(InterruptedSave, LeavesTheOldOrTheNewFile) {
    const TempFolder folder;
    const std::string path = folder.path("file");
    const auto contentOf = [](uint32_t n) {
        return std::string(100000 + n % 7, static_cast<char>('a' + n % 26));
    };
    const auto save = [&](uint32_t n) { (void)writeFileAtomically(path, contentOf(n)); };
    const unsigned oneSave = microsecondsOf(save);
    std::mt19937 random(11);
    uint32_t finishedInAll = 0;
    size_t leftBehind = 0;
    for (int round = 0; round < 60; ++round) {
        ASSERT_TRUE(writeFileAtomically(path, contentOf(0)));
        const uint32_t finished = killWhileSaving(500 + random() % (4 * oneSave), save);
        // The kill may fall between the rename and the counting.
        const std::string left = TempFolder::read(path);
        const std::string last = contentOf(finished > 0 ? finished - 1 : 0);
        EXPECT_TRUE(left == last || left == contentOf(finished))
            << "round " << round << ": " << left.size() << " bytes";
        finishedInAll += finished;
        leftBehind += folder.size() - 1;
        ASSERT_TRUE(writeFileAtomically(path, contentOf(0)));
        EXPECT_EQ(folder.size(), 1u) << "the next save removes what the killed one left";
    }
    EXPECT_GT(leftBehind, 0u) << "no kill fell into a save";
    RecordProperty("saves", static_cast<int>(finishedInAll));
    EXPECT_GT(finishedInAll, 0u);
}

TEST(InterruptedSave, CheckpointsStayWhole) {
    const TempFolder folder;
    const std::string path = folder.path("film.checkpoint");
    SceneDescription scene;
    scene.resolution = {100, 80};
    const Film film(100, 80);
    ASSERT_TRUE(saveCheckpoint(path, captureOf(scene, film, 0.0)));
    const auto save = [&](uint32_t n) {
        (void)saveCheckpoint(path, captureOf(scene, film, 1.0 + static_cast<double>(n)));
    };
    const unsigned oneSave = microsecondsOf(save);
    std::mt19937 random(12);
    uint32_t finishedInAll = 0;
    for (int round = 0; round < 50; ++round) {
        ASSERT_TRUE(saveCheckpoint(path, captureOf(scene, film, 0.0)));
        const uint32_t finished = killWhileSaving(500 + random() % (4 * oneSave), save);
        finishedInAll += finished;
        const Result<ResumePoint> loaded = loadCheckpoint(path, scene);
        ASSERT_TRUE(loaded) << loaded.error().format();
        const double done = static_cast<double>(finished);
        EXPECT_TRUE(loaded->renderSeconds == done || loaded->renderSeconds == done + 1.0)
            << loaded->renderSeconds;
    }
    EXPECT_GT(finishedInAll, 0u);
}

}  // namespace
}  // namespace glint
