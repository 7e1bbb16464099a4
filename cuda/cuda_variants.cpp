// Gathers the variants that the path_launch_<mask>.cu files define.

#include <array>

#include "cuda/cuda_variant.h"

namespace glint {

extern const CudaVariant kCudaDiffuseShapes;
extern const CudaVariant kCudaSmoothShapes;
extern const CudaVariant kCudaFull;

std::span<const CudaVariant> cudaVariants() {
    static const std::array kVariants = {kCudaDiffuseShapes, kCudaSmoothShapes, kCudaFull};
    return kVariants;
}

}  // namespace glint
