#include "viewer/model/snapshots.h"

#include <algorithm>

#include <fmt/format.h>

#include "engine/scene/scene_diff.h"
#include "viewer/base/units.h"

namespace glint {
namespace {

constexpr int kThumbnailSide = 96;

std::string summaryOf(const FilmSnapshot& image) {
    std::string text = fmt::format("{} · {} · {}", inCapitals(integratorInfo(image.integrator).alias),
                                   passCount(image.passes), duration(image.renderSeconds));
    if (image.isDenoised) { text += " · denoised"; }
    if (image.passes > 1) {
        text +=
            " · error " + percentWithin(image.relativeError, image.relativeErrorLow, image.relativeErrorHigh);
    }
    return text;
}

}  // namespace

bool Snapshots::keep(const std::shared_ptr<const FilmSnapshot>& image,
                     std::shared_ptr<const SceneDescription> scene, const DisplaySettings& display) {
    if (!image || image->radiance.empty() || image->previewScale > 1) { return false; }
    kept_.push_back({.number = ++lastNumber_,
                     .summary = summaryOf(*image),
                     .image = image,
                     .scene = std::move(scene),
                     .look = display.look(),
                     .thumbnail = makeThumbnail(*image, display.look(), kThumbnailSide)});
    return true;
}

size_t Snapshots::differences(const KeptRender& kept,
                              const std::shared_ptr<const SceneDescription>& now) const {
    Found& found = found_[kept.number];
    if (found.of != now) { found = {now, listDifferences(*kept.scene, *now).size()}; }
    return found.differences;
}

void Snapshots::remove(int number) {
    found_.erase(number);
    std::erase_if(kept_, [number](const KeptRender& each) { return each.number == number; });
    if (left == number) { left = 0; }
    if (right == number) { right = 0; }
}

const KeptRender* Snapshots::find(int number) const {
    const auto found = std::ranges::find(kept_, number, &KeptRender::number);
    return found != kept_.end() ? &*found : nullptr;
}

}  // namespace glint
