// The scene as kernels see it: one plain struct, passed by value, the same on host and device.
#pragma once

#include "engine/kernels/geometry_view.h"
#include "engine/kernels/light_view.h"
#include "engine/kernels/shading_view.h"

namespace glint {

struct SceneView {
    GeometryView geometry;
    View<MaterialData> materials;
    View<TextureView> textures;
    View<CoatRow> coats;             ///< of plastics whose roughness or index is a texture (bsdf/plastic.h)
    View<SpectrumStratum> spectrum;  ///< empty where nothing disperses light (spectrum.h)
    LightView lights;
    CameraData camera;
    Vec3 sceneCenter{0.0f};
    float sceneRadius = 1.0f;  ///< bounds all finite geometry and the camera; > 0
};

}  // namespace glint
