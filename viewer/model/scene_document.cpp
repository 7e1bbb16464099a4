#include "viewer/model/scene_document.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/io/used_assets.h"
#include "engine/scene/object_box.h"
#include "engine/scene/scene_diff.h"
#include "viewer/model/camera_controller.h"

namespace glint {

void SceneDocument::adopt(SceneDescription scene, bool isSaved) {
    ++adoptions_;
    draft_ = std::move(scene);
    posted_ = std::make_shared<const SceneDescription>(draft_);
    opened_ =
        std::make_shared<Opened>(Opened{draft_.camera, sceneBounds(draft_), isSaved ? posted_ : nullptr});
    selectedObject = focusObject = selectedTexture = -1;
    selectedMaterial = 0;
    selectedLight = 0;
    // An orbit must not change the focus of a scene whose author focused elsewhere.
    const float distance = targetDistance(draft_.camera);
    focusFollowsTarget = draft_.camera.apertureDiameter <= 0.0f ||
                         std::fabs(distance - draft_.camera.focalDistance) <= 1e-3f * distance;
}

EditKind SceneDocument::show(const Version& version) {
    ++adoptions_;
    const EditKind kinds =
        version.opened == opened_ ? differences(*posted_, *version.scene) : EditKind::Everything;
    draft_ = *version.scene;
    posted_ = version.scene;
    opened_ = version.opened;
    if (static_cast<size_t>(focusObject + 1) > draft_.objects.size()) { focusObject = -1; }
    if (static_cast<size_t>(selectedObject + 1) > draft_.objects.size()) { selectedObject = -1; }
    return kinds;
}

SceneDocument::Unsaved SceneDocument::unsaved() const {
    if (compared_ == posted_ && comparedWith_ == opened_->saved) { return unsaved_; }
    compared_ = posted_;
    comparedWith_ = opened_->saved;
    unsaved_ = Unsaved::Nothing;
    if (posted_ == comparedWith_) { return unsaved_; }
    if (!comparedWith_ || !sameUnseen(*comparedWith_, *posted_)) { return unsaved_ = Unsaved::Edits; }
    for (const SceneDifference& each : listDifferences(*comparedWith_, *posted_)) {
        const bool follows = (focusFollowsTarget || focusObject >= 0) && each.key == "focalDistance";
        const bool isView =
            each.part == "camera" && (each.key == "position" || each.key == "target" || follows);
        unsaved_ = std::max(unsaved_, isView ? Unsaved::View : Unsaved::Edits);
    }
    return unsaved_;
}

void SceneDocument::resetCamera() {
    draft_.camera = opened_->camera;
    nameEdit("Reset camera");
}

void SceneDocument::frame(const Bounds& bounds, const std::string& name) {
    const Resolution& size = draft_.resolution;
    frameBounds(&draft_.camera, bounds, static_cast<float>(size.width) / static_cast<float>(size.height));
    nameEdit("Frame " + name);
}

void SceneDocument::frameScene() { frame(opened_->bounds, "the scene"); }

void SceneDocument::frameSelection() {
    const auto index = static_cast<size_t>(selectedObject);
    if (selectedObject < 0 || index >= draft_.objects.size()) { return; }
    SceneDescription alone;
    alone.objects = {draft_.objects[index]};
    alone.meshes = draft_.meshes;
    const std::string& name = draft_.objects[index].name;
    frame(sceneBounds(alone), name.empty() ? "an object" : name);
}

void SceneDocument::focusAt(float distance, const std::string& what) {
    draft_.camera.focalDistance = distance;
    focusFollowsTarget = false;
    focusObject = -1;
    nameEdit("Focus on " + what);
}

void SceneDocument::focusOnSelection() {
    const auto index = static_cast<size_t>(selectedObject);
    if (selectedObject < 0 || index >= draft_.objects.size()) { return; }
    focusObject = selectedObject;
    focusFollowsTarget = false;
    const Object& object = draft_.objects[index];
    const auto mesh = static_cast<size_t>(object.mesh);
    const bool hasMesh = object.mesh >= 0 && mesh < draft_.meshes.size() && draft_.meshes[mesh].data;
    focusPoint_ = hasMesh ? Vec3(meshBox(*draft_.meshes[mesh].data).center()) : Vec3(0.0f);
    nameEdit("Focus on " + (object.name.empty() ? std::string("an object") : object.name));
}

void SceneDocument::followFocus() {
    const auto index = static_cast<size_t>(focusObject);
    if (focusObject >= 0 && index < draft_.objects.size()) {
        const Camera& camera = draft_.camera;
        const Vec3 middle = draft_.objects[index].objectToWorld.point(focusPoint_);
        const Vec3 view = camera.target - camera.position;
        const float depth = isZero(view) ? 0.0f : glm::dot(middle - camera.position, glm::normalize(view));
        if (depth > 0.0f) { draft_.camera.focalDistance = depth; }
        return;
    }
    const bool hasMoved =
        draft_.camera.position != posted_->camera.position || draft_.camera.target != posted_->camera.target;
    const float distance = targetDistance(draft_.camera);
    // An orbit keeps it but for rounding.
    const bool differs = std::fabs(distance - draft_.camera.focalDistance) > 1e-6f * distance;
    if (focusFollowsTarget && hasMoved && differs) { draft_.camera.focalDistance = distance; }
}

SceneDocument::Edits SceneDocument::takeEdits() {
    followFocus();
    ++comparisons_;
    const EditKind kinds = differences(*posted_, draft_);
    if (kinds == EditKind::None) {
        const bool isUnseen = !sameUnseen(*posted_, draft_);
        if (isUnseen) { posted_ = std::make_shared<const SceneDescription>(draft_); }
        return {.isUnseen = isUnseen};
    }
    if (lackingAssets(draft_).empty()) {
        posted_ = std::make_shared<const SceneDescription>(draft_);
        return {kinds};
    }
    auto ready = std::make_shared<const SceneDescription>(withoutLacking(draft_, *posted_));
    const EditKind readyKinds = differences(*posted_, *ready);
    if (readyKinds != EditKind::None) { posted_ = std::move(ready); }
    return {.kinds = readyKinds, .lacksAssets = true};
}

}  // namespace glint
