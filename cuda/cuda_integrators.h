// The integrators that have kernels on a CUDA device, a line each; each is defined in its own
// file, cuda_<name>.cpp.
#pragma once

#include <memory>

#include "engine/render/integrator.h"

namespace glint {

struct CudaContext;

// clang-format off
#define GLINT_CUDA_INTEGRATORS(X) \
    X(PathTracing) \
    X(Sppm) \
    X(AmbientOcclusion) \
    X(RayCast)
// clang-format on

/// makeCudaPathTracing() and so on; `cuda` outlives them.
#define GLINT_DECLARE_MAKER(kind) std::unique_ptr<Integrator> makeCuda##kind(CudaContext& cuda);
GLINT_CUDA_INTEGRATORS(GLINT_DECLARE_MAKER)
#undef GLINT_DECLARE_MAKER

}  // namespace glint
