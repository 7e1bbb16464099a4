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

const CudaSppmVariant& chooseCudaSppmVariant(FeatureMask needed) {
    const std::span<const CudaSppmVariant> variants = cudaSppmVariants();
    for (const CudaSppmVariant& candidate : variants) {
        if ((needed & ~candidate.mask) == 0) { return candidate; }
    }
    return variants.back();
}

}  // namespace glint
