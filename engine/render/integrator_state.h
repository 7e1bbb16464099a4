// What a session keeps of one integrator: its film, its preview, how fast it is, and what is shown of it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/render/convergence_curve.h"
#include "engine/render/error_estimate.h"
#include "engine/render/film.h"
#include "engine/render/film_snapshot.h"
#include "engine/render/integrator.h"
#include "engine/render/preview_scale.h"
#include "engine/render/session_clock.h"

namespace glint {

inline int64_t pixelCount(int width, int height) { return static_cast<int64_t>(width) * height; }

/// Whole passes of one image.
struct RenderedImage {
    Film film;
    std::unique_ptr<ImageStatistics> statistics;  ///< null where the integrator has none

    int64_t pixels() const { return pixelCount(film.width(), film.height()); }
    /// An empty film of this size. Returns whether it had to be allocated. The statistics follow when a
    /// pass begins.
    bool clearFilm(int width, int height);
    /// Makes the statistics those of `passes` passes of this size, of which there are none where that is 0.
    void prepareStatistics(IntegratorKind kind, int width, int height, uint32_t passes);
};

/// A film and what is known of it.
struct RenderedFilm {
    RenderedImage image;
    double renderSeconds = 0.0;
    double secondsPerPass = 0.0;  ///< of late
    uint64_t raysOfPass = 0;      ///< of the last one
    ErrorEstimate error{};
    ConvergenceCurve curve{};

    size_t bytes() const;
};

/// What the newest snapshot of an integrator is of: a new one is due when any of it changed.
struct PublishedImage {
    EditTicket ticket = 0;
    bool isPreview = false;
    std::optional<FilmRegion> region{};
    uint64_t restarts = 0;
    int previewScale = 1;
    uint32_t passes = 0;
    uint32_t aovPasses = 0;
    bool standardError = false;
    bool integratorMaps = false;
    bool errorMaps = false;

    bool operator==(const PublishedImage&) const = default;
};

class IntegratorState {
  public:
    explicit IntegratorState(IntegratorKind kind) : kind_(kind) {}

    IntegratorKind kind() const { return kind_; }

    // The film.
    uint32_t passes() const { return isStale_ ? 0 : film_.image.film.passes(); }
    const RenderedImage& image() const { return film_.image; }
    /// Empties the film, but only when the next pass is ready to be added: an edit must not wait for it.
    void restart();
    /// Restarts, and hands over the film that it had, which must have passes.
    RenderedFilm takeFilm();
    void goOnFrom(RenderedFilm film);
    /// Where the next film pass of this size puts its statistics; null: it has none.
    ImageStatistics* statisticsForPass(int width, int height);
    /// The part that alone is rendered on, once the film has a pass, and that error() is of; nothing: all.
    const std::optional<FilmRegion>& region() const { return region_; }
    /// Integrators with statistics render whole pictures.
    void setRegion(const std::optional<FilmRegion>& region, const Resolution& size);
    /// Of the next film pass.
    const FilmRegion* regionOfPass() const { return region_ && passes() > 0 ? &*region_ : nullptr; }
    /// Adds a pass, of regionOfPass(), that took so long. Returns whether the film had to be allocated.
    /// `decay` is IntegratorType::statisticsDecay().
    bool commit(const std::vector<PixelSample>& samples, const Resolution& size, double seconds, double decay,
                int threads);
    /// Makes a point of the convergence curve where one is due: none is while there is a region. Returns
    /// whether there is a new one.
    bool recordError(int threads);
    void estimateErrorAnew(int threads);

    double renderSeconds() const { return film_.renderSeconds; }
    double secondsPerPass() const { return film_.secondsPerPass; }
    uint64_t raysOfPass() const { return film_.raysOfPass; }
    const ErrorEstimate& error() const { return film_.error; }
    const ConvergenceCurve& curve() const { return film_.curve; }
    /// Tells the film from those before.
    uint64_t restarts() const { return restarts_; }

    // The preview: a picture at low resolution while the film has no pass.
    bool isPreviewing() const { return isPreviewing_; }
    int previewScale() const { return previewScale_; }
    const RenderedImage& preview() const { return preview_; }
    /// An empty preview of a film of this size; none when the scale is 1.
    void startPreview(int width, int height, int scale);
    void endPreview() { isPreviewing_ = false; }
    ImageStatistics* statisticsForPreviewPass();
    void commitPreview(const std::vector<PixelSample>& samples, double seconds, int threads);

    // What there is to be seen.
    const RenderedImage& visible() const { return isPreviewing_ ? preview_ : film_.image; }
    uint32_t visiblePasses() const { return isPreviewing_ ? preview_.film.passes() : passes(); }
    PublishedImage shown;
    std::shared_ptr<const FilmSnapshot> snapshot;  ///< that `shown` describes
    SessionClock::time_point shownAt;

    PreviewScale pace;

  private:
    IntegratorKind kind_;
    RenderedFilm film_;
    std::optional<FilmRegion> region_;
    bool isStale_ = true;
    uint64_t restarts_ = 0;

    RenderedImage preview_;
    bool isPreviewing_ = false;
    int previewScale_ = 1;
};

}  // namespace glint
