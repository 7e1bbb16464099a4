// Which of the compiled kernels runs: the first in a table that does all that the scene and its options need.
//
// Tables go from the smallest mask (kernels/named_masks.h) to the full one.
#pragma once

#include <span>

#include "engine/base/kinds.h"
#include "engine/kernels/features.h"

namespace glint {

/// What a kernel must do for a scene of these features (BuiltScene::features) rendered with this sampler.
inline FeatureMask neededFeatures(FeatureMask scene, SamplerKind sampler) {
    return sampler == SamplerKind::Independent ? scene | kFeatureIndependentSampler : scene;
}

/// `variants` is not empty, and its last one does everything.
template <class Variant>
const Variant& chooseVariant(std::span<const Variant> variants, FeatureMask scene, SamplerKind sampler) {
    const FeatureMask needed = neededFeatures(scene, sampler);
    for (const Variant& candidate : variants) {
        if ((needed & ~candidate.mask) == 0) { return candidate; }
    }
    return variants.back();
}

}  // namespace glint
