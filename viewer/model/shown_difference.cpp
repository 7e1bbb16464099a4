#include "viewer/model/shown_difference.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "engine/base/thread_priority.h"
#include "engine/math/color.h"
#include "engine/report/flip.h"
#include "engine/report/metrics.h"

namespace glint {
namespace {

float luminanceAt(const FilmSnapshot& image, size_t pixel) {
    const float* rgb = image.radiance.data() + 3 * pixel;
    return luminance(Vec3(rgb[0], rgb[1], rgb[2]));
}

double meanOf(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

ImageF imageOf(const FilmSnapshot& image) { return {image.width, image.height, image.radiance}; }

}  // namespace

ShownDifference::Made makeDifference(const ShownDifference::Wanted& wanted) {
    ShownDifference::Made made{wanted, {}, {}, 0.0};
    const FilmSnapshot& left = *wanted.left;
    const FilmSnapshot& right = *wanted.right;
    if (left.width != right.width || left.height != right.height || left.radiance.empty()) { return made; }
    std::vector<float> values(left.radiance.size() / 3);
    if (wanted.view == CompareView::SignedDifference) {
        for (size_t i = 0; i < values.size(); ++i) {
            values[i] = luminanceAt(left, i) - luminanceAt(right, i);
        }
        made.rgba = mapColors(values, MapColors::Signed, &made.scale);
    } else {
        values = flipMap(imageOf(left), imageOf(right), static_cast<double>(wanted.exposureStops),
                         kDefaultPixelsPerDegree, 0);
        made.scale.heat = {0.0f, 1.0f};
        made.rgba.reserve(values.size() * 4);
        for (const float value : values) {
            const Vec3 color = heatColor(std::clamp(value, 0.0f, 1.0f));
            for (int c = 0; c < 3; ++c) {
                made.rgba.push_back(displayByte(color[c]));
            }
            made.rgba.push_back(255);
        }
    }
    made.mean = meanOf(values);
    return made;
}

void ShownDifference::refresh(const Wanted& wanted) {
    jobs_.runCompletions();
    isWaiting_ = false;
    if (!isDifference(wanted.view) || !wanted.left || !wanted.right || wanted == wanted_) { return; }
    isWaiting_ = isMaking_;
    if (isMaking_) { return; }
    wanted_ = wanted;
    isMaking_ = true;
    jobs_.start(
        [this, wanted]() -> JobQueue::Completion {
            lowerThreadPriority();
            auto made = std::make_shared<const Made>(makeDifference(wanted));
            return [this, made] {
                isMaking_ = false;
                made_ = made;
            };
        },
        false);
}

}  // namespace glint
