// Triangles before a camera, drawn one by one: what is nearest in each pixel's middle.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include <glm/ext/vector_double3.hpp>

#include "engine/kernels/shading_view.h"

namespace glint {

/// In camera space, which looks along -z; y runs up.
using CameraTriangle = glm::dvec3[3];

/// Threads may draw at once: what stays does not depend on their order.
class DepthBuffer {
  public:
    /// Draws nothing nearer than `nearest` (> 0, along the view), from a pinhole where the camera has a lens.
    /// The camera must outlive it.
    DepthBuffer(const CameraData& camera, double nearest, int width, int height);

    /// `number` tells triangles apart. Those that are not finite are left out.
    void draw(const CameraTriangle& triangle, uint32_t number);
    /// More pixels were asked about triangles than is soon done: the rest is not drawn.
    bool isTooMuch() const { return asked_.load(std::memory_order_relaxed) > kMostAsked; }

    /// The ray through a pixel's middle.
    void ray(int x, int y, glm::dvec3* origin, glm::dvec3* direction) const;
    bool isEmpty(int x, int y) const { return pixels_[index(x, y)] == kEmpty; }
    /// Of the nearest triangle.
    uint32_t number(int x, int y) const { return static_cast<uint32_t>(pixels_[index(x, y)]); }

  private:
    static constexpr uint64_t kEmpty = UINT64_MAX;
    static constexpr int64_t kMostAsked = 100'000'000;  // some tenths of a second

    /// In pixels, from the picture's top left corner; `inverse` of the depth.
    struct Point {
        double x, y, inverse;
    };

    size_t index(int x, int y) const {
        return static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
    }
    Point project(const glm::dvec3& p) const;
    void fill(const Point& a, const Point& b, const Point& c, uint32_t number);
    double depthOf(const Point& a, const Point& b, const Point& c, double ofB, double ofC) const;
    void keepNearest(size_t pixel, double depth, uint32_t number);

    const CameraData& camera_;
    double nearest_;
    int width_, height_;
    std::vector<uint64_t> pixels_;  ///< depth, and the triangle's number
    std::atomic<int64_t> asked_{0};
};

}  // namespace glint
