// Memory that runs short: at each single allocation of a command, and at every limit of address space. No
// command aborts, each says why it ended, and what was rendered is saved.
#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "engine/io/image_io.h"
#include "engine/render/checkpoint.h"
#include "tests/support/program_test.h"
#include "viewer/commands/program.h"

namespace {

/// Allocations that succeed before one fails; negative: all do.
std::atomic<long> untilFailure{-1};

void* allocate(size_t bytes, size_t alignment) {
    if (untilFailure.load(std::memory_order_relaxed) >= 0 && untilFailure.fetch_sub(1) == 0) {
        return nullptr;
    }
    const size_t rounded = (bytes + alignment - 1) / alignment * alignment;
    return alignment <= alignof(std::max_align_t) ? std::malloc(bytes > 0 ? bytes : 1)
                                                  : std::aligned_alloc(alignment, rounded);
}

void* allocateOrThrow(size_t bytes, size_t alignment = 1) {
    void* place = allocate(bytes, alignment);
    if (place == nullptr) { throw std::bad_alloc(); }
    return place;
}

}  // namespace

void* operator new(size_t bytes) { return allocateOrThrow(bytes); }
void* operator new[](size_t bytes) { return allocateOrThrow(bytes); }
void* operator new(size_t bytes, std::align_val_t alignment) {
    return allocateOrThrow(bytes, static_cast<size_t>(alignment));
}
void* operator new[](size_t bytes, std::align_val_t alignment) {
    return allocateOrThrow(bytes, static_cast<size_t>(alignment));
}
void* operator new(size_t bytes, const std::nothrow_t&) noexcept { return allocate(bytes, 1); }
void* operator new[](size_t bytes, const std::nothrow_t&) noexcept { return allocate(bytes, 1); }
// Where one of a pair is inlined, GCC takes the other for its mismatch.
[[gnu::noinline]] void operator delete(void* place) noexcept { std::free(place); }
void operator delete[](void* place) noexcept { std::free(place); }
[[gnu::noinline]] void operator delete(void* place, size_t) noexcept { std::free(place); }
void operator delete[](void* place, size_t) noexcept { std::free(place); }
void operator delete(void* place, std::align_val_t) noexcept { std::free(place); }
void operator delete[](void* place, std::align_val_t) noexcept { std::free(place); }
void operator delete(void* place, size_t, std::align_val_t) noexcept { std::free(place); }
void operator delete[](void* place, size_t, std::align_val_t) noexcept { std::free(place); }

namespace glint {
namespace {

using test::ProgramRun;
using test::says;
using test::TempFolder;

constexpr const char* kScene = R"({ "glint": 1, "resolution": [12, 8],
    "camera": { "position": [0, 0, 4], "target": [0, 0, 0] },
    "textures": { "wood": { "file": "wood.png" } },
    "materials": { "lamp": { "type": "diffuse", "emission": 1 },
                   "wood": { "type": "diffuse", "color": { "texture": "wood" } } },
    "meshes": { "quad": { "file": "quad.obj" } },
    "objects": [{ "type": "sphere", "material": "lamp", "center": [0, 3, 0], "radius": 1 },
                { "type": "mesh", "mesh": "quad", "material": "wood" }] })";

class ShortMemory : public test::ProgramTest {
  protected:
    void SetUp() override {
        ProgramTest::SetUp();
        ASSERT_TRUE(savePng(folder.path("wood.png"), Image8{2, 1, {200, 100, 50, 20, 30, 40}}));
        folder.write("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1 4/1\n");
        scene = folder.write("a.json", kScene);
    }

