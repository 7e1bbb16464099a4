// A camera and light for files that hold only shapes: OBJ and PLY opened directly.
#pragma once

#include "engine/scene/scene.h"

namespace glint {

/// Frames all finite objects in a three-quarter view from the front right and above, puts the focal
/// distance on their centre with a pinhole, sets 800 x 600 pixels, and adds a studio (studio.h), or with
/// `noStudio` a white environment, unless the scene has a light of any kind that is more than a faint or
/// small screen. Objects without materials get one default material. Does nothing to a scene without
/// objects but the resolution.
void applyDefaultView(SceneDescription* scene, bool noStudio);

/// Adds the studio, with a note, or the white environment.
void lightModel(SceneDescription* scene, bool noStudio);

}  // namespace glint
