#include "viewer/bench/bench_path_passes.h"

#include <atomic>

#include "engine/render/path_pass.h"
#include "viewer/bench/bench_statistics.h"

namespace glint {

PathPasses::PathPasses(const BenchSubject& subject, int threads)
    : threads_(threads),
      backend_(makeCpuBackend(threads)),
      params_(passParamsOf(*subject.scene)),
      film_(params_.width, params_.height),
      status_(backend_->setScene(subject.built)) {}

double PathPasses::render(uint32_t pass) {
    static const std::atomic<bool> kNever{false};
    params_.pass = pass;
    const Stopwatch stopwatch;
    (void)renderPathPass(*backend_, params_, kNever, &samples_);
    film_.commit(samples_, pass, threads_);
    return stopwatch.seconds();
}

}  // namespace glint
