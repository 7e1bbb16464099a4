// Walls, floor, window, curtains and the rug.
#include "engine/examples/living_room.h"
#include "engine/examples/paint.h"

namespace glint::examples {
namespace {

using namespace room;

/// A flat rectangle of the frame's x and y, facing its z.
MeshData panel(double x0, double x1, double y0, double y1) {
    MeshData part = sheet(1, 1, {1.0, 1.0},
                          [&](double u, double v) { return Vec3d(mix(x0, x1, u), mix(y0, y1, v), 0.0); });
    for (size_t i = 0; i < part.uvs.size(); ++i) {
        part.uvs[i] = Vec2(part.positions[i]);
    }
    return part;
}

/// A moulding around the room at a height, its outline's x pointing into the room.
void addAround(const Outline& outline, double height, MeshData* mesh) {
    const double x = kHalfX, z = kHalfZ;
    const Vec3d up(0.0, 1.0, 0.0);
    const Vec3d corners[]{{-x, height, -z}, {-x, height, z}, {x, height, z}, {x, height, -z}};
    for (int i = 0; i < 4; ++i) {
        const Vec3d &from = corners[i], &to = corners[(i + 1) % 4];
        const Vec3d ahead = glm::normalize(to - from);
        const Vec3d in = glm::cross(up, ahead);
        add(mesh, sweep(outline, {{to, in, up, -ahead}, {from, in, up, -ahead}}));
    }
}

void addCurtain(double from, double to, double phase, RoomMeshes* room) {
    const int columns = room->detail.steps(420, 200), rows = room->detail.steps(100, 10);
    constexpr double kTop = 2.5, kBottom = 0.02, kFolds = 8.0;
    add(&room->curtain,
        sheet(static_cast<uint32_t>(columns), static_cast<uint32_t>(rows), {2.2, kTop},
              [&](double u, double v) {
                  const double down = 1.0 - v;
                  // Folds are even where they are gathered, and wander and deepen below.
                  const double wander = down * (0.5 * std::sin(5.0 * u + phase) +
                                                0.3 * std::sin(11.0 * u + 2.0 * phase + 2.0 * down));
                  const double angle = 2.0 * kPiD * kFolds * u + wander;
                  const double depth =
                      0.026 + 0.036 * ramp(0.0, 0.7, down) + 0.012 * std::sin(9.0 * u + 3.0 * phase);
                  const double pleat = 0.4 + 0.6 * ramp(1.0, 0.85, v);
                  const double z = mix(from, to, u) + 0.009 * down * std::sin(angle + 1.3);
                  return Vec3d(-kHalfX + 0.17 + depth * pleat * std::sin(angle), mix(kBottom, kTop, v), z);
              }));
}

void addWindowFrame(RoomMeshes* to) {
    // The frame's x runs along the wall from the window's right edge, seen from inside.
    const double width = kWindowTo - kWindowFrom, height = kWindowHigh - kWindowLow;
    const Pose wall = turned({-kHalfX, kWindowLow, kWindowTo}, 90.0);
    const auto bar = [&](double x0, double x1, double y0, double y1, double z, double depth) {
        add(&to->trim, roundedBox({x1 - x0, y1 - y0, depth}, 0.006, 2),
            wall * Pose{{0.5 * (x0 + x1), 0.5 * (y0 + y1), z}});
    };
    for (const double z : {-0.12}) {
        bar(0.0, 0.07, 0.0, height, z, 0.07);
        bar(width - 0.07, width, 0.0, height, z, 0.07);
        bar(0.0, width, 0.0, 0.07, z, 0.07);
        bar(0.0, width, height - 0.07, height, z, 0.07);
        bar(width / 2 - 0.05, width / 2 + 0.05, 0.0, height, z, 0.07);
        bar(0.0, width, 0.68 * height, 0.68 * height + 0.06, z, 0.06);
        bar(0.25 * width - 0.012, 0.25 * width + 0.012, 0.0, height, z, 0.03);
        bar(0.75 * width - 0.012, 0.75 * width + 0.012, 0.0, height, z, 0.03);
    }
    bar(-0.1, width + 0.1, -0.06, 0.0, 0.02, 0.4);    // the sill
    bar(-0.09, 0.0, 0.0, height + 0.09, 0.01, 0.03);  // the casing
    bar(width, width + 0.09, 0.0, height + 0.09, 0.01, 0.03);
    bar(-0.12, width + 0.12, height, height + 0.11, 0.015, 0.05);
    // Reveals through the wall.
    add(&to->trim, panel(-0.24, 0.0, 0.0, height),
        turned({-kHalfX, kWindowLow, kWindowTo}, 180.0) * turned({0.0, 0.0, 0.0}, 0.0));
    add(&to->trim, panel(-0.24, 0.0, 0.0, height), Pose{{-kHalfX, kWindowLow, kWindowFrom}});
    add(&to->trim, roundedBox({0.24, 0.02, width}, 0.002),
        Pose{{-kHalfX - 0.12, kWindowHigh + 0.01, 0.5 * (kWindowFrom + kWindowTo)}});
    add(&to->trim, roundedBox({0.24, height, 0.02}, 0.002),
        Pose{{-kHalfX - 0.12, kWindowLow + 0.5 * height, kWindowTo + 0.01}});
}

}  // namespace

void addShell(RoomMeshes* to) {
    const Pose left = turned({-kHalfX, 0.0, 0.0}, 90.0);  // its x is -z
    add(&to->walls, panel(-kHalfZ, -kWindowTo, 0.0, kHeight), left);
    add(&to->walls, panel(-kWindowFrom, kHalfZ, 0.0, kHeight), left);
    add(&to->walls, panel(-kWindowTo, -kWindowFrom, 0.0, kWindowLow), left);
    add(&to->walls, panel(-kWindowTo, -kWindowFrom, kWindowHigh, kHeight), left);
    add(&to->walls, panel(-kHalfX, kHalfX, 0.0, kHeight), Pose{{0.0, 0.0, -kHalfZ}});
    add(&to->walls, panel(-kHalfX, kHalfX, 0.0, kHeight), turned({0.0, 0.0, kHalfZ}, 180.0));
    add(&to->walls, panel(-kHalfZ, kHalfZ, 0.0, kHeight), turned({kHalfX, 0.0, 0.0}, -90.0));
    add(&to->planks, panel(-kHalfX, kHalfX, -kHalfZ, kHalfZ),
        Pose{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}});
    add(&to->ceiling, panel(-kHalfX, kHalfX, -kHalfZ, kHalfZ),
        Pose{{0.0, kHeight, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, -1.0, 0.0}});
    const Outline skirting{
        {{0.018, 0.0}, {0.018, 0.1}, {0.014, 0.108}, {0.014, 0.115}, {0.006, 0.13}, {0.0, 0.13}}, false};
    addAround(skirting, 0.0, &to->trim);
    Outline cornice{{{0.0, -0.14}, {0.012, -0.14}, {0.016, -0.125}}, false};
    for (int i = 0; i <= 10; ++i) {
        const double angle = kPiD / 20.0 * i;
        cornice.points.emplace_back(0.11 - 0.09 * std::cos(angle), -0.11 + 0.09 * std::sin(angle));
    }
    cornice.points.insert(cornice.points.end(), {{0.125, -0.016}, {0.125, 0.0}});
    addAround(cornice, kHeight, &to->trim);
}

