// The part of the picture that is rendered on alone, as the user draws it.
#pragma once

#include <optional>

#include "engine/math/vec.h"
#include "engine/render/film_region.h"

namespace glint {

struct RegionTool {
    bool picks = false;                 ///< the next drag on the picture draws one
    std::optional<FilmRegion> drawn{};  ///< stays until it is given up
    std::optional<FilmRegion> spot{};   ///< around the mouse, while its key is held; goes before `drawn`

    /// The next drag draws one; or, where there is one, the whole picture goes on.
    void askOrGiveUp() {
        picks = !picks && !drawn;
        drawn.reset();
    }
    const std::optional<FilmRegion>& wanted() const { return spot ? spot : drawn; }
};

/// Both corners' pixels and those between.
FilmRegion regionBetween(Vec2i a, Vec2i b);
/// A square of a sixth of the picture's height around the pixel, in steps, so that a hand that trembles
/// changes nothing.
FilmRegion spotAround(Vec2i pixel, int imageHeight);

}  // namespace glint
