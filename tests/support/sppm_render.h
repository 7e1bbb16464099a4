// Renders a description by SPPM and by path tracing on the CPU, for tests that compare the two.
#pragma once

#include <vector>

#include "engine/render/cpu_sppm.h"
#include "engine/render/sppm_state.h"
#include "engine/scene/scene.h"

namespace glint::test {

struct SppmRender {
    std::vector<Vec3> image;  ///< direct light and photons together, linear
    SppmState state;
    SppmPassStats lastPass;
};

/// `params.pass` is taken from the description, but for the seed.
SppmRender renderSppm(const SceneDescription& scene, SppmParams params, uint32_t passes, int threads = 0);

/// The mean of so many paths a pixel.
std::vector<Vec3> renderPaths(const SceneDescription& scene, uint32_t seed, uint32_t passes);

/// Mean luminance over a square block of pixels.
double blockMean(const std::vector<Vec3>& image, int width, int x, int y, int size);

}  // namespace glint::test