void addWindowAndCurtains(RoomMeshes* to) {
    addWindowFrame(to);
    addCurtain(kWindowFrom - 0.85, kWindowFrom + 0.05, 0.7, to);
    addCurtain(kWindowTo - 0.05, kWindowTo + 0.85, 2.9, to);
    const double rodX = -kHalfX + 0.17, z0 = kWindowFrom - 0.95, z1 = kWindowTo + 0.95;
    add(&to->brass, tube({{rodX, 2.53, z0}, {rodX, 2.53, z1}}, 0.016, 20));
    const Outline knob{
        {{0.001, 0.0}, {0.018, 0.005}, {0.03, 0.025}, {0.034, 0.045}, {0.026, 0.07}, {0.001, 0.082}},
        false,
        80.0};
    for (const double z : {z0, z1}) {
        const double side = z == z0 ? -1.0 : 1.0;
        add(&to->brass, lathe(knob, 32),
            Pose{{rodX, 2.53, z}, {1.0, 0.0, 0.0}, {0.0, 0.0, side}, {0.0, -side, 0.0}});
    }
    // What is outside: evening over a garden, a little larger than what is seen of it.
    MeshData view = panel(0.0, 1.0, 0.0, 1.0);
    add(&to->view, view,
        Pose{{-kHalfX - 0.9, -0.35, 2.4}, {0.0, 0.0, -4.8}, {0.0, 3.6, 0.0}, {1.0, 0.0, 0.0}});
}

