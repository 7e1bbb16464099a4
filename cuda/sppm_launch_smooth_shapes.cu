// The SPPM kernels for the GPU, compiled for one mask (named_masks.h). Nothing else belongs here.
#include "cuda/sppm_launch.cuh"

namespace glint {

extern const CudaSppmVariant kCudaSppmSmoothShapes;
const CudaSppmVariant kCudaSppmSmoothShapes =
    cuda_kernels::makeSppmVariant<kMaskSmoothShapes>("smooth shapes");

}  // namespace glint
