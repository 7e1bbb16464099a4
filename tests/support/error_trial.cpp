#include "tests/support/error_trial.h"

#include <stdexcept>

#include "engine/math/color.h"
#include "engine/render/noise_calibration.h"
#include "engine/render/pass_params.h"
#include "engine/render/path_pass.h"
#include "engine/render/sppm_integrator.h"

namespace glint::test {

ErrorTrial::ErrorTrial(std::shared_ptr<const BuiltScene> built, const SceneDescription& scene, uint32_t seed,
                       int threads)
    : built_(std::move(built)),
      isSppm_(scene.options.integrator == IntegratorKind::Sppm),
      threads_(threads),
      params_(sppmParamsOf(scene)),
      backend_(makeCpuBackend(threads)),
      film_(scene.resolution.width, scene.resolution.height) {
    params_.pass = passParamsOf(scene);
    params_.pass.seed = seed;
    if (isSppm_) { sppm_ = SppmState(scene.resolution.width, scene.resolution.height); }
    if (!backend_->setScene(built_)) { throw std::runtime_error("the back end did not take the scene"); }
}

void ErrorTrial::renderTo(uint32_t passes) {
    const std::atomic<bool> stop{false};
    for (uint32_t pass = film_.passes(); pass < passes; ++pass) {
        params_.pass.pass = pass;
        const Result<bool> done = isSppm_ ? renderSppmPass(*backend_, params_, stop, &sppm_, &samples_)
                                          : renderPathPass(*backend_, params_.pass, stop, &samples_);
        if (!done || !*done) { throw std::runtime_error("a pass failed"); }
        film_.commit(samples_, pass, threads_);
        calibrateNoise(sppm(), params_.alpha, threads_, &film_);
    }
}

std::vector<double> ErrorTrial::luminances() const {
    std::vector<double> out;
    for (size_t i = 0; i < film_.pixels().size(); ++i) {
        const FilmPixel& pixel = film_.pixels()[i];
        out.push_back(0.2126 * pixel.mean[0] + 0.7152 * pixel.mean[1] + 0.0722 * pixel.mean[2] +
                      (isSppm_ ? static_cast<double>(luminance(sppm_.radianceOf(i))) : 0.0));
    }
    return out;
}

}  // namespace glint::test
