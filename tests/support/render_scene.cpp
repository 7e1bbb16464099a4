#include "tests/support/render_scene.h"

#include <atomic>

#include <gtest/gtest.h>

#include "engine/builders/scene_builder.h"
#include "engine/render/backend.h"
#include "engine/render/pass_params.h"
#include "engine/render/path_pass.h"

namespace glint::test {

std::shared_ptr<const BuiltScene> buildAll(const SceneDescription& scene) {
    const SceneEdit edit{std::make_shared<SceneDescription>(scene), EditKind::Everything};
    BuildReport report;
    auto built = buildScene(edit, nullptr, 0, nullptr, &report);
    if (!built) {
        ADD_FAILURE() << built.error().format();
        return nullptr;
    }
    return *built;
}

Film renderFilm(const SceneDescription& scene, uint32_t passes, DirectLightTag directLight) {
    PassParams params = passParamsOf(scene);
    params.directLight = directLight;
    Film film(params.width, params.height);
    const auto backend = makeCpuBackend(0);
    const auto built = buildAll(scene);
    if (!built || !backend->setScene(built)) { return film; }
    const std::atomic<bool> stop{false};
    std::vector<PixelSample> samples;
    for (uint32_t pass = 0; pass < passes; ++pass) {
        params.pass = pass;
        if (!renderPathPass(*backend, params, stop, &samples)) {
            ADD_FAILURE() << "pass " << pass << " failed";
            break;
        }
        film.commit(samples, pass, 0);
    }
    return film;
}

Estimate meanLuminance(const Film& film, int x0, int y0, int x1, int y1) {
    Estimate estimate;
    double variance = 0.0;
    for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
            const FilmPixel& pixel = film.pixels()[static_cast<size_t>(y * film.width() + x)];
            estimate.mean += 0.2126 * pixel.mean[0] + 0.7152 * pixel.mean[1] + 0.0722 * pixel.mean[2];
            variance += film.standardError(pixel) * film.standardError(pixel);
        }
    }
    const double count = static_cast<double>(x1 - x0) * static_cast<double>(y1 - y0);
    estimate.mean /= count;
    estimate.standardError = std::sqrt(variance) / count;
    return estimate;
}

Estimate meanLuminance(const Film& film) { return meanLuminance(film, 0, 0, film.width(), film.height()); }

bool agree(const Estimate& a, const Estimate& b, double slack) {
    const double error = std::hypot(a.standardError, b.standardError);
    return std::abs(a.mean - b.mean) <= kNormalQuantile * error + slack * std::abs(b.mean);
}

}  // namespace glint::test
