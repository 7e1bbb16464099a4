// What a scene file may say about how it is rendered. Command-line options and panels override it.
#pragma once

#include <cstdint>

namespace glint {

enum class IntegratorKind : uint8_t { PathTracing, Sppm };
enum class FilterKind : uint8_t { Box, Gaussian, BlackmanHarris };
enum class SamplerKind : uint8_t { Sobol, Independent };

/// All of these change the picture's expectation or its noise: an edit of any restarts the film.
struct RenderOptions {
    IntegratorKind integrator = IntegratorKind::PathTracing;
    int maxDepth = 16;            ///< most scattering events along a path; 0: only directly visible emission
    int rouletteStartDepth = 4;   ///< Russian roulette from this scattering event on
    FilterKind filter = FilterKind::BlackmanHarris;
    float filterRadius = 1.5f;    ///< pixels, half the support; box: 0.5 is one pixel
    SamplerKind sampler = SamplerKind::Sobol;
    uint32_t seed = 0;
    float fireflyClamp = 0.0f;    ///< 0: off. Otherwise the most radiance one sample may bring; biased, and reported

    bool operator==(const RenderOptions&) const = default;
};

struct Resolution {
    int width = 512;
    int height = 512;

    bool operator==(const Resolution&) const = default;
};

}  // namespace glint
