// The scene that is open: the draft that the panels change, and the version that is rendered.
//
// Panels know nothing of restarts: once a frame takeEdits() finds the smallest edit between the two. Lives on
// the UI thread.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

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
    /// Of the scene as it was opened; empty where nothing in it is finite.
    const Bounds& bounds() const { return opened_->bounds; }

    /// What stays of a scene from its opening on.
    struct Opened {
        Camera camera;
        Bounds bounds;
        /// As it is in a file; null: it is in none.
        std::shared_ptr<const SceneDescription> saved;
    };
    /// All that undo has to bring back.
    struct Version {
        std::shared_ptr<const SceneDescription> scene;
        std::shared_ptr<Opened> opened;

        bool operator==(const Version&) const = default;
    };
    Version version() const { return {posted_, opened_}; }

    /// Takes another scene, or the same one anew, as draft and as posted version. `isSaved`: it is as its
    /// file says.
    void adopt(SceneDescription scene, bool isSaved = true);
    /// Goes back, or forward again, to a version of before. Returns what that changes.
    EditKind show(const Version& version);

    enum class Unsaved {
        Nothing,
        View,  ///< where the camera stands and looks, alone
        Edits,
    };
    Unsaved unsaved() const;
    bool hasUnsavedEdits() const { return isOpen() && unsaved() == Unsaved::Edits; }
    /// The version is in a file now, under whatever name.
    void noteSaved(const std::shared_ptr<const SceneDescription>& scene) { opened_->saved = scene; }
    /// How often that happened: the name of a scene for what takes long.
    uint64_t adoptions() const { return adoptions_; }

    /// The scene that was just adopted is seen as the one before was.
    void keepCamera(const Camera& camera) {
        draft_.camera = camera;
        takeEdits();
    }

    // Edits of the draft.
    /// The camera as the file has it.
    void resetCamera();
    /// Moves the camera until everything is in the picture.
    void frameScene();
    /// The same for the selected object; nothing without one.
    void frameSelection();
    /// `distance` metres along the view axis; the focus no longer follows the target.
    void focusAt(float distance, const std::string& what);
    /// Keeps the selected object's middle in focus, whatever moves, until something else is focused on.
    void focusOnSelection();

    struct Edits {
        EditKind kinds = EditKind::None;
        /// The draft uses a file that was not read; what needs it is not among the edits.
        bool lacksAssets = false;
        /// No picture shows what changed: names.
        bool isUnseen = false;
    };
    /// What the draft has changed since the last call, now part of posted(). Needs an open scene.
    Edits takeEdits();
    /// For what the draft changes until the next takeEdits(), where the fields that it changes do not say it.
    void nameEdit(std::string name) { editName_ = std::move(name); }
    /// How often takeEdits() has looked through the scene.
    uint64_t comparisons() const { return comparisons_; }
    /// Once after each takeEdits(): "" without a name.
    std::string takeEditName() { return std::exchange(editName_, {}); }

    /// Keeps the focal distance on the target when the camera moves.
    bool focusFollowsTarget = true;
    int focusObject = -1;     ///< whose middle stays in focus; -1: none
    int selectedObject = -1;  ///< -1: none
    int selectedMaterial = 0;
    int selectedLight = 0;
    int selectedTexture = -1;  ///< -1: none
    int selectedProfile = 0;   ///< among the surfaces of revolution
    int selectedProfilePoint = 0;

  private:
    void frame(const Bounds& bounds, const std::string& name);
    void followFocus();

    SceneDescription draft_;
    std::shared_ptr<const SceneDescription> posted_;
    std::shared_ptr<Opened> opened_ = std::make_shared<Opened>();
    Vec3 focusPoint_{0.0f};  ///< of focusObject, in its own space
    uint64_t adoptions_ = 0;
    uint64_t comparisons_ = 0;
    std::string editName_;
    /// The answer of unsaved() is of these.
    mutable std::shared_ptr<const SceneDescription> compared_, comparedWith_;
    mutable Unsaved unsaved_ = Unsaved::Nothing;
};

}  // namespace glint
