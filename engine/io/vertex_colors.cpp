#include "engine/io/vertex_colors.h"

#include <algorithm>

#include <fmt/format.h>

#include "engine/math/color.h"

namespace glint {

void decodeVertexColors(const std::string& path, MeshFile* file, bool wholeNumbers) {
    float largest = 0.0f;
    for (const MeshPart& part : file->parts) {
        for (const Vec3& color : part.mesh->colors) {
            largest = std::max(largest, maxComponent(color));
        }
    }
    const float scale = largest > 65535.0f               ? largest
                        : largest > 255.0f               ? 65535.0f
                        : wholeNumbers || largest > 2.0f ? 255.0f
                                                         : 1.0f;
    if (!wholeNumbers && scale > 1.0f) {
        file->notes.push_back(fmt::format("{}: vertex colours are read as 0 to {}", path, scale));
    }
    for (const MeshPart& part : file->parts) {
        for (Vec3& color : part.mesh->colors) {
            for (int c = 0; c < 3; ++c) {
                color[c] = srgbToLinear(std::clamp(color[c] / scale, 0.0f, 1.0f));
            }
        }
    }
}

}  // namespace glint
