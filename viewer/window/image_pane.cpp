#include "viewer/window/image_pane.h"

#include <utility>

namespace glint {

Status ImagePanes::create(const GlApi& gl) {
    for (auto* made : {&own.display, &other.display, &overlay}) {
        auto display = ImageDisplay::create(gl);
        if (!display) { return display.error(); }
        *made = std::move(*display);
    }
    return {};
}

void ImagePanes::release() {
    own.display.reset();
    other.display.reset();
    overlay.reset();
}

void ImagePanes::takeOverlay(const FocusOverlay& focus) {
    const bool isNew = std::exchange(overlayVersion, focus.version()) != focus.version();
    if (!isNew || focus.colors().empty()) { return; }
    overlay->uploadColors(focus.colors().data(), focus.width(), focus.height(), true);
}

void ImagePanes::show(Workspace* workspace) {
    const DisplaySettings& settings = workspace->display;
    ShownImageSource::Wanted wanted{workspace->render.snapshot(),
                                    settings.shown,
                                    workspace->convergence.usableReference(),
                                    {settings.exposureStops, settings.toneMap}};
    own.source.show(wanted, nullptr, own.display.get());
    if (settings.split) {
        wanted.snapshot = workspace->render.otherSnapshot();
        other.source.show(wanted, &own.source, other.display.get());
    }
    workspace->displayIsBehind = workspace->focusOverlay.isBehind() || own.source.isBehind() ||
                                 (settings.split && other.source.isBehind());
    own.drawn = workspace->render.snapshot();
    other.drawn = workspace->render.otherSnapshot();
}

bool ImagePanes::areOld(const Workspace& workspace) {
    return workspace.render.snapshot() != own.drawn || workspace.render.otherSnapshot() != other.drawn ||
           workspace.focusOverlay.version() != overlayVersion || workspace.focusOverlay.isBehind() ||
           own.source.isReady() || other.source.isReady();
}

}  // namespace glint
