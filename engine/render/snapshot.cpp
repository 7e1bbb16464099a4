// One pass over the film; every pixel on its own.
#include "engine/render/snapshot.h"

#include "engine/base/parallel.h"

namespace glint {

std::shared_ptr<FilmSnapshot> makeSnapshot(const Film& film, bool standardError, int threads) {
    constexpr int64_t kChunkPixels = 16384;
    auto snapshot = std::make_shared<FilmSnapshot>();
    snapshot->width = film.width();
    snapshot->height = film.height();
    snapshot->passes = film.passes();
    const std::vector<FilmPixel>& pixels = film.pixels();
    snapshot->radiance.resize(pixels.size() * 3);
    if (standardError) {
        snapshot->standardError.resize(pixels.size());
    }
    parallelChunks(static_cast<int64_t>(pixels.size()), kChunkPixels, threads,
                   [&](int64_t begin, int64_t end) {
                       for (int64_t i = begin; i < end; ++i) {
                           for (int c = 0; c < 3; ++c) {
                               snapshot->radiance[i * 3 + c] = static_cast<float>(pixels[i].mean[c]);
                           }
                           if (standardError) {
                               snapshot->standardError[i] = static_cast<float>(film.standardError(pixels[i]));
                           }
                       }
                   });
    return snapshot;
}

}  // namespace glint
