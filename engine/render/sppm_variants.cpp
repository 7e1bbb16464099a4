// The table of SPPM variants, from the smallest mask to the full one.
#include <array>

#include "engine/render/cpu_kernel.h"
#include "engine/render/sppm_kernel.h"

namespace glint {

extern template SppmVariant sppmVariant<kMaskSmoothShapes>(const char* name);
extern template SppmVariant sppmVariant<kMaskNoEnvironmentImage>(const char* name);
extern template SppmVariant sppmVariant<kAllFeatures>(const char* name);

const SppmVariant& chooseSppmVariant(FeatureMask needed) {
    static const std::array kVariants = {
        sppmVariant<kMaskSmoothShapes>("smooth shapes"),
        sppmVariant<kMaskNoEnvironmentImage>("no environment image"),
        sppmVariant<kAllFeatures>("full"),
    };
    for (const SppmVariant& candidate : kVariants) {
        if ((needed & ~candidate.mask) == 0) {
            return candidate;
        }
    }
    return kVariants.back();
}

}  // namespace glint
