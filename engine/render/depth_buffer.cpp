#include "engine/render/depth_buffer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace glint {
namespace {

/// The first pixel whose middle is not before x, and at most `end`.
int pixelFrom(double x, int end) {
    return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(end)));
}

}  // namespace

DepthBuffer::DepthBuffer(const CameraData& camera, double nearest, int width, int height)
    : camera_(camera),
      nearest_(nearest),
      width_(width),
      height_(height),
      pixels_(static_cast<size_t>(width) * static_cast<size_t>(height), kEmpty) {}

void DepthBuffer::draw(const CameraTriangle& triangle, uint32_t number) {
    glm::dvec3 kept[4];
    int count = 0;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 &a = triangle[i], &b = triangle[(i + 1) % 3];
        const bool isBefore = -a.z >= nearest_;
        if (isBefore) { kept[count++] = a; }
        if (isBefore != (-b.z >= nearest_)) {
            kept[count] = a + (b - a) * ((a.z + nearest_) / (a.z - b.z));
            kept[count++].z = -nearest_;
        }
    }
    for (int i = 2; i < count; ++i) {
        fill(project(kept[0]), project(kept[i - 1]), project(kept[i]), number);
    }
}

void DepthBuffer::ray(int x, int y, glm::dvec3* origin, glm::dvec3* direction) const {
    const double right = 2.0 * (x + 0.5) / width_ - 1.0, up = 1.0 - 2.0 * (y + 0.5) / height_;
    const glm::dvec3 place(
        right * static_cast<double>(camera_.halfWidth) + static_cast<double>(camera_.middle.x),
        up * static_cast<double>(camera_.halfHeight) + static_cast<double>(camera_.middle.y), 0.0);
    const glm::dvec3 along(0.0, 0.0, -1.0);
    *origin = camera_.isOrthographic ? place : glm::dvec3(0.0);
    *direction = camera_.isOrthographic ? along : glm::normalize(place + along);
}

DepthBuffer::Point DepthBuffer::project(const glm::dvec3& p) const {
    const double depth = -p.z, w = camera_.isOrthographic ? 1.0 : depth;
    const auto across = [&](double place, float middle, float half) {
        return (place / w - static_cast<double>(middle)) / static_cast<double>(half);
    };
    return {0.5 * width_ * (1.0 + across(p.x, camera_.middle.x, camera_.halfWidth)),
            0.5 * height_ * (1.0 - across(p.y, camera_.middle.y, camera_.halfHeight)), 1.0 / depth};
}

void DepthBuffer::fill(const Point& a, const Point& b, const Point& c, uint32_t number) {
    const double perArea = 1.0 / ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    if (!std::isfinite(perArea) || !std::isfinite(a.x + a.y + b.x + b.y + c.x + c.y)) { return; }
    const int x0 = pixelFrom(std::min({a.x, b.x, c.x}), width_);
    const int x1 = pixelFrom(std::max({a.x, b.x, c.x}), width_);
    const int y0 = pixelFrom(std::min({a.y, b.y, c.y}), height_);
    const int y1 = pixelFrom(std::max({a.y, b.y, c.y}), height_);
    if (x0 >= x1 || y0 >= y1) { return; }
    asked_.fetch_add(int64_t{x1 - x0} * int64_t{y1 - y0}, std::memory_order_relaxed);
    if (isTooMuch()) { return; }
    for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
            const double px = x + 0.5 - a.x, py = y + 0.5 - a.y;
            const double ofB = (px * (c.y - a.y) - py * (c.x - a.x)) * perArea;
            const double ofC = ((b.x - a.x) * py - (b.y - a.y) * px) * perArea;
            if (!(ofB >= 0.0 && ofC >= 0.0 && ofB + ofC <= 1.0)) { continue; }
            keepNearest(index(x, y), depthOf(a, b, c, ofB, ofC), number);
        }
    }
}

/// Its inverse is linear over a picture in perspective, itself over one by parallel rays.
double DepthBuffer::depthOf(const Point& a, const Point& b, const Point& c, double ofB, double ofC) const {
    const double ofA = 1.0 - ofB - ofC;
    if (camera_.isOrthographic) { return ofA / a.inverse + ofB / b.inverse + ofC / c.inverse; }
    return 1.0 / (ofA * a.inverse + ofB * b.inverse + ofC * c.inverse);
}

/// Depths are positive, so that their bits are in their order.
void DepthBuffer::keepNearest(size_t pixel, double depth, uint32_t number) {
    if (!(depth > 0.0 && depth <= static_cast<double>(std::numeric_limits<float>::max()))) { return; }
    const uint64_t candidate = uint64_t{std::bit_cast<uint32_t>(static_cast<float>(depth))} << 32 | number;
    std::atomic_ref<uint64_t> kept(pixels_[pixel]);
    uint64_t before = kept.load(std::memory_order_relaxed);
    while (candidate < before && !kept.compare_exchange_weak(before, candidate, std::memory_order_relaxed)) {}
}

}  // namespace glint
