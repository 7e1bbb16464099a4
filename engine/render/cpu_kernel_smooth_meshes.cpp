// The path tracer compiled for one mask (cpu_kernel.h). Nothing else belongs here.
#include "engine/render/cpu_kernel_tile.h"

GLINT_COMPILE_KERNELS(glint::kMaskSmoothMeshes);
