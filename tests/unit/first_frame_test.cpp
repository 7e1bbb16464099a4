// What there is to be seen of a heavy scene while it is built.
#include "engine/render/first_frame.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "engine/builders/scene_builder.h"
#include "engine/render/render_session.h"
#include "tests/support/test_scenes.h"
#include "tests/support/torus_mesh.h"

namespace glint {
namespace {

constexpr double kPatience = 60.0;

SceneEdit openingOf(const SceneDescription& scene) {
    return {std::make_shared<SceneDescription>(scene), EditKind::Everything};
}

TEST(HeavyScene, OnlyWhatIsNewIsHeavy) {
    SceneDescription description = test::meshInstances();
    const size_t all = trianglesToBuild(description, nullptr);
    size_t triangles = 0;
    for (const Mesh& mesh : description.meshes) {
        triangles += mesh.data->triangleCount();
    }
    EXPECT_EQ(all, triangles);
    const auto built = buildScene(openingOf(description), nullptr, 1, nullptr, nullptr);
    ASSERT_TRUE(built.ok());
    EXPECT_EQ(trianglesToBuild(description, built->get()), 0u);
    description.options.accelerator = AcceleratorKind::KdTree;
    EXPECT_EQ(trianglesToBuild(description, built->get()), 0u) << "there is something to be seen already";
    auto other = std::make_shared<MeshData>(*description.meshes[0].data);
    other->uvs.assign(other->positions.size(), Vec2(0.5f));
    description.meshes[0].data = other;
    EXPECT_EQ(trianglesToBuild(description, built->get()), 0u) << "its structure stays";
    other = std::make_shared<MeshData>(*other);
    other->positions[0].x += 0.1f;
    description.meshes[0].data = other;
    EXPECT_EQ(trianglesToBuild(description, built->get()), other->triangleCount());
}

/// What ray casting shows of the scene at the frame's size, in the mean of 8 passes.
std::vector<float> castPicture(SceneDescription scene, const FilmSnapshot& like) {
    scene.resolution = {like.width, like.height};
    scene.options.integrator = IntegratorKind::RayCast;
    RenderSession session(makeCpuBackend(2), {.previews = false});
    session.request({.limits = {.passes = 8}});
    session.post(openingOf(scene));
    EXPECT_EQ(session.wait(kPatience), SessionState::Finished);
    return session.snapshot()->radiance;
}

/// The share of pixels of `a` that lie beyond what `b` has in the 3x3 pixels around: edges are
/// mixtures there.
double shareUnlike(const std::vector<float>& a, const std::vector<float>& b, int width, int height) {
    constexpr float kAlike = 0.02f;
    int unlike = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            Vec3 least(kInfinity), most(-kInfinity);
            for (int i = 0; i < 9; ++i) {
                const int ofX = std::clamp(x + i % 3 - 1, 0, width - 1);
                const int ofY = std::clamp(y + i / 3 - 1, 0, height - 1);
                const float* of = &b[static_cast<size_t>(3 * (ofY * width + ofX))];
                least = glm::min(least, Vec3(of[0], of[1], of[2]));
                most = glm::max(most, Vec3(of[0], of[1], of[2]));
            }
            const float* pixel = &a[static_cast<size_t>(3 * (y * width + x))];
            for (int c = 0; c < 3; ++c) {
                if (!(pixel[c] >= least[c] - kAlike && pixel[c] <= most[c] + kAlike)) {
                    ++unlike;
                    break;
                }
            }
        }
    }
    return static_cast<double>(unlike) / (static_cast<double>(width) * height);
}

double shareUnlike(const FilmSnapshot& frame, const std::vector<float>& image) {
    return std::max(shareUnlike(frame.radiance, image, frame.width, frame.height),
                    shareUnlike(image, frame.radiance, frame.width, frame.height));
}

std::shared_ptr<FilmSnapshot> frameOf(const SceneDescription& scene, int threads) {
    return drawFirstFrame(scene, threads, false);
}

