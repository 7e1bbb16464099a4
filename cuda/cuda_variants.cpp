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

const CudaVariant& chooseCudaVariant(FeatureMask needed) {
    const std::span<const CudaVariant> variants = cudaVariants();
    for (const CudaVariant& candidate : variants) {
        if ((needed & ~candidate.mask) == 0) { return candidate; }
    }
    return variants.back();
}

}  // namespace glint
