// Passes of the path tracer with the film, timed: what `glint bench paths` and `glint bench threads` do.
#pragma once

#include <memory>
#include <vector>

#include "engine/render/backend.h"
#include "engine/render/film.h"
#include "engine/render/pass_params.h"
#include "viewer/bench/bench.h"

namespace glint {

class PathPasses {
  public:
    PathPasses(const BenchSubject& subject, int threads);

    /// Of making ready; an error makes passes worthless.
    const Status& status() const { return status_; }
    /// Renders a pass and adds it to the film. Seconds of both.
    double render(uint32_t pass);
    const Film& film() const { return film_; }

  private:
    int threads_;
    std::unique_ptr<Backend> backend_;
    PassParams params_;
    Film film_;
    std::vector<PixelSample> samples_;
    Status status_;
};

}  // namespace glint
