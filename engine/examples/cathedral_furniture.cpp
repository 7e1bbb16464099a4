// Pews, carpet, chandeliers, and the altar with its candles.
#include "engine/examples/cathedral.h"

namespace glint::examples {
namespace {

using namespace plan;

constexpr double kAltar = -kEast + 3.2;  ///< z of the altar's middle
constexpr double kSteps = kAltar + 3.4;  ///< z where the steps to it begin

/// A bench's end, seen from its side: a round top and a foot.
Outline benchEnd() {
    Outline outline{{{-0.26, 0.0}, {0.26, 0.0}, {0.22, 0.3}, {0.2, 0.55}, {0.16, 0.66}}, true, 40.0};
    for (int i = 0; i <= 10; ++i) {
        const double angle = kPiD * i / 10.0;
        outline.points.emplace_back(-0.14 + 0.11 * std::cos(angle), 0.95 + 0.13 * std::sin(angle));
    }
    outline.points.emplace_back(-0.24, 0.3);
    return outline;
}

MeshData bench(double width, uint64_t number) {
    MeshData mesh;
    const auto board = [&](const Vec3d& size, const Pose& frame, uint64_t part) {
        addVaried(&mesh, roundedBox(size, 0.012, 2), frame, 16 * number + part);
    };
    const double lean = 0.17;  // of the back, as a slope
    const Pose back{{0.0, 0.72, -0.2}, {1.0, 0.0, 0.0}, {0.0, 1.0, -lean}, {0.0, lean, 1.0}};
    board({width, 0.045, 0.4}, Pose{{0.0, 0.45, 0.03}}, 0);
    board({width, 0.5, 0.035}, back, 1);
    board({width, 0.05, 0.09}, back * Pose{{0.0, 0.27, 0.0}}, 2);
    board({width, 0.14, 0.03}, Pose{{0.0, 0.36, 0.18}}, 3);
    board({width, 0.03, 0.16}, Pose{{0.0, 0.72, -0.42}}, 4);  // for books
    board({width, 0.06, 0.14}, Pose{{0.0, 0.2, -0.5}}, 5);    // to kneel on
    for (const double side : {-1.0, 0.0, 1.0}) {
        // The outline's x is the bench's z.
        const Pose end{
            {side * 0.5 * width - 0.03, 0.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}};
        MeshData part = prism(benchEnd(), 0.06);
        for (Vec2& uv : part.uvs) {
            uv = {uv.y, uv.x};  // the grain runs upwards
        }
        addVaried(&mesh, part, end, 16 * number + 6);
    }
    return mesh;
}

void addCandle(const Vec3d& foot, double height, double radius, CathedralMeshes* to) {
    const int corners = to->detail.steps(16, 6);
    const Outline wax{
        {{radius, 0.0}, {radius, height - 0.01}, {0.8 * radius, height}, {0.001, height - 0.006}}};
    add(&to->wax, lathe(wax, corners), Pose{foot});
    to->flames.push_back(foot + Vec3d(0.0, height + 0.045, 0.0));
}

void addCandlestick(const Vec3d& foot, double height, CathedralMeshes* to) {
    const double h = height;
    const Outline stick{{{0.001, 0.0},
                         {0.13, 0.0},
                         {0.13, 0.02},
                         {0.1, 0.04},
                         {0.05, 0.08},
                         {0.03, 0.14},
                         {0.045, 0.2},
                         {0.055, 0.23},
                         {0.045, 0.26},
                         {0.022, 0.3},
                         {0.018, h - 0.2},
                         {0.03, h - 0.15},
                         {0.04, h - 0.12},
                         {0.03, h - 0.09},
                         {0.025, h - 0.06},
                         {0.075, h - 0.02},
                         {0.085, h},
                         {0.07, h},
                         {0.001, h - 0.01}},
                        false,
                        55.0};
    add(&to->gold, lathe(stick, to->detail.steps(36, 8)), Pose{foot});
    addCandle(foot + Vec3d(0.0, h - 0.01, 0.0), 0.4, 0.025, to);
}

/// A ring of twelve lamps on a chain.
void addChandelier(const Vec3d& middle, CathedralMeshes* to) {
    const int corners = to->detail.steps(12, 5), around = to->detail.steps(96, 16);
    const auto ring = [&](double radius, double height, double thick) {
        std::vector<Vec3d> points;
        for (const Vec2d& p : ellipse(radius, radius, around).points) {
            points.emplace_back(p.x, height, p.y);
        }
        add(&to->iron, tube(points, thick, corners, true), Pose{middle});
    };
    ring(1.15, 0.0, 0.032);
    ring(1.15, 0.16, 0.02);
    ring(0.5, 0.55, 0.022);
    const Outline cup{
        {{0.01, -0.12}, {0.03, -0.1}, {0.02, -0.04}, {0.03, 0.16}, {0.09, 0.2}, {0.1, 0.22}, {0.02, 0.23}},
        false,
        50.0};
    to->globes.push_back(middle + Vec3d(0.0, -0.1, 0.0));
    add(&to->iron, tube({{0.0, 0.1, 0.0}, {0.0, 2.0, 0.0}}, 0.015, corners), Pose{middle});
    for (int i = 0; i < 12; ++i) {
        const double angle = kPiD / 6.0 * i;
        const Vec3d out(std::cos(angle), 0.0, std::sin(angle));
        add(&to->gold, lathe(cup, to->detail.steps(24, 6)), Pose{middle + 1.15 * out});
        to->lamps.push_back(middle + 1.15 * out + Vec3d(0.0, 0.32, 0.0));
        std::vector<Vec3d> arm;  // from the outer ring up to the inner one
        for (int k = 0; k <= 12; ++k) {
            const double t = k / 12.0;
            arm.push_back(out * (1.15 - 0.65 * t) + Vec3d(0.0, 0.16 + 0.39 * t * t, 0.0));
        }
        add(&to->iron, tube(arm, 0.012, corners), Pose{middle});
        if (i % 3 == 0) {
            add(&to->iron, tube({out * 0.5 + Vec3d(0.0, 0.55, 0.0), Vec3d(0.0, 2.0, 0.0)}, 0.012, corners),
                Pose{middle});
        }
    }
    const double top = kVaultSpring + kVaultRise - middle.y;
    for (int link = 0; 2.0 + 0.15 * link < top; ++link) {
        std::vector<Vec3d> points;
        for (const Vec2d& p : ellipse(0.045, 0.095, 16).points) {
            points.push_back(link % 2 == 0 ? Vec3d(p.x, p.y, 0.0) : Vec3d(0.0, p.y, p.x));
        }
        add(&to->iron, tube(points, 0.014, 6, true), Pose{middle + Vec3d(0.0, 2.0 + 0.15 * link, 0.0)});
    }
}

/// The cloth over the altar, whose hem hangs in folds.
void addAltarCloth(CathedralMeshes* to) {
    const double halfX = 1.52, halfZ = 0.56, top = 1.53;
    const Outline edge = ellipse(1.0, 1.0, to->detail.steps(320, 40));
    const auto square = [&](const Vec2d& d, double grow) {  // a rounded rectangle in the direction of d
        const double n = 10.0;
        const double length = std::pow(std::pow(std::abs(d.x), n) + std::pow(std::abs(d.y), n), -1.0 / n);
        return Vec3d((halfX + grow) * d.x * length, 0.0, (halfZ + grow) * d.y * length);
    };
    const auto columns = static_cast<uint32_t>(edge.points.size());
    add(&to->cloth,
        sheet(columns, static_cast<uint32_t>(to->detail.steps(24, 4)), {6.0, 0.6},
              [&](double u, double v) {
                  const double angle = -2.0 * kPiD * u;
                  const Vec2d d(std::cos(angle), std::sin(angle));
                  const double fold =
                      0.035 * (1.0 - v) * (1.0 + std::sin(46.0 * angle + 2.0 * std::sin(7.0 * angle)));
                  return square(d, 0.01 + fold) + Vec3d(0.0, top - 0.55 * (1.0 - v), 0.0);
              }),
        Pose{{0.0, 0.0, kAltar}});
    add(&to->cloth, roundedBox({2.0 * halfX, 0.02, 2.0 * halfZ}, 0.008), Pose{{0.0, top + 0.002, kAltar}});
}

}  // namespace

void addFurniture(CathedralMeshes* to) {
    const int rows = 15;
    for (int row = 0; row < rows; ++row) {
        for (const double side : {-1.0, 1.0}) {
            const auto number = static_cast<uint64_t>(2 * row + (side > 0 ? 1 : 0));
            // Benches face the altar.
            add(&to->wood, bench(2.5, number), turned({side * 2.45, 0.0, -7.0 - 1.15 * row}, 180.0));
        }
    }
    const double carpetEnd = -kSteps;
    add(&to->carpet, sheet(8, 64, {1.0, (carpetEnd + 0.3) / 1.8}, [&](double u, double v) {
        const double sag = 0.012 - 0.008 * std::pow(std::abs(2.0 * u - 1.0), 8.0);
        return Vec3d((2.0 * u - 1.0) * 0.9, sag, 0.3 - (carpetEnd + 0.3) * v);
    }));
}

void addChandeliers(CathedralMeshes* to) {
    for (const double z : {-0.5 * kBay, -2.5 * kBay, -4.0 * kBay, -5.5 * kBay}) {
        addChandelier({0.0, 6.6, z}, to);
    }
}

void addAltar(CathedralMeshes* to) {
    for (int step = 0; step < 3; ++step) {
        const double west = kSteps - 0.45 * step, depth = west + kEast;
        add(&to->stone, roundedBox({8.0, 0.17, depth}, 0.02, 2),
            Pose{{0.0, 0.085 + 0.17 * step, west - 0.5 * depth}});
    }
    const double floor = 0.51;
    add(&to->stone, roundedBox({2.8, 0.9, 0.9}, 0.02), Pose{{0.0, floor + 0.45, kAltar}});
    add(&to->stone, roundedBox({3.0, 0.1, 1.08}, 0.03, 2), Pose{{0.0, floor + 0.95, kAltar}});
    addAltarCloth(to);
    const double top = floor + 1.03;
    for (const double x : {-1.3, -0.95, -0.6, 0.6, 0.95, 1.3}) {
        addCandlestick({x, top, kAltar - 0.25}, 0.75 - 0.12 * (std::abs(x) - 0.6), to);
    }
    for (const double side : {-1.0, 1.0}) {
        addCandlestick({side * 2.4, floor, kAltar + 0.6}, 1.5, to);
        addCandlestick({side * 3.2, floor, kAltar + 0.2}, 1.5, to);
    }
    add(&to->gold, roundedBox({0.09, 1.5, 0.07}, 0.02, 3), Pose{{0.0, top + 0.95, kAltar - 0.3}});
    add(&to->gold, roundedBox({0.8, 0.09, 0.07}, 0.02, 3), Pose{{0.0, top + 1.25, kAltar - 0.3}});
    const Outline foot{{{0.001, 0.0}, {0.24, 0.0}, {0.22, 0.05}, {0.12, 0.1}, {0.07, 0.22}}, false};
    add(&to->gold, lathe(foot, to->detail.steps(48, 10)), Pose{{0.0, top, kAltar - 0.3}});
}

}  // namespace glint::examples
