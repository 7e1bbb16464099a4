// Nothing is allocated that a scene and its settings do not use. A counting operator new sees every large
// block of the program; the session's own count by part must explain all of them, and the parts that were not
// asked for must be empty. Four scenes, both integrators.
#include <gtest/gtest.h>

#if GLINT_THREAD_SANITIZER

TEST(MemoryUse, NotCounted) { GTEST_SKIP() << "the thread sanitizer brings its own operator new"; }

#else

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <new>

#include "engine/builders/scene_builder.h"
#include "engine/io/scene_loader.h"
#include "engine/render/checkpoint.h"
#include "engine/render/memory_use.h"
#include "engine/render/render_session.h"
#include "engine/render/sppm_state.h"
#include "tests/support/render_scene.h"
#include "tests/support/temp_folder.h"
#include "tests/support/test_scenes.h"

namespace {

/// Smaller blocks are bookkeeping: vectors of names, thread starts, messages.
constexpr size_t kLargeBlock = 16 * 1024;
std::atomic<size_t> largeBytes{0};
std::atomic<size_t> largePeak{0};

/// The block's size stands in front of it, a whole alignment away.
constexpr size_t kUsualAlignment = 64;

size_t headerFor(size_t alignment) { return std::max(alignment, kUsualAlignment); }

void* allocate(size_t size, size_t alignment = kUsualAlignment) {
    const size_t header = headerFor(alignment);
    char* block = static_cast<char*>(std::aligned_alloc(header, (size / header + 2) * header));
    if (block == nullptr) { std::abort(); }
    *reinterpret_cast<size_t*>(block) = size;
    if (size >= kLargeBlock) {
        const size_t now = largeBytes += size;
        size_t peak = largePeak;
        while (peak < now && !largePeak.compare_exchange_weak(peak, now)) {}
    }
    return block + header;
}

void release(void* pointer, size_t alignment = kUsualAlignment) {
    if (pointer == nullptr) { return; }
    char* block = static_cast<char*>(pointer) - headerFor(alignment);
    const size_t size = *reinterpret_cast<size_t*>(block);
    if (size >= kLargeBlock) { largeBytes -= size; }
    std::free(block);
}

size_t bytesOf(std::align_val_t alignment) { return static_cast<size_t>(alignment); }

}  // namespace

void* operator new(size_t size) { return allocate(size); }
void* operator new[](size_t size) { return allocate(size); }
void* operator new(size_t size, std::align_val_t a) { return allocate(size, bytesOf(a)); }
void* operator new[](size_t size, std::align_val_t a) { return allocate(size, bytesOf(a)); }
void operator delete(void* p) noexcept { release(p); }
void operator delete[](void* p) noexcept { release(p); }
void operator delete(void* p, size_t) noexcept { release(p); }
void operator delete[](void* p, size_t) noexcept { release(p); }
void operator delete(void* p, std::align_val_t a) noexcept { release(p, bytesOf(a)); }
void operator delete[](void* p, std::align_val_t a) noexcept { release(p, bytesOf(a)); }
void operator delete(void* p, size_t, std::align_val_t a) noexcept { release(p, bytesOf(a)); }
void operator delete[](void* p, size_t, std::align_val_t a) noexcept { release(p, bytesOf(a)); }

