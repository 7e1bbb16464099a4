#include "engine/render/denoised_snapshot.h"

#include "engine/denoise/denoise.h"

namespace glint {
namespace {

DenoiseInput inputOf(const FilmSnapshot& snapshot) {
    DenoiseInput input{.width = snapshot.width, .height = snapshot.height};
    const std::vector<AovSample>& hits = snapshot.aovs->pixels();
    const size_t pixels = hits.size();
    input.radiance.reserve(pixels);
    input.variance.reserve(pixels);
    input.albedo.reserve(pixels);
    input.normal.reserve(pixels);
    input.depth.reserve(pixels);
    for (size_t i = 0; i < pixels; ++i) {
        input.radiance.emplace_back(snapshot.radiance[3 * i], snapshot.radiance[3 * i + 1],
                                    snapshot.radiance[3 * i + 2]);
        input.variance.push_back(square(snapshot.standardError[i]));
        input.albedo.push_back(hits[i].albedo);
        input.normal.push_back(hits[i].shadingNormal);
        input.depth.push_back(hits[i].depth);
    }
    return input;
}

}  // namespace

std::shared_ptr<FilmSnapshot> denoisedSnapshot(const FilmSnapshot& snapshot, DenoiseQuality quality,
                                               int threads, const std::atomic<bool>* stop) {
    const size_t pixels = snapshot.standardError.size();
    if (pixels == 0 || !snapshot.aovs || snapshot.aovs->passes() == 0 ||
        snapshot.aovs->pixels().size() != pixels) {
        return nullptr;
    }
    const DenoiseInput input = inputOf(snapshot);
    DenoisedImage image =
        quality == DenoiseQuality::Quick ? denoiseQuickly(input, threads) : denoise(input, threads, stop);
    if (image.radiance.empty()) { return nullptr; }
    auto out = std::make_shared<FilmSnapshot>(snapshot);
    out->isDenoised = true;
    out->standardError = std::move(image.error);
    for (size_t i = 0; i < pixels; ++i) {
        for (int c = 0; c < 3; ++c) {
            out->radiance[3 * i + static_cast<size_t>(c)] = image.radiance[i][c];
        }
    }
    return out;
}

}  // namespace glint