void addRug(RoomMeshes* to) {
    const double width = 2.9, length = 2.0;
    const Vec3d middle(-0.45, 0.0, -0.55);
    MeshData& rug = to->rug;
    const auto put = [&](const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec2d& uv) {
        Vec3d normal = glm::normalize(glm::cross(b - a, c - a));
        const bool isFlipped = normal.y < 0.0;
        if (isFlipped) { normal = -normal; }
        const auto first = static_cast<uint32_t>(rug.positions.size());
        for (const Vec3d& p : {a, isFlipped ? c : b, isFlipped ? b : c}) {
            rug.positions.emplace_back(middle + p);
            // Pile scatters like the cloth that it stands for, not like single blades.
            rug.normals.emplace_back(glm::normalize(normal + Vec3d(0.0, 2.0, 0.0)));
            rug.uvs.emplace_back(uv);
        }
        rug.indices.insert(rug.indices.end(), {first, first + 1, first + 2});
    };
    Dice dice(5);
    const double spacing = 0.0056 / std::sqrt(to->detail.level);
    for (double z = -length / 2; z < length / 2; z += spacing) {
        for (double x = -width / 2; x < width / 2; x += spacing) {
            const Vec3d root(x + spacing * dice.next(), 0.004, z + spacing * dice.next());
            const double turn = 2.0 * kPiD * dice.next(), lean = dice.between(0.1, 0.9);
            const double blade = 0.45 * spacing;
            const Vec3d across = blade * Vec3d(std::cos(turn), 0.0, std::sin(turn));
            const Vec3d tip = root + Vec3d(-std::sin(turn) * lean * 0.008, dice.between(0.009, 0.013),
                                           std::cos(turn) * lean * 0.008);
            put(root - across, root + across, tip, {root.x / width + 0.5, 0.5 - root.z / length});
        }
    }
    for (int strand = 0; strand < to->detail.count(520, 20); ++strand) {  // fringes
        const double side = strand % 2 == 0 ? 1.0 : -1.0;
        const double z = dice.between(-length / 2, length / 2), reach = dice.between(0.05, 0.075);
        const Vec3d root(side * width / 2, 0.006, z),
            end = root + Vec3d(side * reach, -0.003, dice.between(-0.012, 0.012));
        put(root - Vec3d(0.0, 0.0, 0.0018), root + Vec3d(0.0, 0.0, 0.0018), end, {0.002, 0.5});
    }
    MeshData ground = panel(-width / 2, width / 2, -length / 2, length / 2);
    for (Vec2& uv : ground.uvs) {
        uv = {uv.x / static_cast<float>(width) + 0.5f, uv.y / static_cast<float>(length) + 0.5f};
    }
    add(&rug, ground,
        Pose{middle + Vec3d(0.0, 0.004, 0.0), {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}});
}

}  // namespace glint::examples
