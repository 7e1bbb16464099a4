// The scenes that `glint bench` measures on: made in code, so that figures do not depend on files, or a
// file that was asked for.
#pragma once

#include <memory>

#include "engine/base/result.h"
#include "engine/scene/scene.h"

namespace glint {

/// Five walls, a lamp and two diffuse spheres, depth 10.
std::shared_ptr<SceneDescription> benchCornell(int width, int height);

/// The same with a mirror and a glass sphere instead.
std::shared_ptr<SceneDescription> benchGlassAndMirror(int width, int height);

/// A generated mesh of about so many triangles on a floor, under a lamp and a dim sky.
Result<std::shared_ptr<SceneDescription>> benchMesh(uint32_t triangles, int width, int height);

/// A scene file at its own size. Error: it cannot be read.
Result<std::shared_ptr<SceneDescription>> benchFile(const std::string& path);

}  // namespace glint
