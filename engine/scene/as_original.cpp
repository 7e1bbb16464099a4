#include "engine/scene/as_original.h"

namespace glint {

void setAsOriginal(SceneDescription* scene) {
    scene->options.maxDepth = 20;
    scene->options.filter = FilterKind::Box;
    scene->options.filterRadius = 1.0f;
    scene->camera.apertureBlades = 4;
    scene->camera.bladeRotationDeg = 45.0f;
}

}  // namespace glint
