#include "engine/examples/model.h"

#include <algorithm>

namespace glint::examples {
namespace {

/// A part of an outline without a sharp corner inside.
struct Run {
    std::vector<Vec2d> points;
    bool closed;
};

std::vector<Run> smoothRuns(const Outline& outline) {
    const std::vector<Vec2d>& p = outline.points;
    const size_t n = p.size();
    const double mostCos = std::cos(outline.creaseDeg * kPiD / 180.0);
    const auto isCorner = [&](size_t i) {
        if (!outline.closed && (i == 0 || i + 1 == n)) { return true; }
        const Vec2d before = p[i] - p[(i + n - 1) % n], after = p[(i + 1) % n] - p[i];
        return glm::dot(before, after) < mostCos * glm::length(before) * glm::length(after);
    };
    std::vector<size_t> corners;
    for (size_t i = 0; i < n; ++i) {
        if (isCorner(i)) { corners.push_back(i); }
    }
    if (corners.empty()) { return {{p, true}}; }
    std::vector<Run> runs;
    const size_t count = corners.size() - (outline.closed ? 0 : 1);
    for (size_t c = 0; c < count; ++c) {
        Run run{{}, false};
        const size_t end = c + 1 < corners.size() ? corners[c + 1] : corners[0] + n;
        for (size_t i = corners[c]; i <= end; ++i) {
            run.points.push_back(p[i % n]);
        }
        runs.push_back(std::move(run));
    }
    return runs;
}

/// Lengths from the first point to each; one more where the path is closed.
template <class Point>
std::vector<double> lengthsAlong(const std::vector<Point>& points, bool closed) {
    std::vector<double> lengths{0.0};
    for (size_t i = 1; i < points.size() + (closed ? 1 : 0); ++i) {
        lengths.push_back(lengths.back() + glm::distance(points[i % points.size()], points[i - 1]));
    }
    return lengths;
}

/// How far along the path each frame is, where the outline sticks out the farthest.
std::vector<double> pathLengths(const Outline& outline, const std::vector<Pose>& path, bool closedPath) {
    Vec2d far = outline.points.front();
    for (const Vec2d& p : outline.points) {
        if (glm::length(p) > glm::length(far)) { far = p; }
    }
    std::vector<Vec3d> places;
    places.reserve(path.size());
    for (const Pose& frame : path) {
        places.push_back(frame.at({far.x, far.y, 0.0}));
    }
    return lengthsAlong(places, closedPath);
}

Vec3d cellCentre(const Outline& outline) {
    Vec2d sum(0.0);
    for (const Vec2d& p : outline.points) {
        sum += p;
    }
    return Vec3d(sum / static_cast<double>(outline.points.size()), 0.0);
}

}  // namespace

Pose turned(const Vec3d& origin, double degrees) {
    const double angle = degrees * kPiD / 180.0;
    return {origin,
            {std::cos(angle), 0.0, -std::sin(angle)},
            {0.0, 1.0, 0.0},
            {std::sin(angle), 0.0, std::cos(angle)}};
}

Pose lying(const Vec3d& origin) { return {origin, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}}; }

Pose operator*(const Pose& outer, const Pose& inner) {
    const auto direction = [&](const Vec3d& d) { return outer.at(d) - outer.origin; };
    return {outer.at(inner.origin), direction(inner.x), direction(inner.y), direction(inner.z)};
}

Outline ellipse(double radiusX, double radiusY, int corners) {
    Outline outline{{}, true, 80.0};
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * kPiD * i / corners;
        outline.points.emplace_back(radiusX * std::cos(angle), radiusY * std::sin(angle));
    }
    return outline;
}

Outline bevelled(double width, double height, double bevel) {
    const double x = 0.5 * width, y = 0.5 * height, b = bevel;
    return {{{x, -y + b},
             {x, y - b},
             {x - b, y},
             {-x + b, y},
             {-x, y - b},
             {-x, -y + b},
             {-x + b, -y},
             {x - b, -y}},
            true};
}

MeshData sweep(const Outline& outline, const std::vector<Pose>& path, bool closedPath) {
    MeshData mesh;
    const std::vector<double> v = pathLengths(outline, path, closedPath);
    double start = 0.0;
    for (const Run& run : smoothRuns(outline)) {
        const std::vector<double> u = lengthsAlong(run.points, run.closed);
        const auto columns = static_cast<uint32_t>(u.size() - 1), rows = static_cast<uint32_t>(v.size() - 1);
        const MeshGrid grid{columns, rows, run.closed, closedPath, false};
        MeshData part;
        for (size_t row = 0; row < v.size(); ++row) {
            for (size_t column = 0; column < u.size(); ++column) {
                const Vec2d& p = run.points[column % run.points.size()];
                part.positions.emplace_back(path[row % path.size()].at({p.x, p.y, 0.0}));
                part.uvs.emplace_back(start + u[column], v[row]);
            }
        }
        addGridTriangles(grid, 0, &part);
        addGridNormals(grid, &part);
        add(&mesh, part);
        start += u.back();
    }
    return mesh;
}

MeshData lathe(const Outline& outline, int steps) {
    std::vector<Pose> path;
    for (int i = 0; i < steps; ++i) {
        const double angle = 2.0 * kPiD * i / steps;
        path.push_back({Vec3d(0.0),
                        {std::cos(angle), 0.0, std::sin(angle)},
                        {0.0, 1.0, 0.0},
                        {-std::sin(angle), 0.0, std::cos(angle)}});
    }
    return sweep(outline, path, true);
}

