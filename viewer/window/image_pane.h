// An image on the graphics card together with what brings it up to date.
#pragma once

#include <cstdint>
#include <memory>

#include "viewer/model/workspace.h"
#include "viewer/window/image_display.h"
#include "viewer/window/shown_image_source.h"
#include "viewer/window/thumbnail_uploads.h"

namespace glint {

struct ImagePane {
    std::unique_ptr<ImageDisplay> display;
    ShownImageSource source;
    std::shared_ptr<const FilmSnapshot> drawn;  ///< that the last frame had
};

/// The scene's own integrator, and what it is compared with, which matters while something is.
struct ImagePanes {
    ImagePane own;
    ImagePane other;
    std::unique_ptr<ImageDisplay> overlay;  ///< FocusOverlay's colours
    uint64_t overlayVersion = 0;            ///< that it holds
    std::unique_ptr<ImageDisplay> difference;
    std::shared_ptr<const ShownDifference::Made> differenceOf;  ///< that it holds; null: nothing
    ThumbnailUploads thumbnails;

    /// Error: as ImageDisplay::create().
    Status create(const GlApi& gl);
    /// While the context is there.
    void release();

    /// Before a frame's lists are made: the first colours of overlays, differences and thumbnails have to be
    /// in it.
    void takeColors(Workspace* workspace);
    /// Before a frame is drawn: brings up to date what it shows.
    void show(Workspace* workspace);
    /// There is something newer than what the last frame showed.
    bool areOld(const Workspace& workspace);

  private:
    void takeOverlay(const FocusOverlay& focus);
    void takeDifference(const ShownDifference& made);
};

}  // namespace glint
