// One pass over the film; every pixel on its own.
#include "engine/render/snapshot.h"

#include <cmath>

#include "engine/base/parallel.h"

namespace glint {

namespace {

void copyPixel(const Film& film, const ImageStatistics* statistics, size_t i, FilmSnapshot* snapshot) {
    const FilmPixel& pixel = film.pixels()[i];
    const Vec3 photons = statistics ? statistics->radianceOf(i) : Vec3(0.0f);
    for (int c = 0; c < 3; ++c) {
        snapshot->radiance[i * 3 + static_cast<size_t>(c)] = static_cast<float>(pixel.mean[c]) + photons[c];
    }
    if (!snapshot->standardError.empty()) {
        snapshot->standardError[i] = static_cast<float>(std::sqrt(pixelError(film, statistics, i).variance));
    }
    if (!snapshot->bias.empty()) { snapshot->bias[i] = static_cast<float>(statistics->biasOf(i)); }
}

}  // namespace

std::shared_ptr<FilmSnapshot> makeSnapshot(const Film& film, const ImageStatistics* statistics,
                                           const SnapshotRequest& request, int threads) {
    constexpr int64_t kChunkPixels = 16384;
    statistics = statistics && statistics->passCount() > 0 ? statistics : nullptr;
    auto snapshot = std::make_shared<FilmSnapshot>();
    snapshot->width = film.width();
    snapshot->height = film.height();
    snapshot->passes = film.passes();
    const size_t count = film.pixels().size();
    snapshot->radiance.resize(count * 3);
    if (request.standardError) { snapshot->standardError.resize(count); }
    if (statistics && request.integratorMaps) { snapshot->maps = statistics->maps(); }
    if (request.errorMaps) {
        snapshot->errorBound = errorBounds(film, statistics, threads);
        snapshot->bias.resize(statistics ? count : 0);
    }
    parallelChunks(static_cast<int64_t>(count), kChunkPixels, threads, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i) {
            copyPixel(film, statistics, static_cast<size_t>(i), snapshot.get());
        }
    });
    return snapshot;
}

std::shared_ptr<FilmSnapshot> makeSnapshot(const SessionCapture& capture, const SnapshotRequest& request,
                                           int threads) {
    const ImageStatistics* statistics = capture.statistics.get();
    auto snapshot = makeSnapshot(capture.film, statistics, request, threads);
    snapshot->integrator = capture.scene->options.integrator;
    snapshot->renderSeconds = capture.renderSeconds;
    setError(estimateError(capture.film, statistics, threads), snapshot.get());
    return snapshot;
}

void setError(const ErrorEstimate& error, FilmSnapshot* snapshot) {
    snapshot->relativeError = error.relative;
    snapshot->relativeErrorLow = error.low;
    snapshot->relativeErrorHigh = error.high;
}

}  // namespace glint
