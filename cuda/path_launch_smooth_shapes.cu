// The path kernels for the GPU, compiled for one mask (named_masks.h). Nothing else belongs here.
#include "cuda/path_launch.cuh"

namespace glint {

extern const CudaVariant kCudaSmoothShapes;
const CudaVariant kCudaSmoothShapes = cuda_kernels::makeVariant<kMaskSmoothShapes>("smooth shapes");

}  // namespace glint
