#include "engine/io/vertex_colors.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/math/color.h"

namespace glint {

namespace {

/// What the colours of a file are.
struct ColorRange {
    float largest = 0.0f;
    size_t lit = 0;       ///< values above 0
    size_t aboveOne = 0;  ///< and above 1
    bool isWhole = true;  ///< all are whole numbers

    void add(float value) {
        largest = std::max(largest, value);
        lit += value > 0.0f ? 1 : 0;
        aboveOne += value > 1.0f ? 1 : 0;
        isWhole = isWhole && value == std::floor(value);
    }
    /// A few values above 1 are overbright ones.
    bool isIntegers() const {
        constexpr float kOverbright = 16.0f;
        return largest > 2.0f && (isWhole || (largest > kOverbright && 2 * aboveOne > lit));
    }
};

}  // namespace

void decodeVertexColors(const std::string& path, MeshFile* file, bool wholeNumbers) {
    ColorRange range;
    for (const MeshPart& part : file->parts) {
        for (const Vec3& color : part.mesh->colors) {
            range.add(color.x);
            range.add(color.y);
            range.add(color.z);
        }
    }
    const bool isScaled = wholeNumbers || range.isIntegers();
    const float scale = !isScaled                  ? 1.0f
                        : range.largest > 65535.0f ? range.largest
                        : range.largest > 255.0f   ? 65535.0f
                                                   : 255.0f;
    if (!isScaled && range.largest > 2.0f) {
        file->notes.push_back(fmt::format(
            "{}: vertex colours are read as 0 to 1, and cut there; the largest is {}", path, range.largest));
    }
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
