// Triangulated polygons keep their area, their orientation and, where they are simple, cover each point once.
#include "engine/io/polygon.h"

#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/importer.h"

namespace glint {
namespace {

Vec3 triangleArea(const std::vector<Vec3>& corners, const uint32_t* t) {
    return 0.5f * glm::cross(corners[t[1]] - corners[t[0]], corners[t[2]] - corners[t[0]]);
}

Vec3 polygonArea(const std::vector<Vec3>& corners) {
    Vec3 sum(0.0f);
    for (size_t i = 1; i + 1 < corners.size(); ++i) {
        sum += 0.5f * glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    }
    return sum;
}

/// Triangles of a flat simple polygon: n - 2 of them, none turned over, areas adding up to the polygon's.
void expectCovers(const std::vector<Vec3>& corners, const char* what) {
    std::vector<uint32_t> triangles;
    ASSERT_TRUE(triangulatePolygon(corners, &triangles)) << what;
    ASSERT_EQ(triangles.size(), 3 * (corners.size() - 2)) << what;
    const Vec3 whole = polygonArea(corners);
    const float size = glm::length(whole);
    double sum = 0.0;
    for (size_t t = 0; t < triangles.size(); t += 3) {
        const Vec3 area = triangleArea(corners, &triangles[t]);
        EXPECT_GE(glm::dot(area, whole), -1e-6f * size * size)
            << what << ", triangle " << t / 3 << " is turned over";
        sum += static_cast<double>(glm::length(area));
    }
    EXPECT_NEAR(sum, static_cast<double>(size), 1e-5 * static_cast<double>(size)) << what;
}

/// The polygon from every first corner, on both sides, in several planes.
void expectCoversAlways(const std::vector<Vec2>& outline, const char* what) {
    const Vec3 axes[][2] = {
        {{1, 0, 0}, {0, 1, 0}}, {{0, 1, 0}, {0, 0, 1}}, {{0, 0, 1}, {1, 0, 0}}, {{1, 1, 0}, {-1, 1, 2}}};
    for (const auto& [u, v] : axes) {
        for (size_t first = 0; first < outline.size(); ++first) {
            std::vector<Vec3> corners;
            for (size_t i = 0; i < outline.size(); ++i) {
                const Vec2 p = outline[(first + i) % outline.size()];
                corners.push_back(p.x * u + p.y * v + Vec3(3.0f, -2.0f, 5.0f));
            }
            expectCovers(corners, what);
            std::reverse(corners.begin(), corners.end());
            expectCovers(corners, what);
        }
    }
}

TEST(Polygon, ConvexAndConcaveShapesAreCovered) {
    expectCoversAlways({{0, 0}, {4, 0}, {4, 3}, {0, 3}}, "rectangle");
    expectCoversAlways({{0, 0}, {4, 0}, {1, 1}, {0, 4}}, "concave quad (arrow head)");
    expectCoversAlways({{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 2}, {0, 2}}, "L");
    expectCoversAlways({{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}, "U");
    expectCoversAlways({{0, 0}, {1, 4}, {2, 0}, {3, 4}, {4, 0}, {4, 5}, {0, 5}}, "saw");
    expectCoversAlways({{0, 5}, {1, 1}, {5, 0}, {1, -1}, {0, -5}, {-1, -1}, {-5, 0}, {-1, 1}}, "star");
}

TEST(Polygon, StraightAndRepeatedCornersAreCovered) {
    expectCoversAlways({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {0, 3}}, "straight corners");
    expectCoversAlways({{0, 0}, {2, 0}, {4, 0}, {2, 3}}, "a triangle with a corner on its edge");
    expectCoversAlways({{0, 0}, {2, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {2, 5}, {0, 5}},
                       "L with straight corners");
    expectCoversAlways({{0, 0}, {4, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 4}}, "repeated corners");
    // A square with a square hole, joined by a bridge that is walked both ways.
    expectCoversAlways({{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}},
                       "keyhole");
}

TEST(Polygon, RandomSpikyPolygonsAreCovered) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> radius(0.1f, 5.0f);
    for (int round = 0; round < 200; ++round) {
        std::vector<Vec2> outline;
        const int n = 4 + round % 60;
        for (int i = 0; i < n; ++i) {
            const float angle = kTwoPi * static_cast<float>(i) / static_cast<float>(n);
            const float r = radius(random);
            outline.emplace_back(r * std::cos(angle), r * std::sin(angle));
        }
        std::vector<Vec3> corners;
        for (const Vec2& p : outline) {
            corners.emplace_back(p.x, p.y, 0.3f * p.x - 0.2f * p.y);
        }
        expectCovers(corners, "star-shaped");
    }
}

TEST(Polygon, SpiralOfThousandsOfCornersIsCovered) {
    std::vector<Vec3> corners;
    constexpr int kSteps = 2000;
    for (int i = 0; i <= kSteps; ++i) {
        const float angle = 0.05f * static_cast<float>(i);
        corners.emplace_back((1.0f + 0.1f * angle) * std::cos(angle), (1.0f + 0.1f * angle) * std::sin(angle),
                             0.0f);
    }
    for (int i = kSteps; i >= 0; --i) {
        const float angle = 0.05f * static_cast<float>(i);
        corners.emplace_back((1.3f + 0.1f * angle) * std::cos(angle), (1.3f + 0.1f * angle) * std::sin(angle),
                             0.0f);
    }
    expectCovers(corners, "spiral");
}

TEST(Polygon, HopelessPolygonsStillGiveTriangles) {
    const std::vector<std::vector<Vec3>> polygons = {
        {{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 4, 0}},                      // crosses itself
        {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}},           // a line
        {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}},                      // a point
        {{0, 3, 0}, {2, -3, 0}, {-3, 1, 0}, {3, 1, 0}, {-2, -3, 0}},       // a pentagram
        {{0, 0, 0}, {1e18f, 0, 0}, {1e18f, 1e18f, 0}, {0, 1e18f, 1e18f}},  // enormous
    };
    for (const std::vector<Vec3>& corners : polygons) {
        std::vector<uint32_t> triangles;
        ASSERT_TRUE(triangulatePolygon(corners, &triangles));
        EXPECT_EQ(triangles.size(), 3 * (corners.size() - 2));
        for (const uint32_t corner : triangles) {
            EXPECT_LT(corner, corners.size());
        }
    }
}

/// A bar with a saw's teeth.
std::vector<Vec3> saw(int teeth) {
    std::vector<Vec3> corners{{-1.0f, -2.0f, 0.0f}, {static_cast<float>(teeth + 1), -2.0f, 0.0f}};
    for (int i = teeth; i > 0; --i) {
        corners.emplace_back(static_cast<float>(i), i % 2 == 0 ? 1.0f : 0.0f, 0.0f);
    }
    return corners;
}

TEST(Polygon, ManyCornersAreFineUnlessTooManyAreReflex) {
    std::vector<uint32_t> triangles;
    // From about 20,000 on, rounded corners on a circle turn right here and there.
    for (const int corners : {20000, 80000}) {
        std::vector<Vec3> circle;
        for (int i = 0; i < corners; ++i) {
            const double angle = 6.283185307179586 * i / corners;
            circle.emplace_back(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)),
                                0.0f);
        }
        triangles.clear();
        EXPECT_TRUE(triangulatePolygon(circle, &triangles));
        EXPECT_EQ(triangles.size(), 3u * static_cast<size_t>(corners - 2));
    }
    triangles.clear();
    EXPECT_FALSE(triangulatePolygon(saw(40000), &triangles));
    EXPECT_TRUE(triangles.empty());
    // Three corners over and over turn left everywhere, and yet none of them is an ear for long.
    std::vector<Vec3> round;
    for (int i = 0; i < 300000; ++i) {
        round.emplace_back(i % 3 == 1 ? 1.0f : 0.0f, i % 3 == 2 ? 1.0f : 0.0f, 0.0f);
    }
    EXPECT_FALSE(triangulatePolygon(round, &triangles));
    EXPECT_TRUE(triangles.empty());
}

