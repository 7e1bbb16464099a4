// Brings a display up to date with the newest snapshot: radiance as it is, other pictures as false colours.
//
// The radiance goes to the graphics card at once. Colours are made here where that is quick, and by a job
// where it would hold up the window: the picture before stays until they are there.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "viewer/base/job_queue.h"
#include "viewer/model/false_colors.h"
#include "viewer/window/image_display.h"

namespace glint {

class ShownImageSource {
  public:
    /// What is to be shown. `snapshot` and `reference` may be null.
    struct Wanted {
        std::shared_ptr<const FilmSnapshot> snapshot;
        ShownImage shown = ShownImage::Radiance;
        std::shared_ptr<const LoadedReference> reference;
        DisplayLook look;
    };

    /// Once a frame; uploads only what is new. A null snapshot leaves the picture as it is. `alongside`:
    /// the source of the picture beside it, whose scale it takes so that the same colours mean the same;
    /// may be null.
    void show(const Wanted& wanted, const ShownImageSource* alongside, ImageDisplay* display);

    /// Colours that a job made wait for the next show(). Call once in a while between frames.
    bool isReady();
    /// What was wanted last is not on the display yet.
    bool isBehind() const { return isBehind_; }

    /// What is on the display, and the scale of its colours.
    ShownImage shownImage() const { return shownImage_; }
    IntegratorKind shownIntegrator() const { return shownIntegrator_; }
    const MapScale& scale() const { return scale_; }

  private:
    struct Colors {
        Wanted of;
        ShownImage image = ShownImage::Radiance;
        MapScale scale;
        std::vector<uint8_t> rgba;  ///< empty: the snapshot does not carry that picture
    };
    static Colors colored(Wanted of, ShownImage image, MapScale scale);
    bool isNew(const Wanted& wanted, ShownImage image, const ShownImageSource* alongside,
               const ImageDisplay& display) const;
    void bringUp(const Wanted& wanted, ShownImage image, const MapScale& scale, ImageDisplay* display);
    void start(const Wanted& wanted, ShownImage image, const MapScale& scale);
    void put(Colors colors, ImageDisplay* display);
    void putRadiance(const Wanted& wanted, ImageDisplay* display);

    JobQueue jobs_;
    bool isColoring_ = false;
    std::optional<Colors> ready_;
    bool isBehind_ = false;
    Wanted shown_;  ///< what is on the display, or stands in for what a snapshot does not carry
    ShownImage shownImage_ = ShownImage::Radiance;
    IntegratorKind shownIntegrator_ = IntegratorKind::PathTracing;
    MapScale scale_;
};

}  // namespace glint
