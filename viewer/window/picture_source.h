// Which numbers of a snapshot a display gets: radiance as it is, the other pictures as false colours.
#pragma once

#include <vector>

#include "engine/report/heat_map.h"
#include "viewer/window/image_display.h"
#include "viewer/window/viewer_model.h"

namespace glint {

class PictureSource {
  public:
    /// Brings the display up to date; uploads only what is new. A null snapshot leaves the picture as it is.
    void show(const std::shared_ptr<const FilmSnapshot>& snapshot, const DisplaySettings& settings,
              ImageDisplay* display);

    /// What is on the display, and the scale of its colours where it shows radii or photon counts.
    ShownPicture shownKind() const { return shownKind_; }
    IntegratorKind shownIntegrator() const { return shownIntegrator_; }
    const HeatScale& heat() const { return heat_; }

  private:
    std::shared_ptr<const FilmSnapshot> shown_;
    ShownPicture wantedKind_ = ShownPicture::Radiance;
    ShownPicture shownKind_ = ShownPicture::Radiance;
    IntegratorKind shownIntegrator_ = IntegratorKind::PathTracing;
    HeatScale heat_;
    std::vector<float> falseColors_;
};

/// What is shown of this snapshot: path tracing has neither radii nor photons and shows its radiance instead.
ShownPicture pictureOf(const FilmSnapshot& snapshot, ShownPicture wanted);

/// 3 display values a pixel. Empty when the snapshot does not carry that picture (yet). `heat` is set for
/// radii and photon counts.
std::vector<float> falseColors(const FilmSnapshot& snapshot, ShownPicture shown, HeatScale* heat);

}  // namespace glint