/// Tori with normals and without, mirrored, coloured; a sphere and a vase; above a plane that goes on behind
/// the camera, all within a torus.
SceneDescription tori() {
    SceneDescription scene;
    scene.resolution = {640, 400};
    scene.camera.position = {0.0f, 1.0f, 4.0f};
    scene.camera.target = {0.2f, 0.5f, 0.0f};
    scene.camera.shift = {0.1f, -0.05f};
    scene.environment.color = Vec3(0.1f, 0.2f, 0.3f);
    scene.meshes.resize(3);
    scene.meshes[0].data = std::make_shared<const MeshData>(test::torus());
    auto flat = std::make_shared<MeshData>(test::torus());
    flat->normals.clear();
    scene.meshes[1].data = flat;
    auto colored = std::make_shared<MeshData>(test::torus());
    for (const Vec3& p : colored->positions) {
        colored->colors.push_back(0.5f + 0.3f * p);
    }
    scene.meshes[2].data = colored;
    const auto add = [&](ShapeKind shape, int mesh, const Affine& place, const Vec3& color) {
        scene.materials.emplace_back();
        scene.materials.back().color.value = color;
        Object object;
        object.shape = shape;
        object.mesh = mesh;
        object.objectToWorld = place;
        object.material = static_cast<int>(scene.materials.size()) - 1;
        scene.objects.push_back(object);
    };
    add(ShapeKind::Mesh, 0, rotate({1, 0, 0}, 0.7f), {0.9f, 0.3f, 0.2f});
    add(ShapeKind::Mesh, 1, translate({1.6f, 0.4f, -1}) * scale({-1.0f, 0.6f, 1.3f}), {0.2f, 0.8f, 0.3f});
    add(ShapeKind::Sphere, -1, translate({-1.5f, 1.2f, 0}) * scale(Vec3(0.6f)), {0.3f, 0.4f, 0.9f});
    add(ShapeKind::Mesh, 2, translate({1.2f, -0.6f, 1}) * scale(Vec3(0.4f)), Vec3(0.9f));
    scene.materials.back().emission.value = {0.1f, 0.05f, 0.0f};
    add(ShapeKind::Revolved, -1, translate({-1.2f, -1, 1}), {0.8f, 0.7f, 0.2f});
    scene.objects.back().profile = {{0.3f, 0.0f}, {0.6f, 0.4f}, {0.2f, 0.9f}};
    add(ShapeKind::Plane, -1, translate({0, -1, 0}) * rotate({1, 0, 0}, 0.5f * kPi), {0.6f, 0.6f, 0.5f});
    add(ShapeKind::Mesh, 0, translate({0, 1, 4}) * scale(Vec3(20)), {0.5f, 0.5f, 0.6f});
    scene.objects.back().frontOnly = true;
    return scene;
}

/// Silhouettes and the edges of facets take half of it, each object twice as much or more.
constexpr double kShareOfEdges = 0.02;

TEST(FirstFrame, ShowsWhatRayCastingShowsWithoutLamps) {
    SceneDescription scene = tori();
    for (const ProjectionKind kind : {ProjectionKind::Perspective, ProjectionKind::Orthographic}) {
        scene.camera.kind = kind;
        scene.camera.viewHeight = 4.0f;
        const auto frame = frameOf(scene, 2);
        ASSERT_TRUE(frame);
        EXPECT_LT(shareUnlike(*frame, castPicture(scene, *frame)), kShareOfEdges);
        EXPECT_EQ(frameOf(scene, 1)->radiance, frame->radiance) << "for any number of threads";
        for (Object& object : scene.objects) {
            object.frontOnly = !object.frontOnly;
        }
        const auto other = frameOf(scene, 2);
        const std::vector<float> cast = castPicture(scene, *other);
        EXPECT_LT(shareUnlike(*other, cast), kShareOfEdges);
        EXPECT_GT(shareUnlike(*frame, cast), 0.1);
    }
}

TEST(FirstFrame, DrawsTinyAndHugeScenes) {
    const auto frame = frameOf(tori(), 1);
    for (const float size : {1e-12f, 1e-6f, 1e6f, 1e12f}) {
        SceneDescription scene = tori();
        scene.camera.position *= size;
        scene.camera.target *= size;
        for (Object& object : scene.objects) {
            object.objectToWorld.linear *= size;
            object.objectToWorld.translation *= size;
        }
        const auto scaled = frameOf(scene, 1);
        ASSERT_TRUE(scaled) << size;
        EXPECT_LT(shareUnlike(*scaled, frame->radiance), 0.01) << size;
    }
}

TEST(FirstFrame, IsLeftOutWhereItWouldTakeLong) {
    SceneDescription scene = tori();
    scene.objects.resize(1);
    scene.objects.resize(8000, scene.objects[0]);
    EXPECT_FALSE(frameOf(scene, 1)) << "instances";
    scene = tori();
    scene.objects.resize(300, scene.objects[4]);
    ASSERT_EQ(scene.objects.back().shape, ShapeKind::Revolved);
    EXPECT_FALSE(frameOf(scene, 1)) << "turned profiles";
    scene = tori();
    auto layers = std::make_shared<MeshData>();
    for (uint32_t i = 0; i < 5000; ++i) {
        const float z = -0.001f * static_cast<float>(i);
        layers->positions.insert(layers->positions.end(), {{-9, -9, z}, {9, -9, z}, {0, 9, z}});
        layers->indices.insert(layers->indices.end(), {3 * i, 3 * i + 1, 3 * i + 2});
    }
    scene.meshes[0].data = layers;
    EXPECT_FALSE(frameOf(scene, 2)) << "triangles over each other";
    scene = tori();
    scene.objects[0].material = 100;
    EXPECT_FALSE(frameOf(scene, 1)) << "it is not valid";
    EXPECT_FALSE(drawFirstFrame(tori(), 1, true)) << "it was stopped";
}

}  // namespace
}  // namespace glint
