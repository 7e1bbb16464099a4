// A lat-long environment image with the distribution that samples it. Made by light_table.
#pragma once

#include <memory>
#include <vector>

#include "engine/kernels/light_view.h"
#include "engine/scene/image.h"

namespace glint {

struct EnvironmentTable {
    SceneImage source;           ///< its texels; compared to share the table between builds
    std::vector<float> decoded;  ///< of 8-bit texels: the linear value of each byte; else empty
    std::vector<float> rowCdf;   ///< see EnvironmentView
    std::vector<float> columnCdf;
    float meanLuminance = 0.0f;  ///< over solid angle

    /// Without rotation, which belongs to the light table.
    EnvironmentView view() const;
    size_t bytes() const;
};

/// Builds the distribution: each texel's cell weighs the integral of the bilinearly interpolated luminance
/// over it, so that light that a lookup can find is never without probability. An image that is black
/// everywhere gets a uniform distribution. Null for an empty image.
std::shared_ptr<const EnvironmentTable> buildEnvironmentTable(const SceneImage& source, int threads);

}  // namespace glint
