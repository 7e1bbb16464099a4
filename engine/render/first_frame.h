// What there is to be seen of a heavy scene while it is built: its triangles in the colours of their
// materials, lit from the camera as ray casting lights scenes without lamps. They are drawn one by one, since
// rays would have to wait for a structure: one that halves boxes, and a frame by it, take three quarters of
// the time of the real one.
#pragma once

#include <atomic>
#include <memory>

#include "engine/render/film_snapshot.h"
#include "engine/scene/scene.h"

namespace glint {

/// A preview of at most 250,000 pixels, as far as its scale goes; the ticket is the caller's. Left out:
/// textures, cut-outs, shadows, lamps, blur of the lens, and pictures of the environment. The same for any
/// number of threads (0: all). Null: the scene is not valid, it is too much to draw one by one (instances,
/// turned profiles, triangles that lie over each other), or `stop` was raised meanwhile.
std::shared_ptr<FilmSnapshot> drawFirstFrame(const SceneDescription& scene, int threads,
                                             const std::atomic<bool>& stop);

}  // namespace glint
