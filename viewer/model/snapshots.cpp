#include "viewer/model/snapshots.h"

#include <algorithm>

#include <fmt/format.h>

#include "engine/scene/scene_diff.h"
#include "viewer/base/units.h"

namespace glint {
namespace {

constexpr int kThumbnailSide = 96;

std::string summaryOf(const FilmSnapshot& picture) {
    std::string text = fmt::format("{} · {} · {}", inCapitals(integratorInfo(picture.integrator).alias),
                                   passCount(picture.passes), duration(picture.renderSeconds));
    if (picture.isDenoised) { text += " · denoised"; }
    if (picture.passes > 1) {
        text += " · error " +
                percentWithin(picture.relativeError, picture.relativeErrorLow, picture.relativeErrorHigh);
    }
    return text;
}

}  // namespace

bool Snapshots::keep(const std::shared_ptr<const FilmSnapshot>& picture,
                     std::shared_ptr<const SceneDescription> scene, const DisplaySettings& display) {
    if (!picture || picture->radiance.empty() || picture->previewScale > 1) { return false; }
    kept_.push_back({.number = ++lastNumber_,
                     .summary = summaryOf(*picture),
                     .picture = picture,
                     .scene = std::move(scene),
                     .look = display.look(),
                     .thumbnail = makeThumbnail(*picture, display.look(), kThumbnailSide)});
    return true;
}

size_t Snapshots::differences(const KeptPicture& kept,
                              const std::shared_ptr<const SceneDescription>& now) const {
    Found& found = found_[kept.number];
    if (found.of != now) { found = {now, listDifferences(*kept.scene, *now).size()}; }
    return found.differences;
}

void Snapshots::remove(int number) {
    found_.erase(number);
    std::erase_if(kept_, [number](const KeptPicture& each) { return each.number == number; });
    if (left == number) { left = 0; }
    if (right == number) { right = 0; }
}

const KeptPicture* Snapshots::find(int number) const {
    const auto found = std::ranges::find(kept_, number, &KeptPicture::number);
    return found != kept_.end() ? &*found : nullptr;
}

}  // namespace glint
