// The coffee table and what stands on it, the dining table with its chairs, and the plant.
#include "engine/examples/living_room.h"
#include "engine/examples/paint.h"

namespace glint::examples {
namespace {

void addCup(const Pose& frame, RoomMeshes* to) {
    const int corners = to->detail.steps(56, 12);
    const Outline saucer{{{0.001, 0.0},
                          {0.04, 0.0},
                          {0.05, 0.006},
                          {0.074, 0.016},
                          {0.075, 0.018},
                          {0.05, 0.01},
                          {0.001, 0.006}},
                         false,
                         60.0};
    const Outline cup{{{0.001, 0.008},
                       {0.022, 0.008},
                       {0.024, 0.014},
                       {0.036, 0.03},
                       {0.041, 0.05},
                       {0.042, 0.064},
                       {0.0405, 0.065},
                       {0.039, 0.05},
                       {0.034, 0.031},
                       {0.02, 0.016},
                       {0.001, 0.014}},
                      false,
                      60.0};
    add(&to->porcelain, lathe(saucer, corners), frame);
    add(&to->porcelain, lathe(cup, corners), frame);
    std::vector<Vec3d> handle;
    for (int i = 0; i <= 16; ++i) {
        const double angle = kPiD * (0.62 - 1.2 * i / 16.0);
        handle.emplace_back(0.039 + 0.016 * std::cos(angle), 0.041 + 0.017 * std::sin(angle), 0.0);
    }
    add(&to->porcelain, tube(handle, 0.0032, 10), frame);
}

void addFruitBowl(const Pose& frame, RoomMeshes* to) {
    const Outline bowl{{{0.001, 0.0},
                        {0.05, 0.0},
                        {0.05, 0.008},
                        {0.1, 0.03},
                        {0.14, 0.072},
                        {0.143, 0.078},
                        {0.137, 0.074},
                        {0.095, 0.036},
                        {0.04, 0.016},
                        {0.001, 0.014}},
                       false,
                       60.0};
    add(&to->walnut, lathe(bowl, to->detail.steps(96, 16)), frame);
    const int steps = to->detail.steps(28, 8);
    Outline half{{}, false, 80.0};
    for (int i = 0; i <= steps; ++i) {
        const double angle = kPiD * (static_cast<double>(i) / steps - 0.5);
        // Hollow where the stem was.
        const double dent =
            1.0 - 0.1 * std::exp(-40.0 * (kPiD / 2 - std::abs(angle)) * (kPiD / 2 - std::abs(angle)));
        half.points.emplace_back(std::max(0.0003, 0.038 * std::cos(angle)), 0.036 * dent * std::sin(angle));
    }
    const MeshData orange = lathe(half, 2 * steps);
    const Vec3d places[]{{-0.05, 0.062, 0.03},    {0.04, 0.062, 0.045},  {0.005, 0.06, -0.05},
                         {-0.075, 0.075, -0.045}, {0.075, 0.073, -0.03}, {-0.005, 0.115, 0.0}};
    for (const Vec3d& place : places) {
        add(&to->fruit, orange, frame * turned(place, 900.0 * place.x));
    }
}

void addChair(const Pose& frame, RoomMeshes* to) {
    const Detail& detail = to->detail;
    const auto box = [&](const Vec3d& size, const Pose& place, double radius) {
        addVaried(&to->walnut, roundedBox(size, radius, detail.steps(3, 1)), frame * place,
                  to->walnut.positions.size());
    };
    box({0.44, 0.03, 0.42}, Pose{{0.0, 0.45, 0.0}}, 0.012);
    add(&to->pillows[0], cushion({0.41, 0.39, 0.07}, detail, 40), frame * lying({0.0, 0.485, 0.0}));
    for (const double x : {-0.19, 0.19}) {
        add(&to->walnut, tube({{x, 0.45, 0.18}, {1.1 * x, 0.0, 0.2}}, 0.017, 16), frame);
        std::vector<Vec3d> post;
        for (int i = 0; i <= 20; ++i) {
            const double t = i / 20.0;
            post.emplace_back(x * (1.1 - 0.1 * std::min(1.0, 2.0 * t)), 0.95 * t,
                              -0.22 + 0.1 * t * (1.0 - t) - 0.07 * t * t);
        }
        add(&to->walnut, tube(post, 0.016, 16), frame);
    }
    for (int i = 0; i < 3; ++i) {
        const double y = 0.62 + 0.13 * i;
        std::vector<Vec3d> slat;
        for (int k = 0; k <= 16; ++k) {
            const double t = k / 8.0 - 1.0;
            slat.emplace_back(0.19 * t, y, -0.235 - 0.035 * (1.0 - t * t) - 0.03 * i);
        }
        add(&to->walnut, sweep(bevelled(0.014, 0.07, 0.005), along(slat, {0.0, 1.0, 0.0})), frame);
    }
}

/// A stalk with a leaf at its end.
void addLeaf(double turn, double reach, double height, double size, const Pose& frame, RoomMeshes* to) {
    const Pose out = frame * turned({0.0, 0.0, 0.0}, turn);
    std::vector<Vec3d> stalk;
    for (int i = 0; i <= 10; ++i) {
        const double t = i / 10.0;
        stalk.emplace_back(reach * t * t, height * (1.6 * t - 0.6 * t * t), 0.0);
    }
    add(&to->leaf, tube(stalk, 0.004, 6), out);
    const Vec3d tip = stalk.back();
    const auto steps = static_cast<uint32_t>(to->detail.steps(26, 6));
    add(&to->leaf,
        sheet(steps, steps, {1.0, 1.0},
              [&](double u, double v) {
                  const double a = 2.0 * u - 1.0;
                  const double width =
                      0.36 * std::pow(std::sin(kPiD * std::pow(std::max(v, 1e-4), 0.75)), 0.8) + 0.002;
                  const double droop = -0.55 * v * v + 0.1 * v, fold = 0.2 * std::abs(a) * width;
                  const double wave = 0.018 * std::sin(9.0 * v) * a;
                  return tip + size * Vec3d(v, droop + fold + wave, -a * width);
              }),
        out);
}

}  // namespace

void addCoffeeTable(const Pose& frame, RoomMeshes* to) {
    const Detail& detail = to->detail;
    add(&to->marble, roundedBox({1.15, 0.028, 0.6}, 0.01, detail.steps(6, 2)),
        frame * Pose{{0.0, 0.416, 0.0}});
    for (const double x : {-0.5, 0.5}) {
        for (const double z : {-0.23, 0.23}) {
            add(&to->brass, tube({{x, 0.402, z}, {1.04 * x, 0.0, 1.04 * z}}, 0.013, 20), frame);
        }
        add(&to->brass, tube({{x, 0.392, -0.23}, {x, 0.392, 0.23}}, 0.01, 14), frame);
    }
    for (const double z : {-0.23, 0.23}) {
        add(&to->brass, tube({{-0.5, 0.392, z}, {0.5, 0.392, z}}, 0.01, 14), frame);
    }
    addVaried(&to->oak, roundedBox({1.0, 0.02, 0.46}, 0.006, 2), frame * Pose{{0.0, 0.16, 0.0}}, 77);
    const double top = 0.43;
    addFruitBowl(frame * Pose{{0.28, top, -0.06}}, to);
    addCup(frame * turned({-0.05, top, 0.17}, 200.0), to);
    addCup(frame * turned({-0.38, top, -0.12}, 40.0), to);
    const double heights[]{0.018, 0.03, 0.022};
    double y = top;
    for (int i = 0; i < 3; ++i) {  // books lie at the corner
        const Pose place = frame * turned({-0.34, y + 0.5 * heights[i], 0.14}, 12.0 * i - 20.0);
        add(&to->books[static_cast<size_t>((2 * i + 1) % 5)], roundedBox({0.24, heights[i], 0.17}, 0.004, 3),
            place);
        add(&to->paper, roundedBox({0.232, heights[i] - 0.006, 0.171}, 0.001, 1),
            place * Pose{{0.0055, 0.0, 0.0}});
        y += heights[i];
    }
    const Outline candle{{{0.001, 0.0}, {0.032, 0.0}, {0.032, 0.075}, {0.028, 0.079}, {0.001, 0.07}}, false};
    add(&to->wax, lathe(candle, 40), frame * Pose{{-0.33, y, 0.13}});
}

void addDiningTable(const Pose& frame, RoomMeshes* to) {
    const int corners = to->detail.steps(128, 20);
    const Outline table{{{0.001, 0.715},
                         {0.47, 0.715},
                         {0.5, 0.725},
                         {0.51, 0.735},
                         {0.505, 0.745},
                         {0.5, 0.748},
                         {0.001, 0.748}},
                        false};
    const Outline foot{{{0.001, 0.0},
                        {0.3, 0.0},
                        {0.3, 0.02},
                        {0.24, 0.04},
                        {0.1, 0.07},
                        {0.055, 0.14},
                        {0.045, 0.3},
                        {0.06, 0.42},
                        {0.05, 0.52},
                        {0.07, 0.64},
                        {0.16, 0.715}},
                       false,
                       50.0};
    add(&to->oak, lathe(table, corners), frame);
    add(&to->oak, lathe(foot, corners), frame);
    const Outline plate{{{0.001, 0.0},
                         {0.07, 0.0},
                         {0.078, 0.006},
                         {0.125, 0.018},
                         {0.126, 0.021},
                         {0.08, 0.01},
                         {0.001, 0.006}},
                        false,
                        60.0};
    for (const double turn : {20.0, 160.0}) {
        const Pose side = frame * turned({0.0, 0.0, 0.0}, turn);
        add(&to->porcelain, lathe(plate, corners), side * Pose{{0.3, 0.748, 0.0}});
        addCup(side * turned({0.2, 0.748, -0.2}, 50.0), to);
        addChair(side * turned({0.72, 0.0, 0.0}, -90.0), to);
    }
}

void addPlant(const Pose& frame, RoomMeshes* to) {
    const Outline pot{{{0.001, 0.0},
                       {0.14, 0.0},
                       {0.15, 0.01},
                       {0.19, 0.3},
                       {0.2, 0.34},
                       {0.205, 0.38},
                       {0.185, 0.38},
                       {0.18, 0.34}},
                      false,
                      50.0};
    add(&to->pot, lathe(pot, to->detail.steps(96, 16)), frame);
    add(&to->soil, lathe({{{0.185, 0.345}, {0.1, 0.352}, {0.001, 0.36}}, false}, 40), frame);
    Dice dice(17);
    for (int i = 0; i < 26; ++i) {
        const double t = i / 25.0;
        addLeaf(137.5 * i, mix(0.42, 0.1, t) * dice.between(0.8, 1.2),
                mix(0.35, 1.15, t) * dice.between(0.9, 1.1), mix(0.4, 0.27, t) * dice.between(0.85, 1.15),
                frame * Pose{{0.0, 0.34, 0.0}}, to);
    }
}

}  // namespace glint::examples
