// Which edit two versions of a scene differ by: the smallest one, after the table in engine/README.md.
//
// The panels change a draft and know nothing of restarts; once a frame the draft is compared with what was
// posted. Undo will keep the versions that this compares.
#pragma once

#include "engine/scene/scene_edit.h"

namespace glint {

/// None when nothing that is rendered differs; what no object refers to in either scene is not rendered.
/// Parts that no panel edits (meshes, images, names) count as another scene.
EditKind differences(const SceneDescription& before, const SceneDescription& after);

}  // namespace glint
