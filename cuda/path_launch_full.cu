// The path kernels for the GPU, compiled for one mask (named_masks.h). Nothing else belongs here.
#include "cuda/path_launch.cuh"

namespace glint {

extern const CudaVariant kCudaFull;
const CudaVariant kCudaFull = cuda_kernels::makeVariant<kAllFeatures>("full");

}  // namespace glint
