// Light and a ground for models that bring neither: what shows their form.
#pragma once

#include "engine/scene/scene.h"

namespace glint {

/// A large soft key light from above and in front, fill from all around, and a ground under the scene's
/// finite objects that catches the shadow. A white surface that faces +z has about radiance 1, one that faces
/// up 1.3, down and backwards 0.35, as the background has. The ground is the last object, with the last
/// material; the light is the environment.
void addStudio(SceneDescription* scene);

/// Whether the scene has its ground.
bool hasStudio(const SceneDescription& scene);

/// Takes the ground away and leaves a plain white environment.
void removeStudio(SceneDescription* scene);

}  // namespace glint