namespace glint {
namespace {

constexpr int kSize = 128;

/// What one render allocated.
struct Measured {
    MemoryUse use;          ///< by the session's own count
    size_t largeBytes = 0;  ///< live beyond what there was before the session
    size_t largePeak = 0;   ///< likewise, at the worst moment
};

SessionOptions batchOptions() {
    SessionOptions options;
    options.previews = false;
    options.snapshots = false;
    options.lowPriority = false;
    options.threads = 2;
    return options;
}

Measured render(const SceneDescription& description, IntegratorKind integrator, uint32_t aovs = 0) {
    auto scene = std::make_shared<SceneDescription>(description);
    scene->resolution = {kSize, kSize};
    scene->options.integrator = integrator;
    scene->sppm.photonsPerPass = 5000;
    const size_t before = largeBytes;
    largePeak = before;
    RenderSession session(makeCpuBackend(2), batchOptions());
    session.request({.limits = {.passes = 2}, .aovs = aovs});
    session.post({scene, EditKind::Everything});
    EXPECT_EQ(session.wait(120.0), SessionState::Finished) << session.status().error;
    return {session.status().memory, largeBytes - before, largePeak - before};
}

/// What rendering adds to a scene.
size_t countedBySession(const MemoryUse& use) {
    size_t sum = 0;
    for (const MemoryPart part :
         {MemoryPart::Film, MemoryPart::PassSamples, MemoryPart::Preview, MemoryPart::Aovs,
          MemoryPart::SppmStatistics, MemoryPart::SppmVisiblePoints, MemoryPart::Photons}) {
        sum += use[part];
    }
    return sum;
}

/// What building adds to a description: vertices and pixels are the description's.
size_t tablesOf(const MemoryUse& use) {
    return use[MemoryPart::MeshStructures] + use[MemoryPart::Instances] + use[MemoryPart::Materials] +
           use[MemoryPart::Lights] + use[MemoryPart::Environment] + use[MemoryPart::Emission];
}

std::vector<test::NamedScene> fourScenes() {
    return {{"cornell", test::cornellBox()},
            {"materials", test::allMaterials()},
            {"instances", test::meshInstances()},
            {"many lights", test::manyLights()}};
}

TEST(MemoryUse, PathTracingAllocatesFilmAndPassAlone) {
    for (const test::NamedScene& scene : fourScenes()) {
        SCOPED_TRACE(scene.name);
        const Measured m = render(scene.scene, IntegratorKind::PathTracing);
        EXPECT_EQ(m.use[MemoryPart::Film], Film::bytesFor(kSize, kSize));
        EXPECT_EQ(m.use[MemoryPart::PassSamples], kSize * kSize * sizeof(PixelSample));
        for (const MemoryPart part :
             {MemoryPart::Preview, MemoryPart::Aovs, MemoryPart::SppmStatistics,
              MemoryPart::SppmVisiblePoints, MemoryPart::Photons, MemoryPart::Emission}) {
            EXPECT_EQ(m.use[part], 0u) << memoryPartName(part);
        }
        // Whatever else is large has to be one of the scene's own tables. SPPM's statistics or one AOV would
        // each be larger than what is tolerated here.
        const size_t explained = countedBySession(m.use);
        const size_t tables = tablesOf(m.use);
        EXPECT_GE(m.largeBytes, explained);
        EXPECT_LE(m.largeBytes, explained + tables + 256 * 1024);
        EXPECT_LT(256 * 1024u, SppmState::bytesFor(kSize, kSize));
        EXPECT_LT(256 * 1024u, AovFilm::bytesFor(kSize, kSize));
    }
}

TEST(MemoryUse, SppmAllocatesItsPartsAndNoAovs) {
    for (const test::NamedScene& scene : fourScenes()) {
        SCOPED_TRACE(scene.name);
        const Measured m = render(scene.scene, IntegratorKind::Sppm);
        EXPECT_EQ(m.use[MemoryPart::SppmStatistics], SppmState::bytesFor(kSize, kSize));
        EXPECT_EQ(m.use[MemoryPart::SppmVisiblePoints] + m.use[MemoryPart::SppmStatistics],
                  kSize * kSize * kSppmBytesPerPixel);
        EXPECT_GT(m.use[MemoryPart::Photons], 0u);
        EXPECT_EQ(m.use[MemoryPart::Aovs], 0u);
        EXPECT_EQ(m.use[MemoryPart::Preview], 0u);
        EXPECT_LE(m.largeBytes, countedBySession(m.use) + tablesOf(m.use) + 512 * 1024);
    }
}

TEST(MemoryUse, AnAovAddsItsOwnPartOnly) {
    const Measured without = render(test::cornellBox(), IntegratorKind::PathTracing);
    const Measured with = render(test::cornellBox(), IntegratorKind::PathTracing, kAovDepth);
    EXPECT_EQ(with.use[MemoryPart::Aovs],
              AovFilm::bytesFor(kSize, kSize) + kSize * kSize * sizeof(AovSample));
    MemoryUse rest = with.use;
    rest[MemoryPart::Aovs] = 0;
    EXPECT_EQ(rest.bytes, without.use.bytes);
}

/// `glint info` says beforehand what a render then takes, but for the photons, which are a guess.
TEST(MemoryUse, ThePlanIsWhatARenderTakes) {
    for (const IntegratorKind integrator : {IntegratorKind::PathTracing, IntegratorKind::Sppm}) {
        SceneDescription scene = test::meshInstances();
        scene.resolution = {kSize, kSize};
        const MemoryUse plan = plannedMemory(scene, integrator, true);
        const MemoryUse taken = render(scene, integrator, kAovAlbedo).use;
        for (const MemoryPart part : {MemoryPart::Film, MemoryPart::PassSamples, MemoryPart::Aovs,
                                      MemoryPart::SppmStatistics, MemoryPart::SppmVisiblePoints}) {
            EXPECT_EQ(taken[part], plan[part]) << memoryPartName(part);
        }
    }
}

TEST(MemoryUse, WhatNoObjectUsesIsNotBuilt) {
    SceneDescription scene = test::meshInstances();
    const auto before = buildScene({std::make_shared<SceneDescription>(scene), EditKind::Everything}, nullptr,
                                   2, nullptr, nullptr);
    ASSERT_TRUE(before.ok());
    EXPECT_EQ(unusedMemory(scene, (*before)->features)[MemoryPart::Vertices], 0u);

    scene.meshes.push_back({"unused", {}, test::bumpySphere(40, 80, true)});
    Texture texture;
    texture.name = "unused";
    texture.image = test::checkerImage(64, 64, false);
    scene.textures.push_back(texture);
    scene.environmentImages.push_back(test::checkerImage(32, 16, true));
    const auto shared = std::make_shared<SceneDescription>(scene);
    const auto after = buildScene({shared, EditKind::Everything}, before->get(), 2, nullptr, nullptr);
    ASSERT_TRUE(after.ok());
    EXPECT_EQ(memoryOf(**after)[MemoryPart::MeshStructures], memoryOf(**before)[MemoryPart::MeshStructures]);
    EXPECT_EQ(memoryOf(**after)[MemoryPart::Vertices], memoryOf(**before)[MemoryPart::Vertices]);
    EXPECT_EQ(memoryOf(**after)[MemoryPart::Textures], memoryOf(**before)[MemoryPart::Textures]);
    EXPECT_EQ(memoryOf(**after)[MemoryPart::Environment], memoryOf(**before)[MemoryPart::Environment]);
    const MemoryUse unused = unusedMemory(scene, (*after)->features);
    const MeshData& mesh = *scene.meshes.back().data;
    EXPECT_EQ(unused[MemoryPart::Vertices],
              mesh.positions.size() * sizeof(Vec3) + mesh.indices.size() * sizeof(uint32_t));
    EXPECT_EQ(unused[MemoryPart::Textures], 64u * 64 * 3);
    EXPECT_EQ(unused[MemoryPart::Environment], 32u * 16 * 3 * sizeof(float));
}

/// An edit that places such a mesh builds it after all.
TEST(MemoryUse, AMeshIsBuiltWhenAnObjectTakesIt) {
    SceneDescription scene = test::meshInstances();
    scene.meshes.push_back({"spare", {}, test::bumpySphere(20, 30, false)});
    const auto before = buildScene({std::make_shared<SceneDescription>(scene), EditKind::Everything}, nullptr,
                                   2, nullptr, nullptr);
    ASSERT_TRUE(before.ok());
    for (Object& object : scene.objects) {
        if (object.shape == ShapeKind::Mesh) {
            object.mesh = static_cast<int>(scene.meshes.size()) - 1;
            break;
        }
    }
    BuildReport report;
    const auto after = buildScene({std::make_shared<SceneDescription>(scene), EditKind::ObjectTransform},
                                  before->get(), 2, nullptr, &report);
    ASSERT_TRUE(after.ok());
    EXPECT_EQ(report.meshesBuilt, 1);
    EXPECT_GT(memoryOf(**after)[MemoryPart::MeshStructures], memoryOf(**before)[MemoryPart::MeshStructures]);
}

/// A gigabyte on the disk that nothing uses is neither read nor decoded: no block of its size is asked for.
TEST(MemoryUse, AHugeUnusedFileTakesNoMemory) {
    const test::TempFolder folder;
    for (const char* name : {"huge.png", "huge.ply", "huge.obj", "huge.exr"}) {
        std::filesystem::resize_file(folder.write(name, "x"), uint64_t{1} << 30);  // sparse
    }
    const std::string path = folder.write("scene.json", R"({"glint": 1,
      "textures": {"huge": {"file": "huge.png"}},
      "materials": {"grey": {"type": "diffuse"}, "idle": {"type": "diffuse", "color": {"texture": "huge"}}},
      "meshes": {"huge": {"file": "huge.ply"}, "part": {"file": "huge.obj", "part": 2},
                 "generated": {"generator": "blob", "triangleCount": 100000000}},
      "objects": [{"type": "sphere", "material": "grey"}],
      "environment": {"strength": 0, "image": {"file": "huge.exr"}}})");
    const size_t before = largeBytes;
    largePeak = before;
    LoadCounts counts;
    const auto scene = loadScene(path, {.counts = &counts});
    ASSERT_TRUE(scene.ok()) << scene.error().format();
    EXPECT_LE(largePeak - before, 1024 * 1024u);
    EXPECT_EQ(counts, LoadCounts());
    EXPECT_EQ(unusedMemory(*scene, test::buildAll(*scene)->features).total(), 0u);
}

/// The file in memory has the size that `glint info --memory` names, and is not copied while it grows.
TEST(MemoryUse, ACheckpointsPeakIsItsSize) {
    const test::TempFolder folder;
    auto scene = std::make_shared<SceneDescription>(test::cornellBox());
    scene->resolution = {kSize, kSize};
    SessionCapture capture;
    capture.scene = scene;
    capture.film = Film(kSize, kSize);
    const size_t before = largeBytes;
    largePeak = before;
    ASSERT_TRUE(saveCheckpoint(folder.path("a.glintckp"), capture).ok());
    const size_t file = checkpointBytes(kSize, kSize, IntegratorKind::PathTracing);
    EXPECT_GE(largePeak - before, file);
    EXPECT_LE(largePeak - before, file + file / 8 + 256 * 1024);
}

}  // namespace
}  // namespace glint

#endif
