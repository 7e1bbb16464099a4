// Cushions, the sofa, the armchair and chairs.
#include "engine/examples/living_room.h"
#include "engine/examples/paint.h"

namespace glint::examples {
namespace {

/// Axes tilted backwards by `degrees` about x.
Pose leaning(const Vec3d& origin, double degrees) {
    const double a = degrees * kPiD / 180.0;
    return {origin, {1.0, 0.0, 0.0}, {0.0, std::cos(a), -std::sin(a)}, {0.0, std::sin(a), std::cos(a)}};
}

MeshData leg(double height) {
    return lathe({{{0.001, 0.0}, {0.016, 0.0}, {0.026, height}, {0.001, height}}, false}, 20);
}

}  // namespace

MeshData cushion(const Vec3d& size, const Detail& detail, uint64_t number) {
    const Noise noise(hashCounter(90, number));
    const auto steps = static_cast<uint32_t>(detail.steps(72, 10));
    const auto bulge = [](double a) { return std::sqrt(std::max(0.0, 1.0 - std::pow(std::abs(a), 3.4))); };
    const auto at = [&](double u, double v, double side) {
        const double a = 2.0 * u - 1.0, b = 2.0 * v - 1.0;
        const double pinch = 0.035 * (1.0 - a * a) * b * b, pinch2 = 0.035 * (1.0 - b * b) * a * a;
        const double crease =
            0.05 * (noise.cloud(u, v, 3, 3, 3) - 0.5) + 0.012 * (noise.cloud(u, v, 14, 14, 2) - 0.5);
        const double height = bulge(a) * bulge(b) * (0.5 + crease);
        return Vec3d(0.5 * size.x * a * (1.0 - pinch2), 0.5 * size.y * b * (1.0 - pinch),
                     side * size.z * height);
    };
    MeshData mesh = sheet(steps, steps, {size.x, size.y}, [&](double u, double v) { return at(u, v, 1.0); });
    add(&mesh,
        sheet(steps, steps, {size.x, size.y}, [&](double u, double v) { return at(1.0 - u, v, -1.0); }));
    std::vector<Vec3d> seam;
    const int n = detail.steps(40, 6);
    for (int i = 0; i < 4 * n; ++i) {
        const double t = static_cast<double>(i % n) / n;
        const Vec2d uv = i < n       ? Vec2d(t, 0.0)
                         : i < 2 * n ? Vec2d(1.0, t)
                         : i < 3 * n ? Vec2d(1.0 - t, 1.0)
                                     : Vec2d(0.0, 1.0 - t);
        seam.push_back(at(uv.x, uv.y, 1.0));
    }
    add(&mesh, tube(seam, 0.006, detail.steps(8, 4), true));
    return mesh;
}

void addSofa(const Pose& frame, RoomMeshes* to) {
    const Detail& detail = to->detail;
    const auto box = [&](const Vec3d& size, const Vec3d& middle, double radius) {
        addVaried(&to->sofa, roundedBox(size, radius, detail.steps(8, 2)), frame * Pose{middle},
                  to->sofa.positions.size());
    };
    box({2.06, 0.24, 0.84}, {0.0, 0.24, 0.0}, 0.03);
    box({2.06, 0.56, 0.2}, {0.0, 0.5, -0.36}, 0.07);
    for (const double side : {-1.0, 1.0}) {
        box({0.2, 0.52, 0.92}, {side * 1.12, 0.36, 0.0}, 0.085);
        for (const double z : {-0.36, 0.36}) {
            add(&to->walnut, leg(0.13), frame * Pose{{side * 1.08, 0.0, z}});
        }
    }
    for (int i = -1; i <= 1; ++i) {
        const auto number = static_cast<uint64_t>(i + 1);
        addVaried(&to->sofa, cushion({0.68, 0.72, 0.19}, detail, number),
                  frame * lying({i * 0.68, 0.44, 0.08}), number);
        addVaried(&to->sofa, cushion({0.68, 0.5, 0.22}, detail, 10 + number),
                  frame * leaning({i * 0.68, 0.75, -0.22}, 12.0), 10 + number);
    }
    const auto pillow = [&](int kind, const Vec3d& place, double turn, double roll, uint64_t number) {
        const double a = roll * kPiD / 180.0;
        const Pose rolled{{0.0, 0.0, 0.0},
                          {std::cos(a), std::sin(a), 0.0},
                          {-std::sin(a), std::cos(a), 0.0},
                          {0.0, 0.0, 1.0}};
        add(&to->pillows[kind], cushion({0.46, 0.46, 0.17}, detail, number),
            frame * turned(place, turn) * leaning({}, 24.0) * rolled);
    };
    pillow(0, {-0.78, 0.74, -0.02}, 22.0, 4.0, 20);
    pillow(1, {-0.5, 0.71, 0.08}, 10.0, -8.0, 21);
    pillow(1, {0.8, 0.74, -0.02}, -24.0, -5.0, 22);
}

void addArmchair(const Pose& frame, RoomMeshes* to) {
    const Detail& detail = to->detail;
    const auto box = [&](const Vec3d& size, const Pose& place, double radius) {
        addVaried(&to->leather, roundedBox(size, radius, detail.steps(8, 2)), frame * place,
                  to->leather.positions.size());
    };
    box({0.62, 0.16, 0.66}, Pose{{0.0, 0.26, 0.02}}, 0.04);
    box({0.62, 0.62, 0.16}, leaning({0.0, 0.64, -0.33}, 14.0), 0.07);
    addVaried(&to->leather, cushion({0.6, 0.62, 0.17}, detail, 30), frame * lying({0.0, 0.41, 0.05}), 30);
    addVaried(&to->leather, cushion({0.58, 0.5, 0.15}, detail, 31), frame * leaning({0.0, 0.7, -0.22}, 14.0),
              31);
    for (const double side : {-1.0, 1.0}) {
        box({0.13, 0.4, 0.74}, Pose{{side * 0.37, 0.4, 0.0}}, 0.06);
        for (const double z : {-0.3, 0.3}) {
            add(&to->walnut, leg(0.19), frame * Pose{{side * 0.33, 0.0, z}});
        }
    }
}

}  // namespace glint::examples
