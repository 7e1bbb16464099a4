// Images and a room for tests of bumps, normal maps and cut-outs.
#pragma once

#include <functional>
#include <memory>

#include "engine/scene/scene_building.h"

namespace glint::test {

/// Grey by value(column, row); row 0 is the top one.
std::shared_ptr<const ImageF> greyImage(int width, int height, const std::function<float(int, int)>& value);

/// Waves of `count` periods each way, from 0 to 1.
std::shared_ptr<const ImageF> waves(int size, int count);

/// Appends a texture and returns its index.
int addTexture(SceneDescription* scene, std::shared_ptr<const ImageF> image);

/// A floor, a back wall and a lamp in a dim sky; what stands on the floor is for the caller to add. 32 x
/// 32 pixels.
SceneDescription reliefRoom(const Material& floor);

}  // namespace glint::test
