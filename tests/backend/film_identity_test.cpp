// The same film to the last bit: for 1, 2 and 3 threads, over capture and resume, through the session, and
// from a scene that was saved and loaded again.
#include <filesystem>

#include <gtest/gtest.h>

#include "engine/builders/scene_builder.h"
#include "engine/render/pass_params.h"
#include "engine/render/path_pass.h"
#include "engine/render/render_session.h"
#include "tests/support/film_bits.h"
#include "tests/support/test_scenes.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr uint32_t kPasses = 3;
const std::atomic<bool> kNever{false};

TEST(FilmIdentity, OneTwoAndThreeThreadsOnEveryTestScene) {
    for (const test::NamedScene& named : test::allTestScenes()) {
        SCOPED_TRACE(named.name);
        const Film one = test::renderPasses(named.scene, kPasses, 1);
        test::expectSameBits(one, test::renderPasses(named.scene, kPasses, 2));
        test::expectSameBits(one, test::renderPasses(named.scene, kPasses, 3));
    }
}

TEST(FilmIdentity, TheSessionAddsNothingAndResumesExactly) {
    const auto scene = std::make_shared<SceneDescription>(test::cornellBox());
    const Film direct = test::renderPasses(*scene, kPasses, 2);

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
    test::expectSameBits(direct, whole->film);
}

TEST(FilmIdentity, OurScenesSavedAndLoadedAgain) {
    for (const auto& entry : fs::directory_iterator(GLINT_SOURCE_DIR "/scenes")) {
        const fs::path& path = entry.path();
        if (path.extension() == ".json" && path.stem().extension() != ".schema") {
            test::expectSameFilmWhenSaved(path.string());
        }
    }
}

TEST(FilmIdentity, TextScenesAndObjFilesSavedAndLoadedAgain) {
    for (const auto& entry : fs::directory_iterator(GLINT_SOURCE_DIR "/tests/data/film")) {
        if (entry.path().extension() == ".txt" || entry.path().extension() == ".obj") {
            test::expectSameFilmWhenSaved(entry.path().string());
        }
    }
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
    EXPECT_FALSE(*renderPathPass(*backend, passParamsOf(scene), stopped, &samples));
    EXPECT_FALSE(renderPathPass(*makeCpuBackend(1), passParamsOf(scene), kNever, &samples).ok())
        << "there is no scene";
}

}  // namespace
}  // namespace glint
