#include "viewer/window/image_pane.h"

#include <utility>

namespace glint {

Status ImagePanes::create(const GlApi& gl) {
    for (auto* made : {&own.display, &other.display, &overlay, &difference}) {
        auto display = ImageDisplay::create(gl);
        if (!display) { return display.error(); }
        *made = std::move(*display);
    }
    thumbnails.create(gl);
    return {};
}

void ImagePanes::release() {
    own.display.reset();
    other.display.reset();
    overlay.reset();
    difference.reset();
    thumbnails.release();
}

void ImagePanes::takeOverlay(const FocusOverlay& focus) {
    const bool isNew = std::exchange(overlayVersion, focus.version()) != focus.version();
    if (!isNew || focus.colors().empty()) { return; }
    overlay->uploadColors(focus.colors().data(), focus.width(), focus.height(), true);
}

void ImagePanes::takeDifference(const ShownDifference& made) {
    if (made.made() == differenceOf) { return; }
    differenceOf = made.made();
    const auto& image = differenceOf->of.left;
    if (differenceOf->rgba.empty()) { return; }
    difference->uploadColors(differenceOf->rgba.data(), image->width, image->height, false);
}

void ImagePanes::takeColors(Workspace* workspace) {
    takeOverlay(workspace->focusOverlay);
    takeDifference(workspace->difference);
    thumbnails.update(*workspace);
}

void ImagePanes::show(Workspace* workspace) {
    const DisplaySettings& settings = workspace->display;
    const bool isComparing = workspace->isComparing();
    ShownImageSource::Wanted wanted{workspace->ownImage(), settings.shown,
                                    workspace->convergence.usableReference(), settings.look()};
    own.source.show(wanted, nullptr, own.display.get());
    if (isComparing) {
        wanted.snapshot = workspace->otherImage();
        // What was not kept with a picture cannot be asked for any more.
        const bool isThere = wanted.snapshot && carries(*wanted.snapshot, wanted.shown);
        if (workspace->snapshots.isComparing() && !isThere) { wanted.shown = ShownImage::Radiance; }
        other.source.show(wanted, &own.source, other.display.get());
    }
    workspace->displayIsBehind = workspace->denoised.isBehind() || workspace->focusOverlay.isBehind() ||
                                 own.source.isBehind() || workspace->difference.isBehind() ||
                                 (isComparing && other.source.isBehind());
    own.drawn = workspace->render.snapshot();
    other.drawn = workspace->render.otherSnapshot();
}

bool ImagePanes::areOld(const Workspace& workspace) {
    return workspace.render.snapshot() != own.drawn || workspace.render.otherSnapshot() != other.drawn ||
           workspace.focusOverlay.version() != overlayVersion || workspace.focusOverlay.isBehind() ||
           workspace.difference.made() != differenceOf || workspace.difference.isBehind() ||
           workspace.denoised.isBehind() || own.source.isReady() || other.source.isReady();
}

}  // namespace glint
