// The path kernels for the GPU, compiled for one mask (named_masks.h). Nothing else belongs here.
#include "cuda/path_launch.cuh"

namespace glint {

extern const CudaVariant kCudaDiffuseShapes;
const CudaVariant kCudaDiffuseShapes = cuda_kernels::makeVariant<kMaskDiffuseShapes>("diffuse shapes");

}  // namespace glint
