// What an edit changed, and so what has to restart. The table is in engine/README.md.
#pragma once

#include <cstdint>
#include <memory>

#include "engine/scene/scene.h"

namespace glint {

/// Bits; an edit may carry several, and edits that wait are joined by OR.
enum class EditKind : uint32_t {
    None = 0,
    Camera = 1u << 0,              ///< position, lens, field of view: film restarts, nothing is rebuilt
    Resolution = 1u << 1,          ///< film storage
    MaterialParameters = 1u << 2,  ///< material table (and light table where emission changes), film
    MaterialKind = 1u << 3,        ///< kind or texture assignment: also the feature mask
    Lights = 1u << 4,              ///< lights and environment: light table, film
    ObjectTransform = 1u << 5,     ///< instances and top level acceleration structure, light table, film
    Options = 1u << 6,             ///< RenderOptions of the running integrator: film
    SppmParameters = 1u << 7,      ///< radius, alpha, photons per pass: SPPM statistics only
    Everything = 1u << 8,          ///< another scene
    Integrator = 1u << 9,          ///< which film is shown and goes on; nothing restarts
    Accelerator = 1u << 10,        ///< acceleration structures of meshes and the top level, film
    RayCastParameters = 1u << 11,  ///< lights, highlights: the film of ray casting only
};

constexpr EditKind operator|(EditKind a, EditKind b) {
    return static_cast<EditKind>(static_cast<uint32_t>(a) | static_cast<uint32_t>(b));
}
constexpr EditKind operator&(EditKind a, EditKind b) {
    return static_cast<EditKind>(static_cast<uint32_t>(a) & static_cast<uint32_t>(b));
}
constexpr EditKind without(EditKind set, EditKind kinds) {
    return static_cast<EditKind>(static_cast<uint32_t>(set) & ~static_cast<uint32_t>(kinds));
}
constexpr EditKind& operator|=(EditKind& a, EditKind b) { return a = a | b; }
constexpr bool has(EditKind set, EditKind kind) { return (set & kind) != EditKind::None; }

/// The whole scene after an edit, and what differs from the one before.
struct SceneEdit {
    std::shared_ptr<const SceneDescription> scene;
    EditKind kinds = EditKind::None;
};

}  // namespace glint
