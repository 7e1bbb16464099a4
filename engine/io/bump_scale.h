// Heights of bump maps that a format gives no unit: slopes then look alike whatever the model's unit and
// however often the image repeats. For readers of OBJ files and of text scenes.
#pragma once

#include "engine/scene/scene.h"

namespace glint {

/// How wide an image of one unit of u and v lies on meshes, on the average of their area.
class ImageWidth {
  public:
    /// Adds a mesh that is `scale` times as large; without texture coordinates it counts for nothing.
    void add(const MeshData& mesh, float scale = 1.0f);
    /// What a height of 1 is in metres for an image that is shown like `texture`.
    float bumpHeight(const Texture& texture) const;

  private:
    double area_ = 0.0, uvArea_ = 0.0;
};

}  // namespace glint
