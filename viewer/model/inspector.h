// Which pixel is looked at closely.
#pragma once

#include <memory>
#include <optional>

#include "engine/math/vec.h"
#include "viewer/model/histogram.h"

namespace glint {

struct Inspector {
    std::optional<Vec2i> pixel;  ///< the last one that the mouse was over; it may be outside by now
    /// The panel was drawn in this frame: snapshots are to carry what it tells.
    bool isOpen = false;

    // The histogram, and what it is of.
    Histogram histogram{};
    std::shared_ptr<const FilmSnapshot> histogramOf{};
    DisplayLook look{};
};

}  // namespace glint
