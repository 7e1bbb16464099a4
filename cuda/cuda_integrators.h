// The table of integrators on a CUDA device. Each is defined in its own file, cuda_<name>.cpp, so that one
// that is forgotten does not link.
#pragma once

#include <memory>

#include "engine/render/integrator.h"

namespace glint {

struct CudaContext;

/// makeCudaPathTracing() and so on; `cuda` outlives them.
#define GLINT_DECLARE_MAKER(kind, key, alias, displayName) \
    std::unique_ptr<Integrator> makeCuda##kind(CudaContext& cuda);
GLINT_INTEGRATORS(GLINT_DECLARE_MAKER)
#undef GLINT_DECLARE_MAKER

}  // namespace glint