    /// The command in a process of its own, whose allocation number `failing` fails (negative: none does).
    /// `unused` becomes how many more would have been made before one failed.
    ProgramRun runFailing(const std::vector<std::string>& words, long failing, long* unused) {
        const std::string err = folder.path("err"), left = folder.path("left");
        const pid_t child = ::fork();
        if (child == 0) {
            const int file = ::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
            ::dup2(file, STDERR_FILENO);
            ::dup2(::open("/dev/null", O_WRONLY), STDOUT_FILENO);
            std::vector<std::string> arguments = words;
            untilFailure = failing;
            const int code = runProgram(std::move(arguments), addProgramCommands);
            const long after = untilFailure.exchange(-1);
            std::ofstream(left) << after;
            std::_Exit(code);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        ProgramRun run;
        run.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        run.err = TempFolder::read(err);
        *unused = std::atol(TempFolder::read(left).c_str());
        return run;
    }

    /// Allocations that the command makes.
    long countAllocations(const std::vector<std::string>& words) {
        constexpr long kMany = 1L << 40;
        long unused = kMany;
        EXPECT_EQ(runFailing(words, kMany, &unused).exitCode, 0) << TempFolder::read(folder.path("err"));
        return kMany - unused;
    }

    /// Fails each allocation of the command in turn, and expects an end with a reason.
    void failEach(const std::vector<std::string>& words, const std::vector<std::string>& results) {
        const long all = countAllocations(words);
        ASSERT_GT(all, 100);
        long unused = 0;
        int lost = 0;
        for (long failing = 0; failing < all; ++failing) {
            for (const std::string& result : results) {
                std::filesystem::remove(result);
            }
            const ProgramRun run = runFailing(words, failing, &unused);
            EXPECT_TRUE(run.exitCode == 0 || run.exitCode == 1 || run.exitCode == 2)
                << words[0] << ", allocation " << failing << ": " << run.exitCode << "\n"
                << run.err;
            if (run.exitCode != 0) { EXPECT_FALSE(run.err.empty()) << failing; }
            const bool isRendered = run.err.find(" %  pass ") != std::string::npos;
            const bool isSaved = std::ranges::any_of(
                results, [](const std::string& path) { return std::filesystem::exists(path); });
            if (isRendered && !isSaved) {
                ADD_FAILURE() << "lost at allocation " << failing << ": " << run.err;
                ++lost;
            }
            if (HasFailure() && lost > 3) { break; }
        }
    }

    std::string scene;
};

TEST_F(ShortMemory, EachAllocationOfAPathTracedRenderMayFail) {
    const std::string image = folder.path("x.exr"), film = folder.path("x.film");
    failEach({"render", scene, "-o", image, "--checkpoint", film, "--passes", "3", "--threads", "2", "--aov",
              "albedo,normal,depth,standard-error,error-bound", "--checkpoint-every", "2"},
             {image, film});
}

TEST_F(ShortMemory, EachAllocationOfAPhotonMappedRenderMayFail) {
    const std::string image = folder.path("x.png"), film = folder.path("x.film");
    failEach({"render", scene, "-o", image, "--checkpoint", film, "--passes", "3", "--threads", "2",
              "--integrator", "sppm", "--photons", "2000"},
             {image, film});
}

/// Of address space, in steps that meet every larger allocation.
TEST_F(ShortMemory, NoLimitOfAddressSpaceLosesARender) {
    const std::string cornell = GLINT_SOURCE_DIR "/scenes/cornell.json";
    const std::string image = folder.path("x.exr");
    for (const char* integrator : {"pt", "sppm"}) {
        for (size_t mebibytes = 100; mebibytes <= 700; mebibytes += 6) {
            std::filesystem::remove(image);
            const ProgramRun run = test::runProgram(
                {"render", cornell, "-o", image, "--size", "700x700", "--passes", "1", "--threads", "2",
                 "--aov", "albedo,normal,depth,standard-error,error-bound", "--integrator", integrator},
                {.before = [mebibytes] {
                    const rlimit limit{mebibytes << 20, mebibytes << 20};
                    setrlimit(RLIMIT_AS, &limit);
                }});
            // 127: there is not even room for the libraries.
            EXPECT_TRUE(run.exitCode == 0 || run.exitCode == 1 || run.exitCode == 2 || run.exitCode == 127)
                << integrator << " " << mebibytes << ": " << run.exitCode << " " << run.err;
            if (run.exitCode != 0) { EXPECT_FALSE(run.err.empty()) << mebibytes; }
            const bool isRendered = run.err.find(" %  pass ") != std::string::npos;
            EXPECT_TRUE(!isRendered || loadImage(image)) << integrator << " " << mebibytes << ": " << run.err;
        }
    }
}

}  // namespace
}  // namespace glint
