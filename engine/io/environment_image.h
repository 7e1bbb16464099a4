// Makes an environment's image of a picture: linear, as a latitude-longitude map, with values that light
// can have.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/scene/image.h"

namespace glint {

/// A picture six times as high as wide is a cube map as OpenEXR lays them out, and becomes a map of the same
/// resolution at the equator; so do strips and crosses (cube_map.h). A warning where the picture is neither
/// of these nor twice as wide as high. Values below 0 and those that are not numbers become 0, infinite ones
/// and those above 1e12 the largest other one, at least 65504; a warning says how many and where they are.
/// Warnings are appended to `warnings`; `name` is the file's. 8-bit pictures stay so, unless they are cube
/// maps. The result has no source.
SceneImage environmentImage(const SceneImage& image, const std::string& name,
                            std::vector<std::string>* warnings);

}  // namespace glint
