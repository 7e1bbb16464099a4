#include "viewer/model/waveform.h"

#include <algorithm>

namespace glint {
namespace {

constexpr size_t kColumns = 126;  // of all panes
constexpr size_t kMostPixels = 1 << 15;

size_t levelOf(float shown) {
    const size_t level = displayByte(shown) * Waveform::kLevels / 256;
    return std::min(level, Waveform::kLevels - 1);
}

void divide(std::vector<float>* shares) {
    for (auto column = shares->begin(); column != shares->end(); column += Waveform::kLevels) {
        float sum = 0.0f;
        for (size_t i = 0; i < Waveform::kLevels; ++i) {
            sum += column[i];
        }
        for (size_t i = 0; sum > 0.0f && i < Waveform::kLevels; ++i) {
            column[i] /= sum;
        }
    }
}

}  // namespace

Waveform waveformOf(const FilmSnapshot& snapshot, const DisplayLook& look, WaveformKind kind) {
    const ToneMapper toned(look);
    Waveform waveform;
    waveform.panes = kind == WaveformKind::Parade ? 3 : 1;
    const auto width = static_cast<size_t>(std::max(snapshot.width, 0));
    const auto height = width > 0 ? snapshot.radiance.size() / (3 * width) : 0;
    waveform.columnsPerPane = std::min(kColumns / waveform.panes, width);
    waveform.shares.assign(waveform.panes * waveform.columnsPerPane * Waveform::kLevels, 0.0f);
    const auto add = [&waveform](size_t pane, size_t column, float shown) {
        waveform.shares[(pane * waveform.columnsPerPane + column) * Waveform::kLevels + levelOf(shown)] +=
            1.0f;
    };
    // A step that shares no factor with the width would do, too; rows and columns apart keep every
    // column alike.
    const size_t stepX = width / (4 * kColumns) + 1;
    const size_t stepY = height * (width / stepX + 1) / kMostPixels + 1;
    for (size_t y = 0; y < height; y += stepY) {
        for (size_t x = 0; x < width; x += stepX) {
            const float* rgb = snapshot.radiance.data() + 3 * (y * width + x);
            const Vec3 shown = toned({rgb[0], rgb[1], rgb[2]});
            const size_t column = x * waveform.columnsPerPane / width;
            if (kind == WaveformKind::Luminance) {
                add(0, column, luminance(shown));
                continue;
            }
            for (size_t c = 0; c < 3; ++c) {
                add(c, column, shown[static_cast<int>(c)]);
            }
        }
    }
    divide(&waveform.shares);
    return waveform;
}

}  // namespace glint
