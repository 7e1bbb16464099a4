// What a texture shows, place by place: for exporters that write it as another picture. Kernels have their
// own (kernels/texture.h), and show the same but for mip maps.
#pragma once

#include <memory>

#include "engine/scene/scene.h"

namespace glint {

class TextureLookup {
  public:
    /// The image must have been read; mip maps count as bilinear.
    explicit TextureLookup(const Texture& texture);

    bool isEmpty() const { return !pixels_ || pixels_->rgb.empty(); }
    int width() const { return pixels_->width; }
    int height() const { return pixels_->height; }
    /// The linear colour at uv; v runs upwards.
    Vec3 at(const Vec2& uv) const;

  private:
    Vec3 texel(int x, int y) const;

    Texture texture_;
    std::shared_ptr<const ImageF> pixels_;  ///< linear, but for what base, gain and exponent change
    Vec2 turn_;                             ///< cosine and sine
};

}  // namespace glint
