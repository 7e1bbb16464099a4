// What is in focus, as colours over the picture: from geometry seen through the lens's centre, without noise.
//
// Depths are traced by a job when the view or the geometry changes; the colours follow the lens at once.
// Lives on the UI thread; nothing here draws.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/builders/built_scene.h"
#include "engine/scene/scene.h"
#include "viewer/base/job_queue.h"

namespace glint {

enum class FocusOverlayKind : uint8_t {
    None,
    Sharp,  ///< what is within the limits, and a line where the plane in focus cuts the scene
    Blur,   ///< circles of confusion: blue in front of the focus, orange behind
};

/// 4 bytes a pixel, row 0 at the top; alpha says how much of it covers the picture. One depth a pixel, 0
/// where nothing is hit. `sharpPixels`: the circle of confusion that counts as sharp; circles are measured in
/// pixels of a picture of `imageHeight` rows, whatever the number of depths.
std::vector<uint8_t> focusColors(const std::vector<float>& depths, int width, const Camera& camera,
                                 FocusOverlayKind kind, float sharpPixels, int imageHeight);

class FocusOverlay {
  public:
    FocusOverlay();
    ~FocusOverlay();
    FocusOverlay(const FocusOverlay&) = delete;
    FocusOverlay& operator=(const FocusOverlay&) = delete;

    struct Wanted {
        FocusOverlayKind kind = FocusOverlayKind::None;
        float sharpPixels = 2.0f;
        Camera camera;
        Resolution resolution;
        bool isMoving = false;  ///< coarse is good enough
    };
    /// Once a frame. `scene` may be null.
    void refresh(const Wanted& wanted, const std::shared_ptr<const BuiltScene>& scene);
    /// The colours are not of the scene and the lens as they are now, or coarse.
    bool isBehind() const { return isBehind_; }

    /// Empty where there is no overlay.
    const std::vector<uint8_t>& colors() const { return colors_; }
    int width() const { return shown_ ? shown_->width : 0; }
    int height() const { return shown_ ? shown_->height : 0; }
    /// Another one for other colours.
    uint64_t version() const { return version_; }

  private:
    struct Depths {
        std::shared_ptr<const BuiltScene> scene;
        int scale = 1;  ///< film pixels a depth in each direction
        int width = 0;
        int height = 0;
        std::vector<float> values;
    };
    struct Stop;

    bool isOf(const Depths* depths, const BuiltScene& scene, int scale) const;
    void start(const std::shared_ptr<const BuiltScene>& scene, const Resolution& size, int scale);
    void color(const Wanted& wanted);

    JobQueue jobs_;
    std::shared_ptr<Stop> stop_;
    std::shared_ptr<const Depths> asked_;  ///< without values; null: no job is under way
    std::shared_ptr<const Depths> shown_;
    bool isBehind_ = false;
    std::vector<uint8_t> colors_;
    uint64_t version_ = 0;
    Wanted coloredFor_;
    std::shared_ptr<const Depths> coloredOf_;
};

}  // namespace glint
