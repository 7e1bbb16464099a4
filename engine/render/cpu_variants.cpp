#include "engine/render/cpu_variants.h"

#include <array>

#include "engine/render/cpu_kernel.h"

namespace glint {
namespace {

template <FeatureMask kMask>
constexpr KernelVariant variant(const char* name) {
    return {name, kMask, &renderTile<kMask>, &renderAovTile<kMask>, &replayPixel<kMask>};
}

}  // namespace

std::span<const KernelVariant> kernelVariants() {
    static constexpr std::array kVariants = {
        variant<kMaskDiffuseShapes>("diffuse shapes"), variant<kMaskSmoothRevolvedShapes>("smooth shapes"),
        variant<kMaskDiffuseMeshes>("diffuse meshes"), variant<kMaskSmoothMeshes>("smooth meshes"),
        variant<kMaskOneSampler>("one sampler"),       variant<kAllFeatures>("full"),
    };
    return kVariants;
}

}  // namespace glint
