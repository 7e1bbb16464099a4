// The SPPM kernels for the GPU, compiled for one mask (named_masks.h). Nothing else belongs here.
#include "cuda/sppm_launch.cuh"

namespace glint {

extern const CudaSppmVariant kCudaSppmFull;
const CudaSppmVariant kCudaSppmFull = cuda_kernels::makeSppmVariant<kAllFeatures>("full");

}  // namespace glint
