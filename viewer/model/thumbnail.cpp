#include "viewer/model/thumbnail.h"

#include <algorithm>
#include <atomic>

namespace glint {
namespace {

Vec3 meanOf(const FilmSnapshot& image, int x0, int y0, int x1, int y1) {
    Vec3 sum(0.0f);
    for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
            const float* rgb = image.radiance.data() + 3 * (static_cast<size_t>(y) * image.width + x);
            sum += Vec3(rgb[0], rgb[1], rgb[2]);
        }
    }
    return sum / static_cast<float>((x1 - x0) * (y1 - y0));
}

}  // namespace

uint64_t newThumbnailId() {
    static std::atomic<uint64_t> last{0};
    return ++last;
}

Thumbnail makeThumbnail(const FilmSnapshot& image, const DisplayLook& look, int side) {
    const ToneMapper toned(look);
    const int longest = std::max(image.width, image.height);
    const auto scaled = [&](int length) { return std::max(1, length * std::min(side, longest) / longest); };
    Thumbnail out{scaled(image.width), scaled(image.height), {}, newThumbnailId()};
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            const Vec3 mean = meanOf(image, x * image.width / out.width, y * image.height / out.height,
                                     (x + 1) * image.width / out.width, (y + 1) * image.height / out.height);
            const Vec3 shown = toned(mean);
            for (int c = 0; c < 3; ++c) {
                out.rgba.push_back(displayByte(shown[c]));
            }
            out.rgba.push_back(255);
        }
    }
    return out;
}

}  // namespace glint
