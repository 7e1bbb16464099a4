// Renders a description on the CPU into a film, without a session: for tests of what the pictures hold.
#pragma once

#include <memory>

#include "engine/builders/built_scene.h"
#include "engine/kernels/pass.h"
#include "engine/render/film.h"
#include "engine/scene/scene_building.h"
#include "tests/support/statistics.h"

namespace glint::test {

/// Builds everything; fails the test and returns null when the description is not valid.
std::shared_ptr<const BuiltScene> buildAll(const SceneDescription& scene);

/// Renders `passes` passes with the scene's own options and `directLight`, on all threads.
Film renderFilm(const SceneDescription& scene, uint32_t passes,
                DirectLightTag directLight = DirectLightTag::Mis);

/// A value and its standard error.
struct Estimate {
    double mean = 0.0;
    double standardError = 0.0;
};

/// Mean luminance of the pixels [x0, x1) x [y0, y1). The error comes from the spread within pixels, which
/// low-discrepancy passes only make smaller than it says.
Estimate meanLuminance(const Film& film, int x0, int y0, int x1, int y1);
Estimate meanLuminance(const Film& film);

/// |a - b| is within the significance of statistics.h, plus `slack` times the value for float rounding.
bool agree(const Estimate& a, const Estimate& b, double slack = 1e-5);

}  // namespace glint::test
