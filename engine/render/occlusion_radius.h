// How far ambient occlusion looks, on all back ends.
#pragma once

#include "engine/builders/built_scene.h"
#include "engine/builders/instance_builder.h"

namespace glint {

/// A tenth of the diagonal of the box around what has an end. World units; infinite for a scene without
/// finite objects.
inline float occlusionRadiusOf(const BuiltScene& scene) {
    constexpr float kRadiusShare = 0.1f;
    const float diagonal = glm::length(scene.instances->bounds.extent());
    return diagonal > 0.0f ? kRadiusShare * diagonal : kInfinity;
}

}  // namespace glint
