// What the caller of loadScene allows. Options of `glint` commands end here.
#pragma once

namespace glint {

struct LoadOptions {
    /// Missing textures and meshes, and what Glint cannot draw, become warnings: the rest of the scene is
    /// loaded.
    bool allowMissing = false;
};

}  // namespace glint
