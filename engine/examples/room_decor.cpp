// Lamps and what hangs on the walls.
#include "engine/examples/living_room.h"

namespace glint::examples {
namespace {

using namespace room;

/// A cloth shade with a bulb in it; `foot` is the middle of the shade's lower edge.
void addShade(const Vec3d& foot, double lower, double upper, double height, RoomMeshes* to) {
    const int corners = to->detail.steps(40, 12);
    add(&to->shade, lathe({{{lower, 0.0}, {upper, height}}, false}, corners), Pose{foot});
    add(&to->shadeInside, lathe({{{upper - 0.004, height}, {lower - 0.004, 0.0}}, false}, corners),
        Pose{foot});
    for (const double y : {0.0, height}) {
        std::vector<Vec3d> rim;
        const double radius = y == 0.0 ? lower : upper;
        for (const Vec2d& p : ellipse(radius - 0.002, radius - 0.002, 2 * corners).points) {
            rim.emplace_back(p.x, y, p.y);
        }
        add(&to->brass, tube(rim, 0.005, 10, true), Pose{foot});
    }
    to->bulbs.push_back(foot + Vec3d(0.0, 0.45 * height, 0.0));
}

/// A picture's rectangle in its frame, standing upright in the plane of x and y.
void addFramed(MeshData* image, double width, double height, double border, const Pose& frame,
               MeshData* moulding) {
    add(image,
        sheet(1, 1, {1.0, 1.0},
              [&](double u, double v) { return Vec3d((u - 0.5) * width, (v - 0.5) * height, 0.012); }),
        frame);
    const Outline outline{{{0.0, 0.0},
                           {border, 0.0},
                           {border, 0.02},
                           {0.75 * border, 0.036},
                           {0.5 * border, 0.026},
                           {0.2 * border, 0.03},
                           {0.0, 0.014}},
                          true,
                          30.0};
    const double x = 0.5 * width, y = 0.5 * height;
    const Vec3d corners[]{{-x, -y, 0.0}, {x, -y, 0.0}, {x, y, 0.0}, {-x, y, 0.0}};
    for (int i = 0; i < 4; ++i) {
        const Vec3d &from = corners[i], &to = corners[(i + 1) % 4];
        const Vec3d ahead = glm::normalize(to - from), out(ahead.y, -ahead.x, 0.0);
        // Mitred: the outline leans into the corner's diagonal.
        const Pose start{from, out - ahead, {0.0, 0.0, 1.0}, -ahead},
            end{to, out + ahead, {0.0, 0.0, 1.0}, -ahead};
        add(moulding, sweep(outline, {end, start}), frame);
    }
}

}  // namespace

void addLamps(RoomMeshes* to) {
    const int corners = to->detail.steps(64, 12);
    const Vec3d floorLamp(1.18, 0.0, -2.15);
    const Outline base{
        {{0.001, 0.0}, {0.15, 0.0}, {0.15, 0.014}, {0.13, 0.024}, {0.02, 0.03}, {0.012, 0.045}, {0.012, 1.5}},
        false,
        40.0};
    add(&to->brass, lathe(base, corners), Pose{floorLamp});
    addShade(floorLamp + Vec3d(0.0, 1.38, 0.0), 0.24, 0.17, 0.29, to);
    const Vec3d sideTable(-1.95, 0.0, -2.15);
    const Outline table{{{0.001, 0.0},
                         {0.16, 0.0},
                         {0.16, 0.012},
                         {0.02, 0.02},
                         {0.018, 0.5},
                         {0.05, 0.515},
                         {0.24, 0.52},
                         {0.245, 0.53},
                         {0.24, 0.542},
                         {0.001, 0.542}},
                        false,
                        40.0};
    add(&to->walnut, lathe(table, corners), Pose{sideTable});
    const Outline vase{{{0.001, 0.0},
                        {0.06, 0.0},
                        {0.065, 0.01},
                        {0.1, 0.07},
                        {0.105, 0.11},
                        {0.085, 0.17},
                        {0.04, 0.215},
                        {0.02, 0.235},
                        {0.018, 0.3}},
                       false,
                       60.0};
    add(&to->porcelain, lathe(vase, corners), Pose{sideTable + Vec3d(0.0, 0.542, 0.0)});
    addShade(sideTable + Vec3d(0.0, 0.8, 0.0), 0.19, 0.13, 0.22, to);
    // A copper bell over the dining table, which shines downwards.
    const Vec3d bell(-2.0, 1.5, 1.05);
    const Outline outside{
        {{0.2, 0.0}, {0.195, 0.03}, {0.15, 0.11}, {0.09, 0.16}, {0.04, 0.19}, {0.03, 0.24}, {0.001, 0.245}},
        false,
        60.0};
    const Outline inside{
        {{0.03, 0.17}, {0.085, 0.15}, {0.145, 0.105}, {0.19, 0.03}, {0.2, 0.0}}, false, 60.0};
    add(&to->copper, lathe(outside, corners), Pose{bell});
    add(&to->shadeInside, lathe(inside, corners), Pose{bell});
    add(&to->iron, tube({bell + Vec3d(0.0, 0.24, 0.0), {bell.x, kHeight, bell.z}}, 0.004, 8));
    to->bulbs.push_back(bell + Vec3d(0.0, 0.07, 0.0));
}

void addImages(RoomMeshes* to) {
    const double wall = -kHalfZ + 0.004;
    addFramed(&to->painting, 1.15, 0.72, 0.055, Pose{{-0.72, 1.68, wall}}, &to->brass);
    addFramed(&to->sketch, 0.32, 0.42, 0.03, Pose{{0.32, 1.78, wall}}, &to->walnut);
    addFramed(&to->photo, 0.32, 0.26, 0.03, Pose{{0.32, 1.38, wall}}, &to->walnut);
}

}  // namespace glint::examples
