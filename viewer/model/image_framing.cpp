#include "viewer/model/image_framing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace glint {
namespace {

constexpr std::array kZooms{1.0f / 16, 1.0f / 8, 1.0f / 4, 1.0f / 3, 1.0f / 2, 1.0f,  2.0f, 3.0f,
                            4.0f,      6.0f,     8.0f,     12.0f,    16.0f,    24.0f, 32.0f};
constexpr size_t kOneToOne = 5;
static_assert(kZooms[kOneToOne] == 1.0f);
constexpr int kBeforeZooms = 2;  // choices

float fittingZoom(const ImageArea& area) {
    const Vec2 shares = (area.max - area.min) * area.pixelScale / Vec2(area.image);
    return std::max(std::min(shares.x, shares.y), 1e-3f);
}

/// Where the picture begins along one axis, in screen pixels: centred where there is room, otherwise with
/// `middle` in the middle as far as no edge is drawn into the area.
float beginOf(float areaMin, float areaMax, float shown, float middle) {
    const float room = areaMax - areaMin;
    if (shown <= room) { return std::floor(areaMin + (room - shown) * 0.5f); }
    const float wanted = areaMin + room * 0.5f - shown * middle;
    return std::floor(std::clamp(wanted, areaMax - shown, areaMin));
}

}  // namespace

std::span<const float> imageZooms() { return kZooms; }

Vec2i pixelAt(const PlacedImage& placed, Vec2 at) {
    return Vec2i(glm::floor((at - placed.min) / placed.unitsPerPixel));
}

PlacedImage ImageFraming::place(const ImageArea& area) const {
    PlacedImage placed;
    placed.zoom = fittingZoom(area);
    if (size_ == Size::Zoom) { placed.zoom = kZooms[step_]; }
    if (size_ == Size::Automatic && placed.zoom > 1.0f) { placed.zoom = std::floor(placed.zoom); }
    placed.unitsPerPixel = placed.zoom / area.pixelScale;
    const Vec2 middle = size_ == Size::Zoom ? middle_ : Vec2(0.5f);
    const Vec2 areaMin = area.min * area.pixelScale;
    const Vec2 areaMax = area.max * area.pixelScale;
    const Vec2 shown = Vec2(area.image) * placed.zoom;
    const Vec2 begin(beginOf(areaMin.x, areaMax.x, shown.x, middle.x),
                     beginOf(areaMin.y, areaMax.y, shown.y, middle.y));
    placed.min = begin / area.pixelScale;
    placed.max = (begin + shown) / area.pixelScale;
    return placed;
}

void ImageFraming::zoomBy(int steps, Vec2 at, const ImageArea& area) {
    const PlacedImage before = place(area);
    const auto above = std::ranges::upper_bound(kZooms, before.zoom * 1.001f);
    const auto notBelow = std::ranges::lower_bound(kZooms, before.zoom * 0.999f);
    const auto next = steps > 0 ? above - kZooms.begin() + steps - 1 : notBelow - kZooms.begin() + steps;
    if (steps == 0) { return; }
    const auto last = static_cast<std::ptrdiff_t>(kZooms.size()) - 1;
    step_ = static_cast<size_t>(std::clamp<std::ptrdiff_t>(next, 0, last));
    size_ = Size::Zoom;
    const Vec2 share = (at - before.min) / (before.max - before.min);
    const Vec2 shown = Vec2(area.image) * (kZooms[step_] / area.pixelScale);
    middle_ = share + ((area.min + area.max) * 0.5f - at) / shown;
    panBy(Vec2(0.0f), area);
}

void ImageFraming::panBy(Vec2 units, const ImageArea& area) {
    if (size_ != Size::Zoom) { return; }
    middle_ -= units / (Vec2(area.image) * (kZooms[step_] / area.pixelScale));
    // Not past what place() shows: the way back would seem to hang.
    const Vec2 half = (area.max - area.min) * area.pixelScale / (Vec2(area.image) * kZooms[step_]) * 0.5f;
    const Vec2 inset = glm::min(half, Vec2(0.5f));
    middle_ = glm::clamp(middle_, inset, Vec2(1.0f) - inset);
}

std::vector<std::string> ImageFraming::choices() {
    std::vector<std::string> names{"Automatic", "Fit the window"};
    for (const float zoom : kZooms) {
        const bool isSmall = zoom < 1.0f;
        const auto whole = std::lround(isSmall ? 1.0f / zoom : zoom);
        names.push_back(
            fmt::format("{}:{}{}", isSmall ? 1 : whole, isSmall ? whole : 1, whole == 1 ? " pixels" : ""));
    }
    return names;
}

int ImageFraming::choice() const {
    return size_ == Size::Zoom ? kBeforeZooms + static_cast<int>(step_) : static_cast<int>(size_);
}

void ImageFraming::choose(int index) {
    size_ = static_cast<Size>(std::min(index, kBeforeZooms));
    if (size_ == Size::Zoom) { step_ = static_cast<size_t>(index - kBeforeZooms); }
}

void ImageFraming::chooseOneToOne() { choose(kBeforeZooms + static_cast<int>(kOneToOne)); }

}  // namespace glint
