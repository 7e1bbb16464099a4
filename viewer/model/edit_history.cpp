#include "viewer/model/edit_history.h"

#include <utility>

#include "engine/scene/scene_diff.h"
#include "viewer/model/edit_name.h"

namespace glint {

void EditHistory::record(State state, uint64_t gesture) {
    if (!states_.empty()) { states_.resize(present_ + 1); }
    const bool joins = gesture != 0 && gesture == gesture_;
    gesture_ = gesture;
    if (!joins) {
        states_.push_back(std::move(state));
        if (states_.size() > kMostStates) { states_.erase(states_.begin()); }
        present_ = states_.size() - 1;
        return;
    }
    const State& before = states_[present_ - 1];
    const bool keepsScene = differences(*before.version.scene, *state.version.scene) == EditKind::None;
    if (keepsScene && before.display == state.display) {
        states_.pop_back();
        --present_;
        gesture_ = 0;
        return;
    }
    state.name = keepsScene ? editName(before.display, state.display)
                            : editName(*before.version.scene, *state.version.scene);
    states_.back() = std::move(state);
}

void EditHistory::noteExposure(const SceneDocument::Opened* opened, float stops) {
    for (State& state : states_) {
        if (state.version.opened.get() != opened || state.display.exposureStops != 0.0f ||
            state.display.chosenExposureStops != 0.0f) {
            continue;
        }
        state.display.exposureStops = state.display.chosenExposureStops = stops;
    }
}

void EditHistory::ask(size_t index) {
    if (index < states_.size() && index != present_) { asked_ = index; }
}

const EditHistory::State& EditHistory::goTo(size_t index) {
    present_ = index;
    gesture_ = 0;
    return states_[present_];
}

}  // namespace glint
