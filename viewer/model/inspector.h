// Which pixel and which area are looked at closely.
#pragma once

#include <memory>
#include <optional>

#include "engine/math/vec.h"
#include "viewer/model/area_statistics.h"
#include "viewer/model/histogram.h"
#include "viewer/model/waveform.h"

namespace glint {

enum class ScopeKind : uint8_t { Histogram, Luminance, Parade };

struct Inspector {
    std::optional<Vec2i> pixel;  ///< the last one that the mouse was over; it may be outside by now
    /// The panel was drawn in this frame: snapshots are to carry what it tells.
    bool isOpen = false;

    bool picksArea = false;            ///< the next drag on the picture draws it
    std::optional<FilmRegion> area{};  ///< that is measured
    AreaStatistics statistics{};
    std::shared_ptr<const FilmSnapshot> statisticsOf{};  ///< null: `area` is not measured yet

    std::shared_ptr<const FilmSnapshot> image{};  ///< that is shown, without its noise or kept; null: none

    // Histogram or waveform, and what it is of.
    ScopeKind scope = ScopeKind::Histogram;
    Histogram histogram{};
    Waveform waveform{};
    struct ScopeOf {
        std::shared_ptr<const FilmSnapshot> snapshot;
        DisplayLook look{};
        ScopeKind kind = ScopeKind::Histogram;

        bool operator==(const ScopeOf&) const = default;
    };
    ScopeOf scopeOf{};
};

}  // namespace glint
