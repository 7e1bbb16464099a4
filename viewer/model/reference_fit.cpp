#include "viewer/model/reference_fit.h"

#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/base/thread_priority.h"
#include "engine/report/convergence_reference.h"
#include "engine/scene/scene_diff.h"
#include "engine/scene/scene_hash.h"

namespace glint {
namespace {

std::string changed(std::vector<std::string> what) {
    if (what.empty()) { return ""; }
    const bool isPlural = what.size() > 1 || what.back().ends_with('s');
    const std::string last = std::move(what.back());
    what.pop_back();
    return fmt::format("{}{}{} {} changed", fmt::join(what, ", "), what.empty() ? "" : " and ", last,
                       isPlural ? "have" : "has");
}

/// Options that change what the picture converges to; the others change its noise.
void addOptions(const SceneDescription& then, const SceneDescription& now, std::vector<std::string>* what) {
    const RenderOptions& a = then.options;
    const RenderOptions& b = now.options;
    if (!(then.resolution == now.resolution)) { what->emplace_back("the size"); }
    if (a.maxDepth != b.maxDepth) { what->emplace_back("the max depth"); }
    if (a.filter != b.filter || a.filterRadius != b.filterRadius) { what->emplace_back("the filter"); }
}

/// Nothing: only fingerprints can tell, since the two do not share their data.
std::optional<std::string> editsBetween(const SceneDescription& then, const SceneDescription& now) {
    const EditKind kinds = differences(then, now);
    if (has(kinds, EditKind::Everything)) { return std::nullopt; }
    std::vector<std::string> what;
    if (has(kinds, EditKind::Camera)) { what.emplace_back("the camera"); }
    if (has(kinds, EditKind::MaterialParameters | EditKind::MaterialKind)) {
        what.emplace_back("the materials");
    }
    if (has(kinds, EditKind::Lights)) { what.emplace_back("the lights"); }
    if (has(kinds, EditKind::ObjectTransform)) { what.emplace_back("the objects"); }
    addOptions(then, now, &what);
    return changed(std::move(what));
}

std::string hashedDifference(const SceneDescription& then, const SceneDescription& now) {
    const SceneHashes before = hashSceneParts(then);
    const SceneHashes after = hashSceneParts(now);
    std::vector<std::string> what;
    for (size_t i = 0; i < before.parts.size(); ++i) {
        if (!(before.parts[i] == after.parts[i])) {
            what.emplace_back(scenePartName(static_cast<ScenePart>(i)));
        }
    }
    addOptions(then, now, &what);
    return changed(std::move(what));
}

}  // namespace

bool ReferenceFit::namesItsScene() const { return reference_->attributes.contains("sceneHash"); }

void ReferenceFit::answer(const Scene& scene, std::string difference) {
    checked_ = scene;
    difference_ = std::move(difference);
    if (difference_.empty()) { known_ = scene; }
}

void ReferenceFit::startHash() {
    hashing_ = true;
    jobs_.start(
        [this, reference = reference_, scene = scene_, known = known_,
         named = namesItsScene()]() -> JobQueue::Completion {
            lowerThreadPriority();
            std::string difference =
                named ? referenceDifference(reference->attributes, *scene) : hashedDifference(*known, *scene);
            return [this, reference, scene, difference] {
                hashing_ = false;
                if (reference == reference_) { answer(scene, difference); }
            };
        },
        false);
}

void ReferenceFit::check(const std::shared_ptr<const LoadedReference>& reference, const Scene& scene,
                         bool mayHash) {
    if (reference != reference_) {
        reference_ = reference;
        useAnyway = false;
        known_.reset();
        checked_.reset();
        difference_.clear();
    }
    jobs_.runCompletions();
    scene_ = scene;
    if (!reference_ || !scene_ || scene_ == checked_) { return; }
    if (!known_ && !namesItsScene()) { return answer(scene_, ""); }
    if (known_) {
        if (auto edits = editsBetween(*known_, *scene_)) { return answer(scene_, std::move(*edits)); }
    }
    if (mayHash && !hashing_) { startHash(); }
}

}  // namespace glint
