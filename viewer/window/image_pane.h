// An image on the graphics card together with what brings it up to date.
#pragma once

#include <memory>

#include "viewer/window/image_display.h"
#include "viewer/window/shown_image_source.h"

namespace glint {

struct ImagePane {
    std::unique_ptr<ImageDisplay> display;
    ShownImageSource source;
    std::shared_ptr<const FilmSnapshot> drawn;  ///< that the last frame had
};

/// The scene's own integrator, and the one that it is compared with, which matters while the image is split.
struct ImagePanes {
    ImagePane own;
    ImagePane other;
};

}  // namespace glint
