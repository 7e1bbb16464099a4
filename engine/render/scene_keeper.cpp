#include "engine/render/scene_keeper.h"

#include "engine/base/log.h"

namespace glint {
namespace {

void count(const BuildReport& report, SessionCounters* counters) {
    counters->meshBuilds += static_cast<uint64_t>(report.meshesBuilt);
    counters->topLevelBuilds += report.topLevelBuilt;
    counters->materialTables += report.materialsBuilt;
    counters->textureTables += report.texturesBuilt;
    counters->lightTables += report.lightsBuilt;
    counters->featureScans += report.featuresScanned;
}

/// What the built scene alone says: where it stays the same, these edits change no image.
constexpr EditKind kOfBuiltScene = EditKind::Camera | EditKind::MaterialParameters | EditKind::MaterialKind |
                                   EditKind::Lights | EditKind::ObjectTransform;

/// Nothing of the built scene depends on them.
bool needsNoBuild(EditKind kinds) { return (kinds & (allOwnEdits() | EditKind::Integrator)) == kinds; }

}  // namespace

SceneKeeper::Outcome SceneKeeper::take(SceneEdit* edit, SessionStatus* status) {
    edit->kinds |= refusedKinds_;
    if (!built_) { edit->kinds |= EditKind::Everything; }
    const Status built = needsNoBuild(edit->kinds) ? Status() : rebuild(edit, status);
    if (built) {
        refusedKinds_ = EditKind::None;
        status->error.clear();
        return Outcome::Taken;
    }
    refusedKinds_ |= edit->kinds;
    if (queue_->abandonBuild()) { return Outcome::Abandoned; }
    ++status->counters.editsRefused;
    status->refusedTicket = status->ticket;
    status->error = built.error().format();
    logError("{}", status->error);
    return Outcome::Refused;
}

Status SceneKeeper::rebuild(SceneEdit* edit, SessionStatus* status) {
    const auto began = SessionClock::now();
    BuildReport report;
    auto result = build_(*edit, built_.get(), threads_, &queue_->abandonBuild(), &report);
    count(report, &status->counters);
    if (!result) { return result.error(); }
    if (built_ && (*result)->looksLike(*built_)) { edit->kinds = without(edit->kinds, kOfBuiltScene); }
    if (Status taken = backend_->setScene(*result); !taken) { return taken; }
    built_ = std::move(result).value();
    memory_ = memoryOf(*built_);
    status->kernel = backend_->kernelName(edit->scene->options.sampler);
    status->lastBuildSeconds = secondsSince(began);
    return {};
}

}  // namespace glint
