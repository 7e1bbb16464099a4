// Images that are taken from files, or made, while a scene is edited. They are read by AssetReader, as the
// edit uses them.
#pragma once

#include <cstddef>
#include <string>

#include "viewer/model/scene_document.h"

namespace glint {

/// Puts the image file on one of a material's inputs: `input` counts them as inputTextures() does.
/// Colours are taken for sRGB, numbers and normals for linear. A texture of the scene that is of that
/// file is used again.
void chooseTextureFile(SceneDocument* document, size_t material, size_t input, const std::string& path);

/// The image file is what a light shows, or by which it shines, in sRGB.
void chooseImageFile(SceneDocument* document, size_t light, const std::string& path);

/// The environment shows the image file, at its own brightness where the environment was black.
void chooseEnvironmentFile(SceneDocument* document, const std::string& path);
/// The same of a generated sky, or of the one that the scene has already.
void chooseSky(SceneDocument* document);

}  // namespace glint
