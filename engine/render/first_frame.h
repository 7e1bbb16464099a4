// What there is to be seen of a heavy scene while it is built: its triangles in the colours of their
// materials, lit from the camera as ray casting lights scenes without lamps. They are drawn one by one into a
// buffer of depths, since rays would have to wait for a structure: one that halves boxes takes half to four
// fifths of the whole build.
#pragma once

#include <cstddef>
#include <memory>

#include "engine/builders/built_scene.h"
#include "engine/render/film_snapshot.h"
#include "engine/scene/scene.h"

namespace glint {

/// A preview of some ten thousand pixels; the ticket is the caller's. Seen from a pinhole where the camera
/// has a lens. Left out: textures, cut-outs, shadows, and objects that refer to nothing. The same for any
/// number of threads (0: all). Null: the scene cannot be built, or instances make it too much to draw one by
/// one.
std::shared_ptr<FilmSnapshot> drawFirstFrame(const SceneDescription& scene, int threads);

/// Triangles of the meshes that objects place and that `previous` (null: nothing) has no structure for.
size_t trianglesToBuild(const SceneDescription& scene, const BuiltScene* previous);

}  // namespace glint
