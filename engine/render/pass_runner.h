// Runs a pass and adds it to the picture that it is for.
#pragma once

#include <vector>

#include "engine/render/command_queue.h"
#include "engine/render/pass_schedule.h"
#include "engine/render/published_state.h"

namespace glint {

class PassRunner {
  public:
    /// threads: for adding passes to films; 0: all.
    PassRunner(Backend* backend, CommandQueue* queue, PublishedState* published, int threads)
        : backend_(backend), queue_(queue), published_(published), threads_(threads) {}

    /// `mustBeShown`: as PassInFlight. False: stopped early, and nothing has changed. Counts passes
    /// and allocations.
    Result<bool> run(const NextPass& pass, bool mustBeShown, SessionImages* images,
                     SessionCounters* counters);

    void publishCurve(const IntegratorState& state) const;
    /// Adds what a pass takes before it is added to its picture.
    void addMemory(MemoryUse* use) const;

  private:
    PassInFlight inFlight(const NextPass& pass, bool mustBeShown, const SessionImages& images) const;
    Result<bool> render(const NextPass& pass, SessionImages* images);
    void commit(const NextPass& pass, double seconds, SessionImages* images, SessionCounters* counters);
    void commitFilm(IntegratorState* state, double seconds, const SceneDescription& scene,
                    SessionCounters* counters);

    Backend* backend_;
    CommandQueue* queue_;
    PublishedState* published_;
    int threads_;
    std::vector<PixelSample> samples_;
    std::vector<AovSample> aovSamples_;
};

}  // namespace glint
