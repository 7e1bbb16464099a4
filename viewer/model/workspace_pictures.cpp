// Which pictures are on the screen, and what is compared.
#include "viewer/model/workspace.h"

namespace glint {

/// Two integrators are compared as they are; what failed gets no layers any more.
bool Workspace::wantsDenoised() const {
    return display.denoises && !display.split && infoOf(display.shown).isRadiance() &&
           render.status().state != SessionState::Failed;
}

const std::shared_ptr<const FilmSnapshot>& Workspace::livePicture() const {
    return wantsDenoised() && denoised.picture() ? denoised.picture() : render.snapshot();
}

const std::shared_ptr<const FilmSnapshot>& Workspace::ownPicture() const {
    const KeptPicture* right = snapshots.isComparing() ? snapshots.find(snapshots.right) : nullptr;
    return right != nullptr ? right->picture : livePicture();
}

const std::shared_ptr<const FilmSnapshot>& Workspace::otherPicture() const {
    const KeptPicture* left = snapshots.find(snapshots.left);
    return left != nullptr ? left->picture : render.otherSnapshot();
}

bool Workspace::ownIsRight() const {
    return snapshots.isComparing() || document.draft().options.integrator == comparedPair().right;
}

void Workspace::refreshDifference() {
    const bool isWanted = isComparing();
    const auto& right = ownIsRight() ? ownPicture() : otherPicture();
    const auto& left = ownIsRight() ? otherPicture() : ownPicture();
    difference.refresh({isWanted ? display.compareView : CompareView::Wipe, left, right,
                        display.compareView == CompareView::FlipMap ? display.exposureStops : 0.0f});
}

/// The scene of a picture that was kept, as an edit or as another scene that is opened.
void Workspace::openSceneOf(const KeptPicture& kept) {
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
