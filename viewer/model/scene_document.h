// The scene that is open: the draft that the panels change, and the version that is rendered.
//
// Panels know nothing of restarts: once a frame takeEdits() finds the smallest edit between the two. Lives on
// the UI thread.
#pragma once

#include <memory>

#include "engine/math/bounds.h"
#include "engine/scene/scene_edit.h"

namespace glint {

class SceneDocument {
  public:
    bool isOpen() const { return posted_ != nullptr; }
    SceneDescription& draft() { return draft_; }
    const SceneDescription& draft() const { return draft_; }
    /// The version that is rendered; null before the first scene. Immutable: an edit replaces it.
    const std::shared_ptr<const SceneDescription>& posted() const { return posted_; }
    const Camera& cameraOfFile() const { return cameraOfFile_; }
    /// Of the scene as it was opened; empty where nothing in it is finite.
    const Bounds& bounds() const { return bounds_; }

    /// Takes another scene, or the same one anew, as draft and as posted version.
    void adopt(SceneDescription scene);
    /// How often that happened: the name of a scene for what takes long.
    uint64_t adoptions() const { return adoptions_; }

    struct Edits {
        EditKind kinds = EditKind::None;
        /// The draft uses a file that was not read; what needs it is not among the edits.
        bool lacksAssets = false;
    };
    /// What the draft has changed since the last call, now part of posted(). Needs an open scene.
    Edits takeEdits();

    /// Keeps the focal distance on the target when the camera moves.
    bool focusFollowsTarget = true;
    int selectedMaterial = 0;
    int selectedLight = 0;

  private:
    void focusOnTarget();

    SceneDescription draft_;
    std::shared_ptr<const SceneDescription> posted_;
    Camera cameraOfFile_;
    Bounds bounds_;
    uint64_t adoptions_ = 0;
};

}  // namespace glint
