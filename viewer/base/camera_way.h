// The way of a camera through numbered pictures, and what stands in it: for `glint render --turntable` and
// `--flight`, and for the window.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/builders/built_scene.h"
#include "engine/scene/scene.h"

namespace glint {

class CameraWay {
  public:
    /// A whole turn around the camera's target.
    static CameraWay turntable(const Camera& camera, uint32_t images) { return {{camera}, images}; }
    /// From the first view to the last, of which there are two at least.
    static CameraWay flight(std::vector<Camera> views, uint32_t images) { return {std::move(views), images}; }

    uint32_t images() const { return images_; }
    bool isTurntable() const { return views_.size() == 1; }
    /// Of a picture, counted from 0; between whole numbers on the way to the next one.
    Camera at(float image) const;

  private:
    CameraWay(std::vector<Camera> views, uint32_t images) : views_(std::move(views)), images_(images) {}

    std::vector<Camera> views_;
    uint32_t images_;
};

/// What people should know before the pictures are rendered: the camera goes through a surface, or something
/// large hides the target of a turn. Of each the first, once: a sentence without its stop. "": nothing stands
/// in the way.
std::string obstaclesOn(const CameraWay& way, const SceneDescription& scene, const BuiltScene& built);

}  // namespace glint
