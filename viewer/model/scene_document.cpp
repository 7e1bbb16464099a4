#include "viewer/model/scene_document.h"

#include <cmath>
#include <utility>

#include "engine/io/used_assets.h"
#include "engine/scene/object_box.h"
#include "engine/scene/scene_diff.h"
#include "viewer/model/camera_controller.h"

namespace glint {

void SceneDocument::adopt(SceneDescription scene) {
    ++adoptions_;
    draft_ = std::move(scene);
    posted_ = std::make_shared<const SceneDescription>(draft_);
    cameraOfFile_ = draft_.camera;
    bounds_ = sceneBounds(draft_);
    selectedMaterial = 0;
    selectedLight = 0;
    // An orbit must not change the focus of a scene whose author focused elsewhere.
    const float distance = targetDistance(draft_.camera);
    focusFollowsTarget = draft_.camera.apertureDiameter <= 0.0f ||
                         std::fabs(distance - draft_.camera.focalDistance) <= 1e-3f * distance;
}

void SceneDocument::focusOnTarget() {
    const bool hasMoved =
        draft_.camera.position != posted_->camera.position || draft_.camera.target != posted_->camera.target;
    if (focusFollowsTarget && hasMoved) { draft_.camera.focalDistance = targetDistance(draft_.camera); }
}

SceneDocument::Edits SceneDocument::takeEdits() {
    focusOnTarget();
    const EditKind kinds = differences(*posted_, draft_);
    if (kinds == EditKind::None) { return {}; }
    if (lackingAssets(draft_).empty()) {
        posted_ = std::make_shared<const SceneDescription>(draft_);
        return {kinds, false};
    }
    auto ready = std::make_shared<const SceneDescription>(withoutLacking(draft_, *posted_));
    const EditKind readyKinds = differences(*posted_, *ready);
    if (readyKinds != EditKind::None) { posted_ = std::move(ready); }
    return {readyKinds, true};
}

}  // namespace glint
