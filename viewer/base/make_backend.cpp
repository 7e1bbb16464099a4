// The names of the back ends, and the fall-back from CUDA to the CPU.

#include "viewer/base/make_backend.h"

#include <array>

#include "engine/base/log.h"
#include "engine/base/nearest_name.h"

#if GLINT_HAS_CUDA
#include "cuda/cuda_backend.h"
#endif

namespace glint {
namespace {

constexpr std::array<std::string_view, 2> kBackendNames{"cpu", "cuda"};

Result<std::unique_ptr<Backend>> tryCuda() {
#if GLINT_HAS_CUDA
    return makeCudaBackend();
#else
    return Error{"this build has no CUDA back end (configure it with GLINT_CUDA=AUTO)", {}};
#endif
}

}  // namespace

Result<std::unique_ptr<Backend>> makeBackend(std::string_view name, int threads) {
    if (name == "cuda") {
        Result<std::unique_ptr<Backend>> cuda = tryCuda();
        if (cuda) { return cuda; }
        logWarning("CUDA: {}; rendering on the CPU instead.", cuda.error().message);
        return makeCpuBackend(threads);
    }
    if (name == "cpu") { return makeCpuBackend(threads); }
    return Error{fmt::format("Unknown back end \"{}\"{}: expected cpu or cuda.", name,
                             didYouMean(name, kBackendNames)),
                 {}};
}

}  // namespace glint
