// Which numbers of a snapshot the display gets: radiance as it is, the other pictures as false colours.
#pragma once

#include <vector>

#include "viewer/window/image_display.h"
#include "viewer/window/viewer_model.h"

namespace glint {

class PictureSource {
  public:
    /// Brings the display up to date; uploads only what is new.
    void show(const ViewerModel& model, ImageDisplay* display);

  private:
    std::shared_ptr<const FilmSnapshot> shown_;
    ShownPicture shownKind_ = ShownPicture::Radiance;
    std::vector<float> falseColors_;
};

/// 3 display values a pixel. Empty when the snapshot does not carry that picture (yet).
std::vector<float> falseColors(const FilmSnapshot& snapshot, ShownPicture shown);

}  // namespace glint
