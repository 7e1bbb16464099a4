// Renders a description pass by pass, by either integrator, and keeps what the error estimate needs: for
// tests that compare the estimate with the error itself.
#pragma once

#include <memory>
#include <vector>

#include "engine/builders/power_distribution.h"
#include "engine/render/backend.h"
#include "engine/render/cpu_sppm.h"
#include "engine/render/film.h"
#include "engine/render/sppm_state.h"
#include "engine/scene/scene.h"

namespace glint::test {

class ErrorTrial {
  public:
    /// A film by the description's own integrator and settings, but for the seed. threads 0: all.
    ErrorTrial(std::shared_ptr<const BuiltScene> built, const SceneDescription& scene, uint32_t seed,
               int threads = 0);

    void renderTo(uint32_t passes);

    const Film& film() const { return film_; }
    /// Null for path tracing.
    const SppmState* sppm() const { return isSppm_ ? &sppm_ : nullptr; }
    /// Of the picture so far.
    std::vector<double> luminances() const;

  private:
    std::shared_ptr<const BuiltScene> built_;
    bool isSppm_;
    int threads_;
    SppmParams params_;
    std::unique_ptr<Backend> backend_;
    Film film_;
    SppmState sppm_;
    std::vector<PixelSample> samples_;
};

}  // namespace glint::test
