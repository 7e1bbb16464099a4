// Which pixel and which area are looked at closely.
#pragma once

#include <memory>
#include <optional>

#include "engine/math/vec.h"
#include "viewer/model/area_statistics.h"
#include "viewer/model/histogram.h"

namespace glint {

struct Inspector {
    std::optional<Vec2i> pixel;  ///< the last one that the mouse was over; it may be outside by now
    /// The panel was drawn in this frame: snapshots are to carry what it tells.
    bool isOpen = false;

    bool picksArea = false;            ///< the next drag on the picture draws it
    std::optional<FilmRegion> area{};  ///< that is measured
    AreaStatistics statistics{};
    std::shared_ptr<const FilmSnapshot> statisticsOf{};  ///< null: `area` is not measured yet

    // The histogram, and what it is of.
    Histogram histogram{};
    std::shared_ptr<const FilmSnapshot> histogramOf{};
    DisplayLook look{};
};

}  // namespace glint
