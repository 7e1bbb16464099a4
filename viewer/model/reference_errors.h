// A reference image, and how far each integrator's image was from it as it grew.
//
// It is shown every new snapshot; those at about evenly spaced logarithms of the passes, and
// the last one, are compared on a thread of their own, so that no frame waits. Nothing here draws.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/render/convergence_curve.h"
#include "engine/render/render_session.h"
#include "engine/scene/image.h"
#include "engine/scene/render_options.h"
#include "viewer/base/job_queue.h"

namespace glint {

struct LoadedReference {
    std::string path;
    ImageF image;
    double mean = 0.0;                              ///< of all its values
    bool isEightBit = false;                        ///< values above 1 are missing in it
    std::map<std::string, std::string> attributes;  ///< what an EXR file says about itself
};

/// What the error against the reference is measured as; all are relative, 0.01 for 1 %.
enum class ReferenceMetric {
    PictureError,  ///< what the estimate without a reference is of, too (engine/render/picture_error.h)
    RelativeRmse,  ///< square root of relMSE (metrics.h)
    RmseOverMean,  ///< RMSE over the reference's mean
    Mape,
};

struct ReferencePoint {
    uint32_t passes = 0;
    double renderSeconds = 0.0;
    double pictureError = 0.0;
    double relativeRmse = 0.0;
    double rmseOverMean = 0.0;
    double mape = 0.0;
    double relativeBias = 0.0;  ///< signed

    double error(ReferenceMetric metric) const;
};

class ReferenceErrors {
  public:
    /// Loads any picture that is read (image_formats.h) in the background; loadError() says if it could not.
    /// Until it is there, the one before stays; it also stays where it has the picture's size and the new one
    /// has not. Of several asked for at once, the last counts.
    void load(const std::string& path, const Resolution& image);
    void clear();
    bool loading() const { return loading_; }
    const std::optional<Error>& loadError() const { return loadError_; }
    /// Null without one.
    const std::shared_ptr<const LoadedReference>& loaded() const { return loaded_; }
    /// Why it cannot be compared with a picture of this size: another one, or it is black; "" when it can, or
    /// when there is none.
    std::string mismatch(int width, int height) const;

    /// Once a frame: takes what the jobs found out.
    void refresh();
    /// Once a frame for each integrator, before observe(): its film's curve tells one that was restarted from
    /// one that goes on.
    void follow(IntegratorKind kind, const ConvergenceCurve& curve);
    /// Once a frame for each snapshot that is shown. `resting`: no further pass will come by itself.
    void observe(const std::shared_ptr<const FilmSnapshot>& snapshot, bool resting);
    /// Passes rising.
    const std::vector<ReferencePoint>& points(IntegratorKind kind) const { return seriesOf(kind).points; }
    /// Of the last film before the present one that had more than a few of them.
    const std::vector<ReferencePoint>& pointsBefore(IntegratorKind kind) const {
        return seriesOf(kind).before;
    }
    bool measuring() const;

  private:
    struct Series {
        std::vector<ReferencePoint> points;
        std::vector<ReferencePoint> before;
        double filmBegan = 0.0;  ///< render seconds of the film's first point: its name; 0: there is none
        bool measuring = false;
    };
    const Series& seriesOf(IntegratorKind kind) const { return series_[static_cast<size_t>(kind)]; }
    Status whyWorse(const LoadedReference& reference) const;
    void forgetPoints();
    void measure(std::shared_ptr<const FilmSnapshot> snapshot, Series* series);

    JobQueue jobs_;
    std::shared_ptr<const LoadedReference> loaded_;
    std::optional<Error> loadError_;
    bool loading_ = false;
    std::string next_;        ///< to be loaded after the one that is being loaded
    Resolution image_{0, 0};  ///< its size
    std::array<Series, kIntegratorTable.size()> series_;
};

/// Mean of |t - r| over the three channels of a pixel of both images, which have one size.
float errorAgainst(const LoadedReference& reference, const FilmSnapshot& snapshot, size_t pixel);

/// The points as a curve without bands, for forecastError().
ConvergenceCurve asCurve(const std::vector<ReferencePoint>& points, ReferenceMetric metric);

}  // namespace glint
