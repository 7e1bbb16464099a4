#include "engine/render/pass_params.h"

#include "engine/render/sppm_state.h"

namespace glint {

PassParams passParamsOf(const SceneDescription& scene) {
    const RenderOptions& options = scene.options;
    PassParams params;
    params.width = scene.resolution.width;
    params.height = scene.resolution.height;
    params.seed = options.seed;
    params.maxDepth = options.maxDepth;
    params.rouletteStartDepth = options.rouletteStartDepth;
    params.filter = options.filter;
    params.filterRadius = options.filterRadius;
    params.sampler = options.sampler;
    params.fireflyClamp = options.fireflyClamp;
    return params;
}

SppmParams sppmParamsOf(const SceneDescription& scene) {
    const SppmOptions& options = scene.sppm;
    SppmParams params;
    params.pass = passParamsOf(scene);
    params.photonsPerPass = planSppmMemory(scene).photonsPerPass;
    params.alpha = static_cast<double>(options.alpha);
    params.radiusWorld = options.radiusWorld;
    params.radiusFootprints = options.radiusFootprints;
    params.storeAlpha = options.storeRoughness;
    params.sampleDirectLight = options.sampleDirectLight;
    params.lookup = options.lookup;
    return params;
}

}  // namespace glint
