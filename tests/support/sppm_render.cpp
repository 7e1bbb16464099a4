#include "tests/support/sppm_render.h"

#include <stdexcept>

#include "engine/builders/power_distribution.h"
#include "engine/builders/scene_builder.h"
#include "engine/math/color.h"
#include "engine/render/backend.h"
#include "engine/render/film.h"
#include "engine/render/pass_params.h"
#include "engine/render/path_pass.h"

namespace glint::test {
namespace {

std::shared_ptr<const BuiltScene> build(const SceneDescription& scene) {
    const SceneEdit edit{std::make_shared<const SceneDescription>(scene), EditKind::Everything};
    BuildReport report;
    auto built = buildScene(edit, nullptr, 0, nullptr, &report);
    if (!built) { throw std::runtime_error(built.error().format()); }
    return *built;
}

std::vector<Vec3> imageOf(const Film& film) {
    std::vector<Vec3> image;
    for (const FilmPixel& pixel : film.pixels()) {
        image.emplace_back(static_cast<float>(pixel.mean[0]), static_cast<float>(pixel.mean[1]),
                           static_cast<float>(pixel.mean[2]));
    }
    return image;
}

}  // namespace

SppmRender renderSppm(const SceneDescription& scene, SppmParams params, uint32_t passes, int threads) {
    const auto built = build(scene);
    const SceneView view = built->view();
    const PowerDistribution power = buildPowerDistribution(view);
    const uint32_t seed = params.pass.seed;
    params.pass = passParamsOf(scene);
    params.pass.seed = seed;
    CpuSppm sppm(threads > 0 ? threads : 2);
    SppmRender result;
    result.state = SppmState(params.pass.width, params.pass.height);
    Film film(params.pass.width, params.pass.height);
    std::vector<PixelSample> direct;
    const std::atomic<bool> stop{false};
    for (uint32_t pass = 0; pass < passes; ++pass) {
        params.pass.pass = pass;
        const auto done =
            sppm.renderPass(view, built->features, power.view(), params, stop, &result.state, &direct);
        if (!done || !*done) { throw std::runtime_error("an SPPM pass failed"); }
        film.commit(direct, pass, 1);
    }
    result.image = imageOf(film);
    for (size_t i = 0; i < result.image.size(); ++i) {
        result.image[i] += result.state.radianceOf(i);
    }
    result.lastPass = sppm.stats();
    return result;
}

std::vector<Vec3> renderPaths(const SceneDescription& scene, uint32_t seed, uint32_t passes) {
    const auto built = build(scene);
    const std::unique_ptr<Backend> backend = makeCpuBackend(0);
    if (!backend->setScene(built)) { throw std::runtime_error("the back end did not take the scene"); }
    PassParams params = passParamsOf(scene);
    params.seed = seed;
    Film film(params.width, params.height);
    std::vector<PixelSample> samples;
    const std::atomic<bool> stop{false};
    for (uint32_t pass = 0; pass < passes; ++pass) {
        params.pass = pass;
        if (!renderPathPass(*backend, params, stop, &samples)) { throw std::runtime_error("a pass failed"); }
        film.commit(samples, pass, 1);
    }
    return imageOf(film);
}

double blockMean(const std::vector<Vec3>& image, int width, int x, int y, int size) {
    double sum = 0.0;
    for (int row = y; row < y + size; ++row) {
        for (int column = x; column < x + size; ++column) {
            sum += static_cast<double>(luminance(
                image[static_cast<size_t>(row) * static_cast<size_t>(width) + static_cast<size_t>(column)]));
        }
    }
    return sum / (size * size);
}

}  // namespace glint::test
