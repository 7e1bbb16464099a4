#include "engine/render/integrator_state.h"

#include <utility>

#include "engine/render/noise_calibration.h"

namespace glint {

bool RenderedImage::clearFilm(int width, int height) {
    if (film.width() == width && film.height() == height) {
        film.clear();
        return false;
    }
    film = Film(width, height);
    return true;
}

void RenderedImage::prepareStatistics(IntegratorKind kind, int width, int height, uint32_t passes) {
    if (!statistics) {
        statistics = makeStatistics(kind, width, height);
    } else if (passes == 0) {
        statistics->reset(width, height);
    }
}

void IntegratorState::restart() {
    isStale_ = true;
    ++restarts_;
    renderSeconds_ = 0.0;
    secondsPerPass_ = 0.0;
    error_ = {};
    curve_.clear();
}

void IntegratorState::goOnFrom(RenderedImage image, double renderSeconds, ConvergenceCurve curve,
                               int threads) {
    restart();
    image_ = std::move(image);
    isStale_ = false;
    renderSeconds_ = renderSeconds;
    curve_ = std::move(curve);
    isPreviewing_ = false;
    estimateErrorAnew(threads);
}

ImageStatistics* IntegratorState::statisticsForPass(int width, int height) {
    image_.prepareStatistics(kind_, width, height, passes());
    return image_.statistics.get();
}

bool IntegratorState::commit(const std::vector<PixelSample>& samples, const Resolution& size, double seconds,
                             double decay, int threads) {
    isPreviewing_ = false;
    const bool isAllocated = isStale_ && image_.clearFilm(size.width, size.height);
    isStale_ = false;
    Film& film = image_.film;
    const uint64_t raysBefore = film.rays();
    film.commit(samples, film.passes(), threads);
    calibrateNoise(image_.statistics.get(), decay, threads, &film);
    renderSeconds_ += seconds;
    secondsPerPass_ = secondsPerPass_ == 0.0 ? seconds : 0.8 * secondsPerPass_ + 0.2 * seconds;
    raysOfPass_ = film.rays() - raysBefore;
    pace.measured(image_.pixels(), seconds);
    return isAllocated;
}

void IntegratorState::estimateErrorAnew(int threads) {
    error_ = estimateError(image_.film, image_.statistics.get(), threads);
}

bool IntegratorState::recordError(int threads) {
    if (!curve_.isDue(image_.film.passes())) { return false; }
    estimateErrorAnew(threads);
    curve_.add({.passes = image_.film.passes(),
                .renderSeconds = renderSeconds_,
                .relativeError = error_.relative,
                .relativeErrorLow = error_.low,
                .relativeErrorHigh = error_.high,
                .relativeBias = error_.bias});
    return true;
}

void IntegratorState::startPreview(int width, int height, int scale) {
    isPreviewing_ = scale > 1;
    if (!isPreviewing_) { return; }
    previewScale_ = scale;
    preview_.clearFilm(previewSize(width, scale), previewSize(height, scale));
}

ImageStatistics* IntegratorState::statisticsForPreviewPass() {
    const Film& film = preview_.film;
    preview_.prepareStatistics(kind_, film.width(), film.height(), film.passes());
    return preview_.statistics.get();
}

void IntegratorState::commitPreview(const std::vector<PixelSample>& samples, double seconds, int threads) {
    preview_.film.commit(samples, preview_.film.passes(), threads);
    pace.measured(preview_.pixels(), seconds);
}

}  // namespace glint
