// One pass over the film; every pixel on its own.
#include "engine/render/snapshot.h"

#include <cmath>

#include "engine/base/parallel.h"

namespace glint {

namespace {

void copyPixel(const Film& film, const SppmState* sppm, size_t i, FilmSnapshot* snapshot) {
    const FilmPixel& pixel = film.pixels()[i];
    const Vec3 photons = sppm ? sppm->photonRadiance(i) : Vec3(0.0f);
    for (int c = 0; c < 3; ++c) {
        snapshot->radiance[i * 3 + static_cast<size_t>(c)] = static_cast<float>(pixel.mean[c]) + photons[c];
    }
    if (!snapshot->standardError.empty()) {
        snapshot->standardError[i] = static_cast<float>(std::sqrt(pixelError(film, sppm, i).variance));
    }
    if (!snapshot->bias.empty()) { snapshot->bias[i] = sppm->pixels[i].bias; }
    if (!snapshot->maps.empty()) {
        snapshot->maps[0].values[i] = static_cast<float>(std::sqrt(sppm->pixels[i].radiusSquared));
        snapshot->maps[1].values[i] = static_cast<float>(sppm->pixels[i].photonCount);
    }
}

}  // namespace

std::shared_ptr<FilmSnapshot> makeSnapshot(const Film& film, const SppmState* sppm,
                                           const SnapshotRequest& request, int threads) {
    constexpr int64_t kChunkPixels = 16384;
    auto snapshot = std::make_shared<FilmSnapshot>();
    snapshot->width = film.width();
    snapshot->height = film.height();
    snapshot->passes = film.passes();
    const size_t count = film.pixels().size();
    snapshot->radiance.resize(count * 3);
    if (request.standardError) { snapshot->standardError.resize(count); }
    if (sppm && request.integratorMaps) {
        snapshot->maps = {{kRadiusMap, std::vector<float>(count)},
                          {kPhotonCountMap, std::vector<float>(count)}};
    }
    if (request.errorMaps) {
        snapshot->errorBound = errorBounds(film, sppm, threads);
        snapshot->bias.resize(sppm ? count : 0);
    }
    parallelChunks(static_cast<int64_t>(count), kChunkPixels, threads, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i) {
            copyPixel(film, sppm, static_cast<size_t>(i), snapshot.get());
        }
    });
    return snapshot;
}

std::shared_ptr<FilmSnapshot> makeSnapshot(const SessionCapture& capture, const SnapshotRequest& request,
                                           int threads) {
    auto snapshot =
        makeSnapshot(capture.film, capture.sppm.passes > 0 ? &capture.sppm : nullptr, request, threads);
    snapshot->integrator = capture.scene->options.integrator;
    snapshot->renderSeconds = capture.renderSeconds;
    setError(estimateError(capture.film, &capture.sppm, threads), snapshot.get());
    return snapshot;
}

void setError(const ErrorEstimate& error, FilmSnapshot* snapshot) {
    snapshot->relativeError = error.relative;
    snapshot->relativeErrorLow = error.low;
    snapshot->relativeErrorHigh = error.high;
}

}  // namespace glint
