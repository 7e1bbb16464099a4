// What ray casting is given of a scene beside its geometry, on all back ends.
#pragma once

#include <vector>

#include "engine/kernels/raycast_kernel.h"
#include "engine/scene/scene.h"

namespace glint {

struct RayCastSettings {
    std::vector<PhongMaterial> materials;  ///< as the scene's
    RayCastOptions options;

    /// Valid as long as the settings.
    RayCastView view() const {
        return {viewOf(materials), options.ambient, options.shadows, options.falloff};
    }
};

inline RayCastSettings rayCastSettingsOf(const SceneDescription& scene) {
    RayCastSettings settings;
    for (const Material& material : scene.materials) {
        settings.materials.push_back({material.phongSpecular, material.phongExponent});
    }
    settings.options = scene.rayCast;
    return settings;
}

}  // namespace glint
