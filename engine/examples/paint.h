// What the images of example scenes are painted with: seamless noise, and pictures computed pixel by pixel.
//
// Colours are as files store them, sRGB-encoded from 0 to 1; heights of bump maps are grey.
#pragma once

#include <cmath>

#include "engine/base/parallel.h"
#include "engine/examples/model.h"
#include "engine/scene/image.h"

namespace glint::examples {

inline double mix(double a, double b, double t) { return a + (b - a) * t; }
inline Vec3d mix(const Vec3d& a, const Vec3d& b, double t) { return a + (b - a) * t; }
/// 0 up to `from`, 1 beyond `to`, smooth between them.
inline double ramp(double from, double to, double x) {
    const double t = std::min(1.0, std::max(0.0, (x - from) / (to - from)));
    return t * t * (3.0 - 2.0 * t);
}
inline double fraction(double x) { return x - std::floor(x); }

/// Value noise that repeats after whole numbers of cells.
class Noise {
  public:
    explicit Noise(uint64_t seed) : seed_(seed) {}

    /// A number in [0, 1) for a cell.
    double cell(int64_t x, int64_t y) const {
        const auto key = (static_cast<uint64_t>(x) << 32) ^ static_cast<uint32_t>(y);
        return static_cast<double>(hashCounter(seed_, key) >> 11) * 0x1p-53;
    }
    /// Smooth, in [0, 1), at u and v in [0, 1) of a tile of `cellsU` by `cellsV` cells.
    double smooth(double u, double v, int cellsU, int cellsV) const;
    /// Sums `octaves` of it, each twice as fine and half as strong; in [0, 1).
    double cloud(double u, double v, int cellsU, int cellsV, int octaves) const;

  private:
    uint64_t seed_;
};

/// Courses of blocks, every second one moved by half a block.
struct Masonry {
    int blocks, courses;    ///< in a tile; courses must be even
    double jointU, jointV;  ///< half a joint's width, as a share of a block

    struct Place {
        double stone;  ///< 0 in a joint, 1 on the block
        int column, row;
        double u, v;  ///< within the block, from 0 to 1
    };
    Place at(double u, double v) const;
};

/// Pixels' colours from (u, v), v upwards.
template <class Color>
Image8 paint(int width, int height, const Color& color) {
    Image8 image{width, height, std::vector<uint8_t>(size_t{3} * width * height)};
    parallelChunks(height, 16, 0, [&](int64_t begin, int64_t end) {
        for (int64_t y = begin; y < end; ++y) {
            for (int x = 0; x < width; ++x) {
                const Vec3d c = color((x + 0.5) / width, 1.0 - (static_cast<double>(y) + 0.5) / height);
                uint8_t* pixel = &image.rgb[3 * (static_cast<size_t>(y) * width + x)];
                for (int channel = 0; channel < 3; ++channel) {
                    pixel[channel] =
                        static_cast<uint8_t>(std::lround(255.0 * glm::clamp(c[channel], 0.0, 1.0)));
                }
            }
        }
    });
    return image;
}

/// A bump map.
template <class Height>
Image8 paintHeights(int width, int height, const Height& heightAt) {
    return paint(width, height, [&](double u, double v) { return Vec3d(heightAt(u, v)); });
}

}  // namespace glint::examples
