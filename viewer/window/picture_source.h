// Which numbers of a snapshot a display gets: radiance as it is, the other pictures as false colours.
//
// Runs on the UI thread, once for each new snapshot; how numbers become colours is engine/report/heat_map's.
#pragma once

#include <string>
#include <vector>

#include "engine/report/heat_map.h"
#include "viewer/window/image_display.h"
#include "viewer/window/viewer_model.h"

namespace glint {

/// Whether false colours stand for numbers on a scale, and its ends; {0, 0} when they do not. Signed: from
/// -largest to largest, black at 0.
struct MapScale {
    HeatScale heat;
    bool isSigned = false;
    bool isThere() const { return heat.largest > 0.0f; }
};

class PictureSource {
  public:
    /// Brings the display up to date; uploads only what is new. A null snapshot leaves the picture as it is.
    /// `reference` may be null. `alongside`: the source of the picture beside it, whose scale it takes so
    /// that the same colours mean the same; may be null.
    void show(const std::shared_ptr<const FilmSnapshot>& snapshot, const DisplaySettings& settings,
              const std::shared_ptr<const LoadedReference>& reference, const PictureSource* alongside,
              ImageDisplay* display);

    /// What is on the display, and the scale of its colours.
    ShownPicture shownKind() const { return shownKind_; }
    IntegratorKind shownIntegrator() const { return shownIntegrator_; }
    const MapScale& scale() const { return scale_; }

  private:
    std::shared_ptr<const FilmSnapshot> shown_;
    std::shared_ptr<const LoadedReference> reference_;
    ShownPicture wantedKind_ = ShownPicture::Radiance;
    ShownPicture shownKind_ = ShownPicture::Radiance;
    IntegratorKind shownIntegrator_ = IntegratorKind::PathTracing;
    MapScale scale_;
    std::vector<float> falseColors_;
};

/// What is shown of this snapshot: its radiance where it has not what is wanted, as path tracing has no
/// photons, or where the reference is missing or of another size.
ShownPicture pictureOf(const FilmSnapshot& snapshot, ShownPicture wanted, const LoadedReference* reference);

/// What a snapshot shows instead of `wanted`, and why, for the picture's corner; "" when it shows what is
/// wanted.
std::string instead(const FilmSnapshot& snapshot, ShownPicture wanted, const LoadedReference* reference);

/// Mean of |t - r| over the three channels of a pixel of both pictures.
float errorAgainst(const LoadedReference& reference, const FilmSnapshot& snapshot, size_t pixel);

/// 3 display values a pixel. Empty when the snapshot does not carry that picture (yet). `scale` goes in as
/// the one to use, or {} to find one, and comes back as the one that was used.
std::vector<float> falseColors(const FilmSnapshot& snapshot, ShownPicture shown,
                               const LoadedReference* reference, MapScale* scale);

}  // namespace glint
