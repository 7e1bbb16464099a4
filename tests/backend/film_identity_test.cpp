// The same film to the last bit: for 1, 2 and 3 threads, over capture and resume, through the session, and
// from a scene that was saved and loaded again.
#include <cstring>
#include <filesystem>

#include <gtest/gtest.h>

#include "engine/builders/scene_builder.h"
#include "engine/io/scene_json.h"
#include "engine/io/scene_loader.h"
#include "engine/render/pass_params.h"
#include "engine/render/render_session.h"
#include "tests/support/temp_folder.h"
#include "tests/support/test_scenes.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr uint32_t kPasses = 3;
const std::atomic<bool> kNever{false};

Film render(const SceneDescription& scene, int threads) {
    const auto shared = std::make_shared<SceneDescription>(scene);
    const auto built = buildScene({shared, EditKind::Everything}, nullptr, threads, nullptr, nullptr);
    EXPECT_TRUE(built.ok());
    const auto backend = makeCpuBackend(threads);
    EXPECT_TRUE(backend->setScene(*built).ok());
    Film film(scene.resolution.width, scene.resolution.height);
    PassParams params = passParamsOf(scene);
    std::vector<PixelSample> samples;
    for (params.pass = 0; params.pass < kPasses; ++params.pass) {
        EXPECT_TRUE(*backend->renderPass(params, kNever, &samples));
        film.commit(samples, params.pass, threads);
    }
    return film;
}

void expectSameBits(const Film& a, const Film& b) {
    ASSERT_EQ(a.pixels().size(), b.pixels().size());
    EXPECT_EQ(a.passes(), b.passes());
    EXPECT_EQ(a.rays(), b.rays());
    size_t different = 0;
    for (size_t i = 0; i < a.pixels().size(); ++i) {
        const FilmPixel &p = a.pixels()[i], &q = b.pixels()[i];
        different += std::memcmp(p.mean.data(), q.mean.data(), sizeof p.mean) != 0 ||
                     std::memcmp(&p.luminanceM2, &q.luminanceM2, sizeof p.luminanceM2) != 0 ||
                     p.count != q.count;
    }
    EXPECT_EQ(different, 0u);
}

TEST(FilmIdentity, OneTwoAndThreeThreadsOnEveryTestScene) {
    for (const test::NamedScene& named : test::allTestScenes()) {
        SCOPED_TRACE(named.name);
        const Film one = render(named.scene, 1);
        expectSameBits(one, render(named.scene, 2));
        expectSameBits(one, render(named.scene, 3));
    }
}

TEST(FilmIdentity, TheSessionAddsNothingAndResumesExactly) {
    const auto scene = std::make_shared<SceneDescription>(test::cornellBox());
    const Film direct = render(*scene, 2);

    RenderSession first(makeCpuBackend(2));
    first.request({.limits = {.passes = 1}, .aovs = kAovAlbedo, .standardError = true});
    first.post({scene, EditKind::Everything});
    ASSERT_EQ(first.wait(300.0), SessionState::Finished);
    auto half = first.capture();
    ASSERT_TRUE(half.has_value());

    RenderSession second(makeCpuBackend(3));
    second.request({.limits = {.passes = kPasses}});
    second.resume(scene, {.film = std::move(half->film), .renderSeconds = half->renderSeconds});
    ASSERT_EQ(second.wait(300.0), SessionState::Finished);
    const auto whole = second.capture();
    ASSERT_TRUE(whole.has_value());
    expectSameBits(direct, whole->film);
}

/// Saves into another folder, loads that, and compares the pictures.
void expectSameImageFromSavedScene(const fs::path& path) {
    SCOPED_TRACE(path);
    auto original = loadScene(path.string(), {.allowMissing = true});
    ASSERT_TRUE(original.ok()) << original.error().format();
    original->resolution = {40, 30};
    const test::TempFolder folder;
    const std::string saved = folder.path("saved.json");
    const Status status = saveSceneJson(*original, saved);
    ASSERT_TRUE(status.ok()) << status.error().format();
    const auto loaded = loadScene(saved);
    ASSERT_TRUE(loaded.ok()) << loaded.error().format();
    expectSameBits(render(*original, 2), render(*loaded, 2));
}

TEST(FilmIdentity, OurScenesSavedAndLoadedAgain) {
    for (const auto& entry : fs::directory_iterator(GLINT_SOURCE_DIR "/scenes")) {
        const fs::path& path = entry.path();
        if (path.extension() == ".json" && path.stem().extension() != ".schema") {
            expectSameImageFromSavedScene(path);
        }
    }
}

TEST(FilmIdentity, TextScenesAndObjFilesSavedAndLoadedAgain) {
    const fs::path seeds = fs::path(GLINT_SHARED_DIR) / "seed-scenes";
    if (!fs::exists(seeds)) { GTEST_SKIP() << seeds << " is not here"; }
    for (const char* name : {"scene03_sphere", "scene04_axes", "scene06_bunny_1k", "scene11_smallpt",
                             "scene18_dof", "scene21_livingroom"}) {
        expectSameImageFromSavedScene(seeds / "testcases" / (std::string(name) + ".txt"));
    }
    expectSameImageFromSavedScene(seeds / "mesh" / "bunny_1k_vn.obj");
}

TEST(FilmIdentity, AStoppedPassLeavesNoTrace) {
    const SceneDescription scene = test::cornellBox();
    const auto built = buildScene({std::make_shared<SceneDescription>(scene), EditKind::Everything}, nullptr,
                                  2, nullptr, nullptr);
    ASSERT_TRUE(built.ok());
    const auto backend = makeCpuBackend(2);
    ASSERT_TRUE(backend->setScene(*built).ok());
    const std::atomic<bool> stopped{true};
    std::vector<PixelSample> samples;
    EXPECT_FALSE(*backend->renderPass(passParamsOf(scene), stopped, &samples));
    EXPECT_FALSE(makeCpuBackend(1)->renderPass(passParamsOf(scene), kNever, &samples).ok())
        << "there is no scene";
}

}  // namespace
}  // namespace glint
