#include "engine/builders/coat_rows.h"

#include "engine/builders/coat_albedo.h"
#include "engine/kernels/bsdf/plastic.h"
#include "engine/scene/material.h"

namespace glint {

void setCoat(const MaterialData* before, const std::vector<CoatRow>* rowsBefore, MaterialData* data,
             std::vector<CoatRow>* rows) {
    const CoatTableLayout layout = CoatTableLayout::of(*data);
    const CoatTableLayout layoutBefore = before != nullptr ? CoatTableLayout::of(*before) : layout;
    const bool isKnown = before != nullptr && hasCoatTable(before->kind) &&
                         layoutBefore.alphas == layout.alphas && layoutBefore.iors == layout.iors &&
                         before->inputs.ior == data->inputs.ior &&
                         before->distribution == data->distribution &&
                         ((before->flags ^ data->flags) & kMaterialFacets) == 0 &&
                         before->inputs.roughness == data->inputs.roughness &&
                         before->inputs.crossRoughness == data->inputs.crossRoughness;
    const bool hasGeneralFacets = detail::hasGeneralFacets<kAllFeatures>(*data);
    if (layout.rows() == 1) {
        if (isKnown) {
            data->inputs.coat = before->inputs.coat;
            data->inputs.crossCoat = before->inputs.crossCoat;
        } else if (hasGeneralFacets) {
            tabulateCrossedCoat(data->distribution, &data->inputs);
        } else {
            data->inputs.coat = tabulateCoat(data->inputs.ior, data->inputs.roughness);
        }
        return;
    }
    data->coatTable = static_cast<uint32_t>(rows->size());
    if (isKnown) {
        const auto first = rowsBefore->begin() + before->coatTable;
        rows->insert(rows->end(), first, first + layout.rows());
        return;
    }
    for (int i = 0; i < layout.rows(); ++i) {
        const float ior = layout.iors > 1 ? layout.ior(i / layout.alphas) : data->inputs.ior;
        const float alpha = layout.alphas > 1 ? layout.alpha(i % layout.alphas) : data->inputs.roughness;
        const bool isSmooth = alpha < kSmoothAlpha;
        rows->push_back(hasGeneralFacets && !isSmooth
                            ? tabulateCoat(ior, GeneralFacets{alpha, alpha, data->distribution}, false)
                            : tabulateCoat(ior, alpha));
    }
}

}  // namespace glint
