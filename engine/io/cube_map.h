// Cube maps as Direct3D and OpenGL lay them out. For the readers of DDS files and environments.
#pragma once

#include <vector>

#include "engine/scene/image.h"

namespace glint {

/// Six square faces, in the order of Direct3D (Microsoft, "Cube textures"), one above the other as
/// environment_image.h has them. What is seen from their middle is not mirrored, and their +z is the scene's
/// -z.
SceneImage cubeColumn(const std::vector<SceneImage>& faces);

/// The faces of a picture that is a strip of six (6:1) in that order, or a cross: in the middle row -x +z +x
/// -z (4:3), or -x +z +x, with -z upside down at the bottom (3:4); +y above +z, -y below. Empty: it is none
/// of them; a cross has squares beside its faces, and each of these is of one colour.
std::vector<SceneImage> facesOf(const ImageF& image);

}  // namespace glint
