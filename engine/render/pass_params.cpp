// The tags are in the same order as the kinds, which kernels do not see.
#include "engine/render/pass_params.h"

namespace glint {

static_assert(static_cast<int>(FilterTag::BlackmanHarris) == static_cast<int>(FilterKind::BlackmanHarris));
static_assert(static_cast<int>(SamplerTag::Independent) == static_cast<int>(SamplerKind::Independent));

PassParams passParamsOf(const SceneDescription& scene) {
    const RenderOptions& options = scene.options;
    PassParams params;
    params.width = scene.resolution.width;
    params.height = scene.resolution.height;
    params.seed = options.seed;
    params.maxDepth = options.maxDepth;
    params.rouletteStartDepth = options.rouletteStartDepth;
    params.filter = static_cast<FilterTag>(options.filter);
    params.filterRadius = options.filterRadius;
    params.sampler = static_cast<SamplerTag>(options.sampler);
    params.fireflyClamp = options.fireflyClamp;
    return params;
}

}  // namespace glint
