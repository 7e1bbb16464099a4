// What must hold for every table of compiled kernels.
#pragma once

#include <span>

#include <gtest/gtest.h>

#include "engine/render/variant_choice.h"

namespace glint::test {

/// None is hidden behind an earlier one that does all that it does, and the last one does everything.
template <class Variant>
void expectNoneHidden(std::span<const Variant> variants) {
    for (const Variant& variant : variants) {
        EXPECT_STREQ(chooseVariant(variants, variant.mask, SamplerKind::Sobol).name, variant.name);
    }
    EXPECT_EQ(variants.back().mask, kAllFeatures);
}

/// The same, and each does what the one before it does.
template <class Variant>
void expectGrowing(std::span<const Variant> variants) {
    expectNoneHidden(variants);
    for (size_t i = 1; i < variants.size(); ++i) {
        EXPECT_EQ(variants[i - 1].mask & ~variants[i].mask, 0u) << variants[i].name;
    }
}

}  // namespace glint::test
