#include "tests/support/film_bits.h"

#include <cstring>

#include <gtest/gtest.h>

#include "engine/builders/scene_builder.h"
#include "engine/io/scene_json.h"
#include "engine/io/scene_loader.h"
#include "engine/render/backend.h"
#include "engine/render/pass_params.h"
#include "engine/render/path_pass.h"
#include "tests/support/temp_folder.h"

namespace glint::test {
namespace {

const std::atomic<bool> kNever{false};

}  // namespace

Film renderPasses(const SceneDescription& scene, uint32_t passes, int threads) {
    const auto shared = std::make_shared<SceneDescription>(scene);
    const auto built = buildScene({shared, EditKind::Everything}, nullptr, threads, nullptr, nullptr);
    EXPECT_TRUE(built.ok());
    const auto backend = makeCpuBackend(threads);
    EXPECT_TRUE(backend->setScene(*built).ok());
    Film film(scene.resolution.width, scene.resolution.height);
    PassParams params = passParamsOf(scene);
    std::vector<PixelSample> samples;
    for (params.pass = 0; params.pass < passes; ++params.pass) {
        EXPECT_TRUE(*renderPathPass(*backend, params, kNever, &samples));
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

void expectSameFilmWhenSaved(const std::string& path) {
    SCOPED_TRACE(path);
    auto original = loadScene(path, {.allowMissing = true});
    ASSERT_TRUE(original.ok()) << original.error().format();
    original->resolution = {40, 30};
    const TempFolder folder;
    const std::string saved = folder.path("saved.json");
    const Status status = saveSceneJson(*original, saved);
    ASSERT_TRUE(status.ok()) << status.error().format();
    const auto loaded = loadScene(saved);
    ASSERT_TRUE(loaded.ok()) << loaded.error().format();
    expectSameBits(renderPasses(*original, 3, 2), renderPasses(*loaded, 3, 2));
}

}  // namespace glint::test
