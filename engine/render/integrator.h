// How a back end renders passes by one integrator, and what is known of an integrator without a back end.
#pragma once

#include <atomic>
#include <memory>
#include <span>
#include <vector>

#include "engine/base/result.h"
#include "engine/kernels/pass.h"
#include "engine/render/image_statistics.h"
#include "engine/scene/integrator_kind.h"
#include "engine/scene/scene_edit.h"

namespace glint {

struct CpuContext;

/// Made and owned by a back end, whose present scene it renders. A call per pass, never per ray.
class Integrator {
  public:
    virtual ~Integrator() = default;

    /// Takes the integrator's own settings for the passes that follow.
    virtual void prepare(const SceneDescription& /*scene*/) {}

    /// Renders params.pass into `samples`, one for each pixel, which is resized as needed; and into
    /// `statistics` (null where IntegratorType::makeStatistics() is), which must have the pass's resolution
    /// and params.pass passes. Checks `stop` at least once a tile. False: stopped early; `samples` are to
    /// be thrown away and the statistics have not changed, as after an error. Error: no scene, or not
    /// enough memory.
    virtual Result<bool> renderPass(const PassParams& params, const std::atomic<bool>& stop,
                                    ImageStatistics* statistics, std::vector<PixelSample>* samples) = 0;

    /// Forgets what was made for the scene before.
    virtual void sceneChanged() {}

    /// What passes have made it allocate and it still holds, on the host.
    virtual MemoryUse memory() const { return {}; }
};

/// One for each line of integrator_kind.h's table, in the integrator's own file.
class IntegratorType {
  public:
    virtual ~IntegratorType() = default;

    /// `cpu` outlives it.
    virtual std::unique_ptr<Integrator> makeOnCpu(const CpuContext& cpu) const = 0;
    /// Null where it keeps nothing beside the film.
    virtual std::unique_ptr<ImageStatistics> makeStatistics() const { return nullptr; }
    /// For people: what it is good for, as the end of a sentence about it.
    virtual const char* purpose() const = 0;
    /// Those of its statistics, for displays.
    virtual std::span<const IntegratorMapInfo> maps() const { return {}; }
    /// Its statistics estimate how far off they are on average.
    virtual bool hasBias() const { return false; }
    /// The edits that touch its own settings and no other integrator's: only its film restarts.
    virtual EditKind ownEdits() const { return EditKind::None; }
    /// The variance of its statistics falls like passes^-this.
    virtual double statisticsDecay(const SceneDescription& /*scene*/) const { return 1.0; }
    /// Adds what rendering takes beside the film, before anything is allocated.
    virtual void addPlannedMemory(const SceneDescription& /*scene*/, MemoryUse* /*use*/) const {}
};

/// typeOfPathTracing() and so on.
#define GLINT_DECLARE_TYPE(kind, key, alias, displayName, help) const IntegratorType& typeOf##kind();
GLINT_INTEGRATORS(GLINT_DECLARE_TYPE)
#undef GLINT_DECLARE_TYPE

const IntegratorType& integratorType(IntegratorKind kind);

/// The own edits of all integrators.
EditKind allOwnEdits();

/// Of the kind's type, empty and of this size; null where it keeps none.
std::unique_ptr<ImageStatistics> makeStatistics(IntegratorKind kind, int width, int height);

}  // namespace glint
