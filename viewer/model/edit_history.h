// The states of the document, and of how it is shown, that undo and redo go between.
//
// Scenes share meshes, images and what their lists have in common (kept_scene.h), so that a state costs
// little. Knows nothing of rendering.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "engine/render/film_snapshot.h"
#include "viewer/model/display_settings.h"
#include "viewer/model/kept_scene.h"
#include "viewer/model/scene_document.h"

namespace glint {

class EditHistory {
  public:
    struct State {
        std::string name;  ///< of the edit that led here, for people
        SceneDocument::Version version;
        FilmTake take = 0;  ///< of its films
        DisplayChoices display{};
    };

    /// An edit has led to this state; those that were undone are forgotten, and so is the oldest of too many.
    /// Edits of one `gesture` are one step, and none where it ends as it began; 0: this one is for itself.
    void record(State state, uint64_t gesture);

    /// The exposure of a scene that was just opened has been found: no edit, but as if it had begun so.
    void noteExposure(const SceneDocument::Opened* opened, float stops);

    /// Oldest first; at least one once a scene is open.
    size_t size() const { return states_.size(); }
    const std::string& name(size_t index) const { return states_[index].name; }
    /// Costs a copy of the scene where nobody else has it any more.
    State state(size_t index) const;
    /// Which of them is shown.
    size_t present() const { return present_; }
    const DisplayChoices& display() const { return states_[present_].display; }
    bool canUndo() const { return present_ > 0; }
    bool canRedo() const { return present_ + 1 < states_.size(); }
    State goTo(size_t index);

    /// To be gone to as the edit of this frame; nothing where there is no such state.
    void ask(size_t index);
    void askUndo() { ask(present_ - 1); }
    void askRedo() { ask(present_ + 1); }
    std::optional<size_t> takeAsked() { return std::exchange(asked_, std::nullopt); }

    /// Another one than any state has.
    FilmTake nextTake() { return ++lastTake_; }
    FilmTake take() const { return states_.empty() ? 0 : states_[present_].take; }

    /// How many items of lists all records so far have copied: what the history weighs.
    uint64_t itemsCopied() const { return itemsCopied_; }

    static constexpr size_t kMostStates = 2000;

  private:
    struct Kept {
        std::string name;
        KeptScene scene;
        std::shared_ptr<SceneDocument::Opened> opened;
        FilmTake take = 0;
        DisplayChoices display;
    };
    void keep(State state);

    std::deque<Kept> states_;
    size_t present_ = 0;
    std::shared_ptr<const SceneDescription> shown_;   ///< of the present state
    std::shared_ptr<const SceneDescription> before_;  ///< of the one before the step of gesture_
    uint64_t itemsCopied_ = 0;
    FilmTake lastTake_ = 0;
    std::optional<size_t> asked_;
    uint64_t gesture_ = 0;  ///< that led to the present state; 0: none, or it was undone or redone
};

}  // namespace glint
