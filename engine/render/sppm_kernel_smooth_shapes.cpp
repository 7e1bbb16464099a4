// SPPM compiled for one mask (sppm_kernel.h). Nothing else belongs here.
#include "engine/render/cpu_kernel.h"
#include "engine/render/sppm_kernel_loops.h"

GLINT_COMPILE_SPPM(glint::kMaskSmoothRevolvedShapes);
