// The table of SPPM variants, from the smallest mask to the full one.
#include <array>

#include "engine/render/cpu_kernel.h"
#include "engine/render/sppm_kernel.h"

namespace glint {

extern template SppmVariant sppmVariant<kMaskSmoothRevolvedShapes>(const char* name);
extern template SppmVariant sppmVariant<kMaskOneSampler>(const char* name);
extern template SppmVariant sppmVariant<kAllFeatures>(const char* name);

std::span<const SppmVariant> sppmVariants() {
    static const std::array kVariants = {
        sppmVariant<kMaskSmoothRevolvedShapes>("smooth shapes"),
        sppmVariant<kMaskOneSampler>("one sampler"),
        sppmVariant<kAllFeatures>("full"),
    };
    return kVariants;
}

}  // namespace glint