TEST(Polygon, AModelGoesWithoutTheFaceThatTakesTooLong) {
    std::string obj;
    const std::vector<Vec3> corners = saw(40000);
    std::string face = "f";
    std::string plyFace = std::to_string(corners.size());
    for (size_t i = 0; i < corners.size(); ++i) {
        obj += fmt::format("v {} {} 0\n", corners[i].x, corners[i].y);
        face += fmt::format(" {}", i + 1);
        plyFace += fmt::format(" {}", i);
    }
    std::string ply = obj;
    std::erase(ply, 'v');
    ply = fmt::format(
              "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
              "property float z\nelement face 2\nproperty list int int vertex_indices\nend_header\n",
              corners.size()) +
          ply + plyFace + "\n3 0 1 2\n";
    obj += face + "\nf 1 2 3\n";
    for (const auto& [name, text] : {std::pair("in.obj", obj), std::pair("in.ply", ply)}) {
        const Result<MeshFile> file = readMeshFile(text, name);
        ASSERT_TRUE(file) << file.error().format();
        EXPECT_EQ(file->parts[0].mesh->triangleCount(), 1u);
        EXPECT_THAT(file->warnings, testing::Contains(testing::HasSubstr("not convex are left out"))) << name;
    }
}

}  // namespace
}  // namespace glint
