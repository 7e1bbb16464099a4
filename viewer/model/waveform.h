// The display values of a picture from its left to its right: one pane of luminance, or a parade of red,
// green and blue.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/render/film_snapshot.h"
#include "engine/render/tonemap.h"

namespace glint {

enum class WaveformKind : uint8_t { Luminance, Parade };

struct Waveform {
    static constexpr size_t kLevels = 64;  ///< from black to white
    size_t panes = 0;                      ///< side by side: 1 of luma (Rec.709), or 3 of red, green and blue
    size_t columnsPerPane = 0;
    /// Shares of a column's pixels, pane by pane, column by column, from black to white.
    std::vector<float> shares{};

    float share(size_t pane, size_t column, size_t level) const {
        return shares[(pane * columnsPerPane + column) * kLevels + level];
    }
};

/// Of the radiance as it is shown; of large pictures some of the pixels, evenly spread.
Waveform waveformOf(const FilmSnapshot& snapshot, const DisplayLook& look, WaveformKind kind);

}  // namespace glint
