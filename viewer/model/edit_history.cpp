#include "viewer/model/edit_history.h"

#include <utility>

#include "engine/scene/scene_diff.h"
#include "viewer/model/edit_name.h"

namespace glint {

void EditHistory::keep(State state) {
    KeptScene scene(state.version.scene, states_.empty() ? nullptr : &states_.back().scene);
    itemsCopied_ += scene.itemsCopied();
    shown_ = state.version.scene;
    states_.push_back({std::move(state.name), std::move(scene), std::move(state.version.opened), state.take,
                       state.display});
    if (states_.size() > kMostStates) { states_.pop_front(); }
    present_ = states_.size() - 1;
}

void EditHistory::record(State state, uint64_t gesture) {
    while (states_.size() > present_ + 1) {
        states_.pop_back();
    }
    const bool joins = gesture != 0 && gesture == gesture_;
    gesture_ = gesture;
    if (!joins) {
        before_ = shown_;
        return keep(std::move(state));
    }
    const DisplayChoices& displayBefore = states_[present_ - 1].display;
    const bool keepsScene = differences(*before_, *state.version.scene) == EditKind::None;
    if (keepsScene && displayBefore == state.display) {
        states_.pop_back();
        --present_;
        gesture_ = 0;
        shown_ = before_;
        return;
    }
    state.name =
        keepsScene ? editName(displayBefore, state.display) : editName(*before_, *state.version.scene);
    states_.pop_back();
    keep(std::move(state));
}

void EditHistory::noteExposure(const SceneDocument::Opened* opened, float stops) {
    for (Kept& state : states_) {
        if (state.opened.get() != opened || state.display.exposureStops != 0.0f ||
            state.display.chosenExposureStops != 0.0f) {
            continue;
        }
        state.display.exposureStops = state.display.chosenExposureStops = stops;
    }
}

void EditHistory::ask(size_t index) {
    if (index < states_.size() && index != present_) { asked_ = index; }
}

EditHistory::State EditHistory::state(size_t index) const {
    const Kept& kept = states_[index];
    return {kept.name, {kept.scene.scene(), kept.opened}, kept.take, kept.display};
}

EditHistory::State EditHistory::goTo(size_t index) {
    present_ = index;
    gesture_ = 0;
    State gone = state(index);
    shown_ = gone.version.scene;
    return gone;
}

}  // namespace glint
