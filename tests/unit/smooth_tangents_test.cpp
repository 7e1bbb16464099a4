// Tangents that highlights of meshes lie by: continuous over triangles, and only where they are asked for.
#include <cmath>

#include <gtest/gtest.h>

#include "engine/builders/material_table.h"
#include "engine/builders/scene_builder.h"
#include "engine/builders/tangent_builder.h"
#include "engine/kernels/intersect.h"
#include "engine/kernels/surface.h"
#include "tests/support/render_scene.h"
#include "tests/support/test_scenes.h"

namespace glint::test {
namespace {

constexpr int kSegments = 12;

/// A ring in z = 0 with u around it and v outwards, from radius 0.8 to 1; `turnsOver`: u runs back on the
/// second half.
MeshData ring(bool turnsOver = false) {
    MeshData mesh;
    for (int i = 0; i <= kSegments; ++i) {
        const float turn = static_cast<float>(i) / kSegments;
        const float u = turnsOver ? 0.5f - std::fabs(turn - 0.5f) : turn;
        for (const float radius : {0.8f, 1.0f}) {
            mesh.positions.push_back(radius *
                                     Vec3(std::cos(2.0f * kPi * turn), std::sin(2.0f * kPi * turn), 0.0f));
            mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
            mesh.uvs.emplace_back(u, radius);
        }
    }
    // The seam's ends are in one place to the last bit.
    for (int i = 0; i < 2; ++i) {
        mesh.positions[2 * kSegments + static_cast<size_t>(i)] = mesh.positions[static_cast<size_t>(i)];
    }
    for (uint32_t i = 0; i < 2 * kSegments; i += 2) {
        for (const uint32_t corner : {0u, 1u, 3u, 0u, 3u, 2u}) {
            mesh.indices.push_back(i + corner);
        }
    }
    return mesh;
}

Material brushed() {
    Material metal = diffuseMaterial(1.0f);
    metal.kind = MaterialKind::Conductor;
    metal.roughness.value = 0.1f;
    metal.crossRoughness.value = 0.4f;
    return metal;
}

SceneDescription sceneOf(const MeshData& mesh, const Material& material) {
    SceneDescription scene = emptyScene({0, 0, 4}, {0, 0, 0}, 40.0f, 16);
    addMeshObject(&scene, mesh, {}, material);
    scene.environment.color = Vec3(1.0f);
    return scene;
}

std::shared_ptr<const BuiltScene> build(const SceneDescription& scene, const BuiltScene* previous = nullptr,
                                        EditKind kinds = EditKind::Everything) {
    auto built =
        buildScene({std::make_shared<const SceneDescription>(scene), kinds}, previous, 1, nullptr, nullptr);
    EXPECT_TRUE(built) << built.error().message;
    return *built;
}

/// The largest angle, in degrees, between dpdu and the direction around the ring.
float largestError(const BuiltScene& built) {
    const SceneView view = built.view();
    float largest = 0.0f;
    for (int i = 0; i < 720; ++i) {
        const float angle = 2.0f * kPi * (static_cast<float>(i) + 0.3f) / 720.0f;
        const Vec3 outwards(std::cos(angle), std::sin(angle), 0.0f);
        const Ray ray{0.9f * outwards + Vec3(0.0f, 0.0f, 2.0f), Vec3(0.0f, 0.0f, -1.0f)};
        Hit hit;
        if (!intersect<kAllFeatures>(view, ray, &hit)) {
            ADD_FAILURE() << "no hit at " << angle;
            continue;
        }
        const SurfacePoint point = surfaceAt<kAllFeatures | kFeatureTangents>(view, ray, hit);
        const Vec3 along = glm::normalize(point.dpdu);
        const Vec3 around(-outwards.y, outwards.x, 0.0f);
        largest = std::fmax(largest, std::acos(std::fmin(std::fabs(glm::dot(along, around)), 1.0f)));
        EXPECT_NEAR(
            std::fabs(glm::dot(point.dpdu, point.dpdv)) / (glm::length(point.dpdu) * glm::length(point.dpdv)),
            0.0f, 0.3f);
    }
    return largest * (180.0f / kPi);
}

TEST(SmoothTangents, RunOnOverTriangles) {
    // Between vertices 30 degrees apart, chords and interpolation differ from the arc.
    EXPECT_LT(largestError(*build(sceneOf(ring(), brushed()))), 3.0f);
    EXPECT_LT(largestError(*build(sceneOf(ring(true), brushed()))), 3.0f) << "where u turns over";
    Material plain = brushed();
    plain.crossRoughness.value = -1.0f;
    EXPECT_GT(largestError(*build(sceneOf(ring(), plain))), 12.0f) << "as triangles have them";
}

TEST(SmoothTangents, AreMadeWhereHighlightsHaveADirection) {
    Material plain = brushed();
    plain.crossRoughness.value = -1.0f;
    const auto tangentsOf = [](const BuiltScene& built) { return built.view().geometry.meshes[0].tangents; };
    const SceneDescription isotropic = sceneOf(ring(), plain);
    const auto without = build(isotropic);
    EXPECT_EQ(tangentsOf(*without), nullptr);
    MeshData bare = ring();
    bare.normals.clear();
    EXPECT_EQ(tangentsOf(*build(sceneOf(bare, brushed()))), nullptr) << "facets stay facets";
    // An edit of the material makes them, and another one keeps them.
    SceneDescription scene = isotropic;
    scene.materials.back() = brushed();
    const auto with = build(scene, without.get(), EditKind::MaterialParameters);
    EXPECT_NE(tangentsOf(*with), nullptr);
    EXPECT_EQ(with->meshes, without->meshes);
    scene.materials.back().roughness.value = 0.2f;
    const auto again = build(scene, with.get(), EditKind::MaterialParameters);
    EXPECT_EQ(tangentsOf(*again), tangentsOf(*with));
    EXPECT_EQ(again->instances, with->instances);
}

/// Islands of textures that lie across one another stay apart.
TEST(SmoothTangents, DoNotMixAcrossTurnedSeams) {
    MeshData mesh;
    for (const float side : {-1.0f, 1.0f}) {
        const bool isTurned = side > 0.0f;
        for (const Vec2 corner : {Vec2(0, 0), Vec2(0, 1), Vec2(side, 0), Vec2(side, 1)}) {
            mesh.positions.emplace_back(corner.x, corner.y, 0.0f);
            mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
            mesh.uvs.push_back(isTurned ? Vec2(corner.y, corner.x) : corner);
        }
    }
    mesh.indices = {0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5};
    const std::vector<Vec3> tangents = smoothTangents(mesh);
    for (size_t i = 0; i < 8; ++i) {
        const Vec3 wanted = i < 4 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
        EXPECT_NEAR(std::fabs(glm::dot(tangents[i], wanted)), 1.0f, 1e-6f) << i;
    }
}

}  // namespace
}  // namespace glint::test