MeshData prism(const Outline& outline, double depth) {
    const Vec3d back(0.0), front(0.0, 0.0, depth);
    MeshData mesh = sweep(outline, {Pose{back}, Pose{front}});
    const auto n = static_cast<uint32_t>(outline.points.size());
    for (const bool isFront : {false, true}) {
        MeshData cap;
        const Vec3d offset = isFront ? front : back;
        cap.positions.emplace_back(cellCentre(outline) + offset);
        for (const Vec2d& p : outline.points) {
            cap.positions.emplace_back(Vec3d(p, 0.0) + offset);
        }
        for (const Vec3& p : cap.positions) {
            cap.uvs.emplace_back(p.x, p.y);
            cap.normals.emplace_back(0.0f, 0.0f, isFront ? 1.0f : -1.0f);
        }
        for (uint32_t i = 0; i < n; ++i) {
            const uint32_t a = 1 + i, b = 1 + (i + 1) % n;
            cap.indices.insert(cap.indices.end(), {0, isFront ? a : b, isFront ? b : a});
        }
        add(&mesh, cap);
    }
    return mesh;
}

MeshData roundedBox(const Vec3d& size, double radius, int steps) {
    const Vec3d half = 0.5 * size, inner = half - Vec3d(radius);
    const auto cells = static_cast<uint32_t>(2 * steps + 1);
    // Cells of equal angle along the rounded edges, one between them.
    const auto along1 = [&](uint32_t i, double most, double straight) {
        const bool upper = i > static_cast<uint32_t>(steps);
        const double step = upper ? i - steps - 1.0 : steps - static_cast<double>(i);
        const double place = straight + radius * std::tan(step / steps * kPiD / 4.0);
        return (upper ? 1.0 : -1.0) * std::min(place, most);
    };
    MeshData mesh;
    for (int side = 0; side < 6; ++side) {
        const int axis = side / 2, a = (axis + 1) % 3, b = (axis + 2) % 3;
        const double sign = side % 2 == 0 ? 1.0 : -1.0;
        MeshData face;
        for (uint32_t row = 0; row <= cells; ++row) {
            for (uint32_t column = 0; column <= cells; ++column) {
                Vec3d p;
                p[axis] = sign * half[axis];
                p[a] = sign * along1(column, half[a], inner[a]);
                p[b] = along1(row, half[b], inner[b]);
                const Vec3d core = glm::clamp(p, -inner, inner);
                const Vec3d normal = glm::normalize(p - core);
                face.positions.emplace_back(core + radius * normal);
                face.normals.emplace_back(normal);
                // Lengths along the longer side run along u, as wood's grain does.
                face.uvs.push_back(size[a] >= size[b] ? Vec2(p[a], p[b]) : Vec2(p[b], p[a]));
            }
        }
        addGridTriangles(MeshGrid{cells, cells, false, false, false}, 0, &face);
        add(&mesh, face);
    }
    return mesh;
}

std::vector<Pose> along(const std::vector<Vec3d>& points, const Vec3d& up, bool closed) {
    std::vector<Pose> frames;
    const size_t n = points.size();
    for (size_t i = 0; i < n; ++i) {
        const Vec3d& before = closed ? points[(i + n - 1) % n] : points[i == 0 ? 0 : i - 1];
        const Vec3d& after = closed ? points[(i + 1) % n] : points[std::min(i + 1, n - 1)];
        const Vec3d z = glm::normalize(after - before);
        const Vec3d x = glm::normalize(glm::cross(up, z));
        frames.push_back({points[i], x, glm::cross(z, x), z});
    }
    return frames;
}

MeshData tube(const std::vector<Vec3d>& points, double radius, int corners, bool closed) {
    Vec3d turn(0.0);  // of the plane that the points lie in, or across the line that they lie on
    for (size_t i = 2; i < points.size(); ++i) {
        turn += glm::cross(points[i - 1] - points[0], points[i] - points[0]);
    }
    if (glm::length(turn) < 1e-9) {
        const Vec3d d = points.back() - points.front();
        turn = std::abs(d.y) > 0.9 * glm::length(d) ? Vec3d(0.0, 0.0, 1.0) : Vec3d(0.0, 1.0, 0.0);
    }
    return sweep(ellipse(radius, radius, corners), along(points, glm::normalize(turn), closed), closed);
}

void add(MeshData* mesh, const MeshData& part, const Pose& frame) {
    const auto first = static_cast<uint32_t>(mesh->positions.size());
    for (size_t i = 0; i < part.positions.size(); ++i) {
        mesh->positions.emplace_back(frame.at(Vec3d(part.positions[i])));
        mesh->normals.emplace_back(frame.at(Vec3d(part.normals[i])) - frame.origin);
    }
    mesh->uvs.insert(mesh->uvs.end(), part.uvs.begin(), part.uvs.end());
    const bool isMirrored = glm::dot(glm::cross(frame.x, frame.y), frame.z) < 0.0;
    for (size_t i = 0; i < part.indices.size(); i += 3) {
        const uint32_t a = part.indices[i], b = part.indices[i + 1], c = part.indices[i + 2];
        mesh->indices.insert(mesh->indices.end(),
                             {first + a, first + (isMirrored ? c : b), first + (isMirrored ? b : c)});
    }
}

void addVaried(MeshData* mesh, MeshData part, const Pose& frame, uint64_t number) {
    Dice dice(hashCounter(7, number));
    const Vec2 offset(static_cast<float>(dice.next()) * 8.0f, static_cast<float>(dice.next()) * 8.0f);
    for (Vec2& uv : part.uvs) {
        uv += offset;
    }
    add(mesh, part, frame);
}

}  // namespace glint::examples
