// Which pictures are on the screen, and what is compared.
#include "viewer/model/workspace.h"

namespace glint {

/// Two integrators are compared as they are; what failed gets no layers any more.
bool Workspace::wantsDenoised() const {
    return display.denoises && !display.split && infoOf(display.shown).isRadiance() &&
           render.status().state != SessionState::Failed;
}

const std::shared_ptr<const FilmSnapshot>& Workspace::liveImage() const {
    return wantsDenoised() && denoised.image() ? denoised.image() : render.snapshot();
}

const std::shared_ptr<const FilmSnapshot>& Workspace::ownImage() const {
    const KeptRender* right = snapshots.isComparing() ? snapshots.find(snapshots.right) : nullptr;
    return right != nullptr ? right->image : liveImage();
}

const std::shared_ptr<const FilmSnapshot>& Workspace::otherImage() const {
    const KeptRender* left = snapshots.find(snapshots.left);
    return left != nullptr ? left->image : render.otherSnapshot();
}

bool Workspace::ownIsRight() const {
    return snapshots.isComparing() || document.draft().options.integrator == comparedPair().right;
}

void Workspace::refreshDifference() {
    const bool isWanted = isComparing();
    const auto& right = ownIsRight() ? ownImage() : otherImage();
    const auto& left = ownIsRight() ? otherImage() : ownImage();
    difference.refresh({isWanted ? display.compareView : CompareView::Wipe, left, right,
                        display.compareView == CompareView::FlipMap ? display.exposureStops : 0.0f});
}

/// The scene of a picture that was kept, as an edit or as another scene that is opened.
void Workspace::openSceneOf(const KeptRender& kept) {
    display.take(kept.look);
    if (kept.scene->path == document.draft().path) {
        document.draft() = *kept.scene;
        document.nameEdit("Back to " + kept.name());
    } else {
        adopt(*kept.scene, false);
    }
}

bool Workspace::carriesShownImage() const {
    const auto& own = render.snapshot();
    const auto& other = render.otherSnapshot();
    if (!own || !carries(*own, display.shown)) { return false; }
    return !display.split || (other && other->previewScale == 1 && carries(*other, display.shown));
}

}  // namespace glint
