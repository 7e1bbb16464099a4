// Gathers the variants that the sppm_launch_<mask>.cu files define.

#include <array>

#include "cuda/sppm_variant.h"

namespace glint {

extern const CudaSppmVariant kCudaSppmSmoothShapes;
extern const CudaSppmVariant kCudaSppmFull;

std::span<const CudaSppmVariant> cudaSppmVariants() {
    static const std::array kVariants = {kCudaSppmSmoothShapes, kCudaSppmFull};
    return kVariants;
}

}  // namespace glint
