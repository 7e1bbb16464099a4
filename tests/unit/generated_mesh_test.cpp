// Procedural meshes: counts, orientation, watertightness, determinism, errors.
#include "engine/scene/generated_mesh.h"

#include <array>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glint {
namespace {

using Key = std::array<float, 3>;

Key key(const Vec3& p) { return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}; }

std::shared_ptr<const MeshData> make(std::string_view generator, uint32_t triangles, uint32_t seed = 0) {
    auto mesh = generateMesh({std::string(generator), triangles, seed});
    EXPECT_TRUE(mesh.ok());
    return mesh.value();
}

double signedVolume(const MeshData& mesh) {
    double volume = 0.0;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.positions[mesh.indices[i]];
        const glm::dvec3 b = mesh.positions[mesh.indices[i + 1]];
        const glm::dvec3 c = mesh.positions[mesh.indices[i + 2]];
        volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return volume;
}

/// Edges that are not met by exactly one triangle from each direction, by position.
size_t openEdges(const MeshData& mesh) {
    std::map<std::pair<Key, Key>, int> balance;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        for (size_t k = 0; k < 3; ++k) {
            const Key a = key(mesh.positions[mesh.indices[i + k]]);
            const Key b = key(mesh.positions[mesh.indices[i + (k + 1) % 3]]);
            if (a < b) {
                ++balance[{a, b}];
            } else {
                --balance[{b, a}];
            }
        }
    }
    size_t open = 0;
    for (const auto& [edge, count] : balance) {
        open += count != 0 ? 1 : 0;
    }
    return open;
}

TEST(GeneratedMesh, MeetsTheCountWithinFivePercentFromAThousandOn) {
    for (std::string_view name : meshGeneratorNames()) {
        for (uint32_t wanted : {1000u, 12'345u, 200'000u}) {
            const auto mesh = make(name, wanted);
            EXPECT_NEAR(mesh->triangleCount(), wanted, 0.05 * wanted) << name;
        }
    }
}

TEST(GeneratedMesh, HasNormalsAndUvsForEveryVertexAndValidIndices) {
    for (std::string_view name : meshGeneratorNames()) {
        const auto mesh = make(name, 5000);
        ASSERT_EQ(mesh->normals.size(), mesh->positions.size());
        ASSERT_EQ(mesh->uvs.size(), mesh->positions.size());
        for (uint32_t index : mesh->indices) {
            ASSERT_LT(index, mesh->positions.size());
        }
        for (const Vec3& n : mesh->normals) {
            EXPECT_NEAR(glm::length(n), 1.0f, 1e-5f) << name;
        }
    }
}

TEST(GeneratedMesh, NormalsLieOnTheFrontOfTheirTriangles) {
    for (std::string_view name : meshGeneratorNames()) {
        const auto mesh = make(name, 50'000);
        size_t behind = 0;
        for (size_t i = 0; i < mesh->indices.size(); i += 3) {
            const uint32_t* corner = &mesh->indices[i];
            const glm::dvec3 a = mesh->positions[corner[0]];
            const glm::dvec3 n = glm::cross(glm::dvec3(mesh->positions[corner[1]]) - a,
                                            glm::dvec3(mesh->positions[corner[2]]) - a);
            for (int k = 0; k < 3; ++k) {
                behind += glm::dot(n, glm::dvec3(mesh->normals[corner[k]])) <= 0.0 ? 1 : 0;
            }
        }
        EXPECT_EQ(behind, 0u) << name;
    }
}

TEST(GeneratedMesh, ClosedShapesAreWatertightAndFaceOutwards) {
    for (std::string_view name : {"blob", "cube", "ring", "sphere", "torus-knot"}) {
        for (uint32_t wanted : {12u, 500u, 20'001u}) {
            const auto mesh = make(name, wanted, 3);
            EXPECT_EQ(openEdges(*mesh), 0u) << name << " " << wanted;
            EXPECT_GT(signedVolume(*mesh), 0.0) << name << " " << wanted;
        }
    }
    EXPECT_NEAR(signedVolume(*make("sphere", 200'000)), 4.0 / 3.0 * 3.14159265, 1e-3);
    EXPECT_NEAR(signedVolume(*make("cube", 1200)), 8.0, 1e-6);
}

TEST(GeneratedMesh, DependsOnNothingButItsSource) {
    EXPECT_EQ(make("blob", 5000, 1)->positions, make("blob", 5000, 1)->positions);
    EXPECT_NE(make("blob", 5000, 1)->positions, make("blob", 5000, 2)->positions);
}

TEST(GeneratedMesh, RefusesUnknownGeneratorsAndCountsOutOfRange) {
    auto mesh = generateMesh({"torus-knto", 1000});
    ASSERT_FALSE(mesh.ok());
    EXPECT_THAT(mesh.error().message, testing::HasSubstr("torus-knot"));
    EXPECT_FALSE(generateMesh({"cube", 3}).ok());
    EXPECT_FALSE(generateMesh({"cube", 4'000'000'000u}).ok());
}

}  // namespace
}  // namespace glint
