#include "viewer/model/ocio_chooser.h"

namespace glint {

void OcioChooser::load(const OcioChoice& choice) {
    isLoading_ = true;
    jobs_->start(
        [this, choice, number = ++asked_]() -> JobQueue::Completion {
            auto view = loadOcioView(choice);
            return [this, number, view] {
                if (number != asked_) { return; }
                isLoading_ = false;
                view ? use(*view) : notice_->tell(view.error(), "");
            };
        },
        false);
}

void OcioChooser::use(const std::shared_ptr<const OcioView>& view) {
    display_->view = view;
    config = view->choice.config;
    isWanted = false;
}

void OcioChooser::giveUp() {
    ++asked_;
    isLoading_ = isWanted = false;
}

}  // namespace glint
