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

size_t RenderedFilm::bytes() const {
    return image.film.bytes() + (image.statistics ? image.statistics->bytes() : 0);
}

void IntegratorState::restart() {
    isStale_ = true;
    ++restarts_;
    film_.renderSeconds = 0.0;
    film_.secondsPerPass = 0.0;
    film_.error = {};
    film_.curve.clear();
}

RenderedFilm IntegratorState::takeFilm() {
    RenderedFilm film = std::exchange(film_, {});
    restart();
    return film;
}

void IntegratorState::goOnFrom(RenderedFilm film) {
    restart();
    film_ = std::move(film);
    isStale_ = false;
    isPreviewing_ = false;
}

ImageStatistics* IntegratorState::statisticsForPass(int width, int height) {
    film_.image.prepareStatistics(kind_, width, height, passes());
    return film_.image.statistics.get();
}

void IntegratorState::setRegion(const std::optional<FilmRegion>& region, const Resolution& size) {
    const bool canBePart = region && !integratorType(kind_).makeStatistics();
    region_ = canBePart ? clipped(*region, size.width, size.height) : std::nullopt;
}

bool IntegratorState::commit(const std::vector<PixelSample>& samples, const Resolution& size, double seconds,
                             double decay, int threads) {
    const FilmRegion* region = regionOfPass();
    isPreviewing_ = false;
    const bool isAllocated = isStale_ && film_.image.clearFilm(size.width, size.height);
    isStale_ = false;
    Film& film = film_.image.film;
    const uint64_t raysBefore = film.rays();
    film.commit(samples, film.passes(), threads, region);
    calibrateNoise(film_.image.statistics.get(), decay, threads, &film);
    film_.renderSeconds += seconds;
    double& secondsPerPass = film_.secondsPerPass;
    secondsPerPass = secondsPerPass == 0.0 ? seconds : 0.8 * secondsPerPass + 0.2 * seconds;
    film_.raysOfPass = film.rays() - raysBefore;
    pace.measured(region != nullptr ? region->pixels() : film_.image.pixels(), seconds);
    return isAllocated;
}

void IntegratorState::estimateErrorAnew(int threads) {
    film_.error =
        estimateError(film_.image.film, film_.image.statistics.get(), threads, region_ ? &*region_ : nullptr);
}

bool IntegratorState::recordError(int threads) {
    const uint32_t passes = film_.image.film.passes();
    if (region_ || !film_.curve.isDue(passes)) { return false; }
    estimateErrorAnew(threads);
    const ErrorEstimate& error = film_.error;
    film_.curve.add({.passes = passes,
                     .renderSeconds = film_.renderSeconds,
                     .relativeError = error.relative,
                     .relativeErrorLow = error.low,
                     .relativeErrorHigh = error.high,
                     .relativeBias = error.bias});
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
