// The shelves with their books.
#include "engine/examples/living_room.h"

namespace glint::examples {
namespace {

/// Standing upright: its spine at +z, its width along x, its foot at the origin.
void addBook(const Vec3d& size, const Pose& frame, uint64_t number, RoomMeshes* to) {
    Dice dice(hashCounter(60, number));
    MeshData* cover = &to->books[static_cast<size_t>(dice.next() * 5.0)];
    const int steps = to->detail.steps(2, 1);
    constexpr double kBoard = 0.0026;
    const auto put = [&](MeshData* mesh, const Vec3d& extent, const Vec3d& middle, double radius) {
        add(mesh, roundedBox(extent, radius, steps), frame * Pose{middle});
    };
    const double x = 0.5 * size.x - 0.5 * kBoard;
    put(cover, {kBoard, size.y, size.z}, {-x, 0.5 * size.y, 0.0}, 0.001);
    put(cover, {kBoard, size.y, size.z}, {x, 0.5 * size.y, 0.0}, 0.001);
    // The spine is round.
    const double spine = std::min(0.5 * size.x, 0.008);
    put(cover, {size.x, size.y, 2.0 * spine}, {0.0, 0.5 * size.y, 0.5 * size.z - 0.4 * spine}, 0.95 * spine);
    put(&to->paper, {size.x - 2.0 * kBoard, size.y - 0.008, size.z - 0.012}, {0.0, 0.5 * size.y, 0.0},
        0.0008);
    if (dice.next() < 0.6) {  // gilded lines and a title's label
        for (const double height : {0.1, 0.16, 0.86}) {
            put(&to->brass, {0.96 * size.x, 0.0025, 0.004},
                {0.0, height * size.y, 0.5 * size.z + 0.6 * spine - 0.0016}, 0.001);
        }
        if (dice.next() < 0.5) {
            put(&to->paper, {0.7 * size.x, 0.16 * size.y, 0.004},
                {0.0, 0.7 * size.y, 0.5 * size.z + 0.6 * spine - 0.0018}, 0.0015);
        }
    }
}

/// Books from x = 0 up to `width`, some leaning; the last ones may lie.
void fillShelf(double width, double height, const Pose& frame, uint64_t shelf, RoomMeshes* to) {
    Dice dice(hashCounter(61, shelf));
    double x = 0.01;
    uint64_t number = 1000 * shelf;
    const double end = width * dice.between(0.72, 0.98);
    while (x < end) {
        const Vec3d size(dice.between(0.016, 0.05), height * dice.between(0.58, 0.92),
                         dice.between(0.14, 0.2));
        const double slip = dice.between(0.0, 0.02);
        if (x + size.x > end) { break; }
        addBook(size, frame * Pose{{x + 0.5 * size.x, 0.0, 0.5 * size.z - 0.1 - slip}}, number++, to);
        x += size.x + dice.between(0.0005, 0.002);
    }
    if (width - x > 0.1) {  // one leans on the others
        const double angle = 0.2, c = std::cos(angle), n = std::sin(angle);
        const Pose leaning{{x + 0.002, 0.0, 0.0}, {c, n, 0.0}, {-n, c, 0.0}, {0.0, 0.0, 1.0}};
        addBook({0.026, 0.78 * height, 0.16},
                frame * Pose{{n * 0.78 * height, 0.0, 0.0}} * leaning * Pose{{0.013, 0.006, 0.0}}, number++,
                to);
    }
    double y = 0.0;
    if (width - x > 0.33) {  // and three lie beside it
        for (int i = 0; i < 3; ++i) {
            const double thick = dice.between(0.02, 0.04);
            const Pose lying{
                {x + 0.3, y + 0.5 * thick, 0.02}, {0.0, 1.0, 0.0}, {-1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}};
            addBook({thick, dice.between(0.19, 0.22), 0.15}, frame * lying * Pose{{0.0, -0.02, 0.0}},
                    number++, to);
            y += thick + 0.001;
        }
    }
}

}  // namespace

void addShelves(const Pose& frame, RoomMeshes* to) {
    constexpr double kWidth = 1.5, kCaseHeight = 2.3, kDepth = 0.3, kBoard = 0.028;
    constexpr int kLevels = 6;
    const auto board = [&](const Vec3d& size, const Vec3d& middle) {
        addVaried(&to->oak, roundedBox(size, 0.003, to->detail.steps(2, 1)), frame * Pose{middle},
                  to->oak.positions.size());
    };
    for (const double x : {-0.5 * kWidth, 0.0, 0.5 * kWidth}) {
        board({kBoard, kCaseHeight, kDepth}, {x, 0.5 * kCaseHeight, 0.0});
    }
    board({kWidth, kCaseHeight, 0.008}, {0.0, 0.5 * kCaseHeight, -0.5 * kDepth + 0.004});
    board({kWidth + 0.06, 0.04, kDepth + 0.04}, {0.0, kCaseHeight + 0.02, 0.01});
    const double level = (kCaseHeight - 0.1) / kLevels;
    for (int i = 0; i <= kLevels; ++i) {
        board({kWidth, kBoard, kDepth - 0.02}, {0.0, 0.08 + i * level, 0.0});
    }
    const double width = 0.5 * kWidth - kBoard;
    for (int i = 0; i < kLevels; ++i) {
        for (int half = 0; half < 2; ++half) {
            const Vec3d foot(half == 0 ? -0.5 * kWidth + 0.5 * kBoard : 0.5 * kBoard,
                             0.08 + i * level + 0.5 * kBoard, 0.0);
            const auto shelf = static_cast<uint64_t>(2 * i + half);
            if (shelf == 7) {  // a vase and a ball instead
                const Outline vase{{{0.001, 0.0},
                                    {0.05, 0.0},
                                    {0.085, 0.06},
                                    {0.09, 0.11},
                                    {0.06, 0.18},
                                    {0.032, 0.22},
                                    {0.038, 0.26},
                                    {0.03, 0.26}},
                                   false,
                                   60.0};
                add(&to->porcelain, lathe(vase, to->detail.steps(64, 12)),
                    frame * Pose{foot + Vec3d(0.2, 0.0, 0.0)});
                const Outline ball = {{{0.001, 0.0},
                                       {0.04, 0.008},
                                       {0.07, 0.04},
                                       {0.075, 0.075},
                                       {0.066, 0.11},
                                       {0.04, 0.14},
                                       {0.001, 0.15}},
                                      false,
                                      80.0};
                add(&to->copper, lathe(ball, to->detail.steps(64, 12)),
                    frame * Pose{foot + Vec3d(0.48, 0.0, 0.0)});
                continue;
            }
            fillShelf(width, level - 0.05, frame * Pose{foot}, shelf, to);
        }
    }
}

}  // namespace glint::examples
