#include "viewer/model/denoised_picture.h"

#include "engine/base/thread_priority.h"

namespace glint {

void DenoisedPicture::refresh(const std::shared_ptr<const FilmSnapshot>& wanted, bool rests) {
    jobs_.runCompletions();
    isBehind_ = false;
    const bool isPossible = wanted && wanted->aovs && !wanted->standardError.empty();
    if (!wanted) {
        stop();
        picture_.reset();
        made_ = {};
        return;
    }
    const bool isStill = rests && wanted->previewScale == 1;
    const Of of{wanted, isStill ? DenoiseQuality::Careful : DenoiseQuality::Quick};
    if (of == made_) { return; }
    // Passes may come faster than they are denoised.
    isBehind_ = isStill || !picture_ || picture_->ticket != wanted->ticket ||
                picture_->previewScale != wanted->previewScale;
    if (stopsWork_) {
        // What takes long is given up for what is newer.
        if (working_.quality == DenoiseQuality::Careful && !(working_ == of)) { stop(); }
    } else if (isPossible) {
        start(of);
    }
}

void DenoisedPicture::start(const Of& of) {
    working_ = of;
    stopsWork_ = std::make_shared<std::atomic<bool>>(false);
    jobs_.start(
        [this, of, stop = stopsWork_]() -> JobQueue::Completion {
            lowerThreadPriority();
            std::shared_ptr<const FilmSnapshot> picture =
                denoisedSnapshot(*of.snapshot, of.quality, 0, stop.get());
            return [this, of, picture, stop] {
                stopsWork_.reset();
                working_ = {};
                if (*stop || !picture) { return; }
                picture_ = picture;
                made_ = of;
            };
        },
        false);
}

}  // namespace glint
