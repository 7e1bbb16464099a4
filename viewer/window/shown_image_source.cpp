#include "viewer/window/shown_image_source.h"

#include <utility>

#include "engine/base/thread_priority.h"

namespace glint {
namespace {

// About 4 ms of colouring, and 50 ms of drawing where OpenGL runs on the processor.
constexpr size_t kColoredAtOnce = size_t{1} << 17;
constexpr size_t kDrawnAtOnce = size_t{1} << 20;
/// OpenColorIO's views take 0.2 microseconds a pixel.
constexpr size_t kViewedAtOnce = size_t{1} << 14;

size_t pixelsOf(const FilmSnapshot& snapshot) {
    return static_cast<size_t>(snapshot.width) * static_cast<size_t>(snapshot.height);
}

/// The shader would take too long over this picture, or does not know its view.
bool isForProcessor(const FilmSnapshot& snapshot, const DisplayLook& look, const ImageDisplay& display) {
    return look.view || (display.isSoftware() && pixelsOf(snapshot) > kDrawnAtOnce);
}

bool isSame(const MapScale& a, const MapScale& b) {
    return a.heat.smallest == b.heat.smallest && a.heat.largest == b.heat.largest && a.isSigned == b.isSigned;
}

}  // namespace

ShownImageSource::Colors ShownImageSource::colored(Wanted of, ShownImage image, MapScale scale) {
    Colors colors{std::move(of), image, scale, {}};
    if (image == ShownImage::Radiance) {
        colors.rgba = toneMappedColors(*colors.of.snapshot, colors.of.look);
    } else {
        colors.rgba = falseColors(*colors.of.snapshot, image, colors.of.reference.get(), &colors.scale);
    }
    return colors;
}

void ShownImageSource::start(const Wanted& wanted, ShownImage image, const MapScale& scale) {
    isColoring_ = true;
    jobs_.start(
        [this, wanted, image, scale]() -> JobQueue::Completion {
            lowerThreadPriority();
            auto colors = std::make_shared<Colors>(colored(wanted, image, scale));
            return [this, colors] {
                isColoring_ = false;
                ready_ = std::move(*colors);
            };
        },
        false);
}

bool ShownImageSource::isReady() {
    jobs_.runCompletions();
    return ready_.has_value();
}

void ShownImageSource::putRadiance(const Wanted& wanted, ImageDisplay* display) {
    const FilmSnapshot& snapshot = *wanted.snapshot;
    display->upload(snapshot.radiance.data(), snapshot.width, snapshot.height, snapshot.previewScale > 1);
    shownImage_ = ShownImage::Radiance;
    shownIntegrator_ = snapshot.integrator;
    scale_ = {};
    shown_ = wanted;
}

/// What has not been made yet leaves the picture before on the screen, but not another integrator's.
void ShownImageSource::put(Colors colors, ImageDisplay* display) {
    const FilmSnapshot& snapshot = *colors.of.snapshot;
    if (colors.rgba.size() == pixelsOf(snapshot) * 4) {
        display->uploadColors(colors.rgba.data(), snapshot.width, snapshot.height, snapshot.previewScale > 1);
        shownImage_ = colors.image;
        shownIntegrator_ = snapshot.integrator;
        scale_ = colors.image == ShownImage::Radiance ? MapScale{} : colors.scale;
    } else if (snapshot.integrator != shownIntegrator_) {
        putRadiance(colors.of, display);
    }
    shown_ = std::move(colors.of);
}

bool ShownImageSource::isNew(const Wanted& wanted, ShownImage image, const ShownImageSource* alongside,
                             const ImageDisplay& display) const {
    if (wanted.snapshot != shown_.snapshot || wanted.shown != shown_.shown ||
        wanted.reference != shown_.reference) {
        return true;
    }
    if (image == ShownImage::Radiance) {
        const bool isColored = isForProcessor(*wanted.snapshot, wanted.look, display) ||
                               isForProcessor(*wanted.snapshot, shown_.look, display);
        return isColored && !(wanted.look == shown_.look);
    }
    return alongside != nullptr && alongside->shownImage() == image && shownImage_ == image &&
           alongside->scale().isThere() && !isSame(alongside->scale(), scale_);
}

void ShownImageSource::bringUp(const Wanted& wanted, ShownImage image, const MapScale& scale,
                               ImageDisplay* display) {
    const bool isRadiance = image == ShownImage::Radiance;
    if (isRadiance && !isForProcessor(*wanted.snapshot, wanted.look, *display)) {
        putRadiance(wanted, display);
    } else if (pixelsOf(*wanted.snapshot) <=
               (isRadiance && wanted.look.view ? kViewedAtOnce : kColoredAtOnce)) {
        put(colored(wanted, image, scale), display);
    } else {
        isBehind_ = true;
        if (!isColoring_) { start(wanted, image, scale); }
    }
}

void ShownImageSource::show(const Wanted& wanted, const ShownImageSource* alongside, ImageDisplay* display) {
    isBehind_ = false;
    if (isReady()) {
        // Of an older edit or another choice: the picture on the display is newer.
        const bool isWanted = wanted.snapshot && ready_->of.shown == wanted.shown &&
                              ready_->of.reference == wanted.reference &&
                              ready_->of.snapshot->ticket == wanted.snapshot->ticket &&
                              ready_->of.snapshot->integrator == wanted.snapshot->integrator;
        if (isWanted) { put(std::move(*ready_), display); }
        ready_.reset();
    }
    if (wanted.snapshot && wanted.snapshot->width > 0) {
        const ShownImage image = availableImage(*wanted.snapshot, wanted.shown, wanted.reference.get());
        if (isNew(wanted, image, alongside, *display)) {
            if (alongside != nullptr && alongside->isBehind()) {
                isBehind_ = true;  // its scale is not known yet
            } else {
                const bool shares = alongside != nullptr && alongside->shownImage() == image;
                bringUp(wanted, image, shares ? alongside->scale() : MapScale{}, display);
            }
        }
    }
    display->update(wanted.look);
}

}  // namespace glint
