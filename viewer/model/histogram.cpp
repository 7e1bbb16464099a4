#include "viewer/model/histogram.h"

namespace glint {
namespace {

constexpr size_t kMostPixels = 1 << 16;  // about 3 ms

}  // namespace

Histogram histogramOf(const FilmSnapshot& snapshot, const DisplayLook& look) {
    const ToneMapper toned(look);
    Histogram histogram;
    const size_t pixels = snapshot.radiance.size() / 3;
    const size_t step = pixels / kMostPixels + 1;
    const size_t count = (pixels + step - 1) / step;
    const float share = count > 0 ? 1.0f / static_cast<float>(count) : 0.0f;
    for (size_t i = 0; i < pixels; i += step) {
        const float* rgb = snapshot.radiance.data() + 3 * i;
        const Vec3 shown = toned({rgb[0], rgb[1], rgb[2]});
        int sum = 0;
        bool isWhite = false;
        for (int c = 0; c < 3; ++c) {
            const uint8_t byte = displayByte(shown[c]);
            histogram.bins[static_cast<size_t>(c)][byte * Histogram::kBins / 256] += share;
            sum += byte;
            isWhite = isWhite || byte == 255;
        }
        histogram.black += sum == 0 ? share : 0.0f;
        histogram.white += isWhite ? share : 0.0f;
    }
    return histogram;
}

}  // namespace glint
