// Which edit two versions of a scene differ by: the smallest one, after the table in engine/README.md.
//
// The panels change a draft and know nothing of restarts; once a frame the draft is compared with what was
// posted. Undo keeps the versions that this compares.
#pragma once

#include <string_view>
#include <vector>

#include "engine/scene/scene_edit.h"

namespace glint {

/// None when nothing that is rendered differs; what no object refers to in either scene is not rendered.
/// Parts that no panel edits (meshes, images, names) count as another scene.
EditKind differences(const SceneDescription& before, const SceneDescription& after);
/// Whether what no picture shows is the same: names, titles, and what is hidden.
bool sameUnseen(const SceneDescription& before, const SceneDescription& after);

/// One field in which two versions of a scene differ.
struct SceneDifference {
    std::string_view part;  ///< "camera", "materials": keys of scene files, "sppm", "raycast"; "" for what
                            ///< they do not hold
    int item = -1;          ///< in a list of as many items in both: which one; else -1
    std::string_view
        key{};      ///< of the field in the part or the item; "" where the part is no group of fields
    int added = 0;  ///< items that a list has more than before; negative: fewer
};

/// All that differences() looks at, in the order of scene_fields.h, but for what the items' kinds do
/// not have.
std::vector<SceneDifference> listDifferences(const SceneDescription& before, const SceneDescription& after);

}  // namespace glint
