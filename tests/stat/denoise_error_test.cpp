// What is stated of denoised pictures holds against references of many more passes: none is worse than its
// input by more than its stated error, in no square of pixels.
#include <cmath>

#include <gtest/gtest.h>

#include "engine/denoise/denoise.h"
#include "engine/io/scene_loader.h"
#include "engine/math/color.h"
#include "engine/render/denoised_snapshot.h"
#include "engine/render/snapshot.h"
#include "viewer/base/make_backend.h"

namespace glint {
namespace {

constexpr int kWidth = 64, kHeight = 48;

std::shared_ptr<FilmSnapshot> render(SceneDescription scene, uint32_t passes, uint32_t seed) {
    scene.resolution = {kWidth, kHeight};
    scene.options.seed = seed;
    auto backend = makeBackend("cpu", 0);
    EXPECT_TRUE(backend);
    RenderSession session(std::move(*backend), {.previews = false, .snapshots = false});
    session.request({.limits = {.passes = passes}, .aovs = kDenoisingAovs, .aovsEndWithFilm = true});
    session.post({std::make_shared<const SceneDescription>(scene), EditKind::Everything});
    EXPECT_EQ(session.wait(300.0), SessionState::Finished) << session.status().error;
    const auto capture = session.capture();
    auto snapshot = makeSnapshot(*capture, {.standardError = true}, 0);
    snapshot->aovs = std::make_shared<const AovFilm>(capture->aovs);
    return snapshot;
}

float lightOf(const FilmSnapshot& image, size_t pixel) {
    const float* rgb = &image.radiance[3 * pixel];
    return luminance(Vec3(rgb[0], rgb[1], rgb[2]));
}

/// Calls visit(pixel) for a square around a pixel.
template <class Visit>
void forSquare(size_t middle, int half, const Visit& visit) {
    const int x = static_cast<int>(middle) % kWidth, y = static_cast<int>(middle) / kWidth;
    for (int v = std::max(0, y - half); v <= std::min(kHeight - 1, y + half); ++v) {
        for (int u = std::max(0, x - half); u <= std::min(kWidth - 1, x + half); ++u) {
            visit(static_cast<size_t>(v * kWidth + u));
        }
    }
}

/// What squares of luminances are relative to, as denoise.h says.
std::vector<double> scalesOf(const FilmSnapshot& input) {
    const size_t pixels = input.standardError.size();
    double sum = 0.0;
    for (size_t i = 0; i < pixels; ++i) {
        sum += static_cast<double>(lightOf(input, i));
    }
    const double darkest = 0.1 * sum / static_cast<double>(pixels);
    std::vector<double> scales;
    for (size_t i = 0; i < pixels; ++i) {
        double light = 0.0, count = 0.0;
        forSquare(i, 2, [&](size_t at) {
            light += static_cast<double>(lightOf(input, at));
            count += 1.0;
        });
        scales.push_back(1.0 / (light * light / (count * count) + darkest * darkest));
    }
    return scales;
}

/// Roots of relative mean squares over the square around a pixel.
struct Misses {
    double denoised = 0.0, input = 0.0, change = 0.0, standardError = 0.0;
};

Misses missesAround(size_t middle, const FilmSnapshot& denoised, const FilmSnapshot& input,
                    const FilmSnapshot& truth, const std::vector<double>& scales) {
    Misses sum;
    double count = 0.0;
    const auto add = [](double scale, float miss, double* to) {
        *to += scale * static_cast<double>(miss) * static_cast<double>(miss);
    };
    forSquare(middle, kDenoiseErrorHalf, [&](size_t i) {
        add(scales[i], lightOf(denoised, i) - lightOf(truth, i), &sum.denoised);
        add(scales[i], lightOf(input, i) - lightOf(truth, i), &sum.input);
        add(scales[i], lightOf(denoised, i) - lightOf(input, i), &sum.change);
        add(scales[i], input.standardError[i], &sum.standardError);
        count += 1.0;
    });
    return {std::sqrt(sum.denoised / count), std::sqrt(sum.input / count), std::sqrt(sum.change / count),
            std::sqrt(sum.standardError / count)};
}

void expectWithinStated(const char* name, uint32_t passes) {
    const auto scene = loadScene(std::string(GLINT_SOURCE_DIR) + "/scenes/" + name);
    ASSERT_TRUE(scene) << scene.error().format();
    const auto truth = render(*scene, 600, 7), input = render(*scene, passes, 1);
    const std::vector<double> scales = scalesOf(*input);
    for (const DenoiseQuality quality : {DenoiseQuality::Quick, DenoiseQuality::Careful}) {
        const auto denoised = denoisedSnapshot(*input, quality, 0);
        ASSERT_TRUE(denoised);
        size_t worse = 0, changed = 0, met = 0;
        for (size_t i = 0; i < scales.size(); ++i) {
            const Misses miss = missesAround(i, *denoised, *input, *truth, scales);
            const double stated = static_cast<double>(denoised->standardError[i]) * std::sqrt(scales[i]);
            worse += miss.denoised > miss.input + stated ? 1 : 0;
            changed +=
                miss.change > 1.001 * static_cast<double>(kDenoiseMostChange) * miss.standardError ? 1 : 0;
            met += miss.denoised <= 2.0 * stated ? 1 : 0;
        }
        EXPECT_EQ(worse, 0u) << name << ' ' << passes;
        EXPECT_EQ(changed, 0u) << name << ' ' << passes;
        EXPECT_GT(met, scales.size() * 3 / 4) << name << ' ' << passes;
    }
}

TEST(DenoiseError, NoSquareIsWorseThanItsInputByMoreThanStated) {
    expectWithinStated("cornell.json", 4);
    expectWithinStated("cornell.json", 32);
    expectWithinStated("depth_of_field.json", 8);
}

}  // namespace
}  // namespace glint
