#include "viewer/model/denoised_view.h"

#include "engine/base/thread_priority.h"

namespace glint {

void DenoisedView::refresh(const std::shared_ptr<const FilmSnapshot>& wanted, bool rests) {
    jobs_.runCompletions();
    isBehind_ = false;
    const bool isPossible = wanted && wanted->aovs && !wanted->standardError.empty();
    if (!wanted) {
        stop();
        image_.reset();
        made_ = {};
        return;
    }
    const bool isStill = rests && wanted->previewScale == 1;
    const Of of{wanted, isStill ? DenoiseQuality::Careful : DenoiseQuality::Quick};
    if (of == made_) { return; }
    // Passes may come faster than they are denoised.
    isBehind_ = isStill || !image_ || image_->ticket != wanted->ticket ||
                image_->previewScale != wanted->previewScale;
    if (stopsWork_) {
        // What takes long is given up for what is newer.
        if (working_.quality == DenoiseQuality::Careful && !(working_ == of)) { stop(); }
    } else if (isPossible) {
        start(of);
    }
}

void DenoisedView::start(const Of& of) {
    working_ = of;
    stopsWork_ = std::make_shared<std::atomic<bool>>(false);
    jobs_.start(
        [this, of, stop = stopsWork_]() -> JobQueue::Completion {
            lowerThreadPriority();
            std::shared_ptr<const FilmSnapshot> image =
                denoisedSnapshot(*of.snapshot, of.quality, 0, stop.get());
            return [this, of, image, stop] {
                stopsWork_.reset();
                working_ = {};
                if (*stop || !image) { return; }
                image_ = image;
                made_ = of;
            };
        },
        false);
}

}  // namespace glint
