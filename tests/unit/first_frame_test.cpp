// What there is to be seen of a heavy scene while it is built, and that the picture after it is as without.
#include "engine/render/first_frame.h"

#include <atomic>
#include <thread>

#include <gtest/gtest.h>

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

/// The share of pixels in which the two differ by more than a hundredth: edges only.
double shareThatDiffers(const std::vector<float>& a, const std::vector<float>& b) {
    size_t different = 0;
    for (size_t i = 0; i < a.size(); i += 3) {
        bool differs = false;
        for (size_t c = i; c < i + 3; ++c) {
            differs |= !(std::fabs(a[c] - b[c]) <= 0.01f);
        }
        different += differs;
    }
    return 3.0 * static_cast<double>(different) / static_cast<double>(a.size());
}

/// Tori in a box that goes on behind the camera: with normals and without, mirrored, seen from inside.
SceneDescription tori() {
    SceneDescription scene;
    scene.resolution = {640, 400};
    scene.camera.position = {0.0f, 1.0f, 4.0f};
    scene.camera.target = {0.2f, 0.5f, 0.0f};
    scene.camera.shift = {0.1f, -0.05f};
    scene.environment.color = Vec3(0.1f, 0.2f, 0.3f);
    scene.meshes.resize(2);
    scene.meshes[0].data = std::make_shared<const MeshData>(test::torus());
    auto flat = std::make_shared<MeshData>(test::torus());
    flat->normals.clear();
    scene.meshes[1].data = flat;
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
    add(ShapeKind::Rectangle, -1, translate({0, -1, 0}) * rotate({1, 0, 0}, 0.5f * kPi) * scale(Vec3(12)),
        {0.6f, 0.6f, 0.5f});
    add(ShapeKind::Mesh, 0, translate({0, 1, 4}) * scale(Vec3(20)), {0.5f, 0.5f, 0.6f});
    scene.objects.back().frontOnly = true;
    return scene;
}

TEST(FirstFrame, ShowsWhatRayCastingShowsWithoutLamps) {
    SceneDescription scene = tori();
    for (const ProjectionKind kind : {ProjectionKind::Perspective, ProjectionKind::Orthographic}) {
        scene.camera.kind = kind;
        scene.camera.viewHeight = 4.0f;
        const auto frame = drawFirstFrame(scene, 2);
        ASSERT_TRUE(frame);
        const std::vector<float> cast = castPicture(scene, *frame);
        ASSERT_EQ(frame->radiance.size(), cast.size());
        EXPECT_LT(shareThatDiffers(frame->radiance, cast), 0.1);
        EXPECT_EQ(drawFirstFrame(scene, 1)->radiance, frame->radiance) << "for any number of threads";
        for (Object& object : scene.objects) {
            object.frontOnly = !object.frontOnly;
        }
        EXPECT_LT(shareThatDiffers(drawFirstFrame(scene, 2)->radiance, castPicture(scene, *frame)), 0.1);
        EXPECT_GT(shareThatDiffers(drawFirstFrame(scene, 2)->radiance, frame->radiance), 0.1);
    }
}

TEST(FirstFrame, IsLeftOutWhereInstancesMakeItLong) {
    SceneDescription scene = tori();
    scene.objects.resize(1);
    scene.objects.resize(8000, scene.objects[0]);
    EXPECT_FALSE(drawFirstFrame(scene, 1));
    scene = tori();
    scene.objects[0].material = 100;
    EXPECT_FALSE(drawFirstFrame(scene, 1)) << "it cannot be built";
}

/// A session whose structures are not built before `mayBuild`.
struct HeldSession {
    std::atomic<bool> mayBuild{false};
    std::unique_ptr<RenderSession> session;

    explicit HeldSession(bool previews) {
        SessionOptions options;
        options.previews = previews;
        options.heavyTriangles = 1;
        options.build = [this](const SceneEdit& edit, const BuiltScene* previous, int threads,
                               const std::atomic<bool>* stop, BuildReport* report) {
            while (!mayBuild && !*stop) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            return buildScene(edit, previous, threads, stop, report);
        };
        session = std::make_unique<RenderSession>(makeCpuBackend(2), options);
        session->request({.limits = {.passes = 4}});
    }
};

std::shared_ptr<const FilmSnapshot> firstSnapshot(const RenderSession& session) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(kPatience);
    while (!session.snapshot() && std::chrono::steady_clock::now() < end) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return session.snapshot();
}

TEST(FirstFrame, IsShownWhileTheSceneIsBuilt) {
    HeldSession held(true);
    SceneDescription scene = test::meshInstances();
    scene.resolution = {160, 96};
    const EditTicket ticket = held.session->post(openingOf(scene));
    const auto frame = firstSnapshot(*held.session);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->integrator, IntegratorKind::RayCast);
    EXPECT_EQ(frame->ticket, ticket);
    EXPECT_EQ(frame->width, 80);
    EXPECT_EQ(frame->previewScale, 2) << "not taken for the answer";
    EXPECT_EQ(held.session->status().state, SessionState::Building);
    double least = kInfinity, most = 0.0;
    for (const float value : frame->radiance) {
        least = std::min(least, double{value});
        most = std::max(most, double{value});
    }
    EXPECT_LT(least, most) << "there is something to be seen";
    held.mayBuild = true;
    ASSERT_EQ(held.session->wait(kPatience), SessionState::Finished);
    EXPECT_EQ(held.session->snapshot()->integrator, scene.options.integrator);
    EXPECT_EQ(held.session->snapshot()->previewScale, 1);
}

TEST(FirstFrame, ChangesNoBitOfThePicture) {
    SceneDescription scene = test::meshInstances();
    HeldSession held(true);
    held.mayBuild = true;
    held.session->post(openingOf(scene));
    RenderSession plain(makeCpuBackend(2), {});
    plain.request({.limits = {.passes = 4}});
    plain.post(openingOf(scene));
    ASSERT_EQ(held.session->wait(kPatience), SessionState::Finished);
    ASSERT_EQ(plain.wait(kPatience), SessionState::Finished);
    EXPECT_EQ(held.session->snapshot()->radiance, plain.snapshot()->radiance);
    EXPECT_EQ(held.session->status().counters.meshBuilds, plain.status().counters.meshBuilds);
}

TEST(FirstFrame, BatchesDoWithoutIt) {
    HeldSession held(false);
    held.session->post(openingOf(test::meshInstances()));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_FALSE(held.session->snapshot());
    held.mayBuild = true;
    EXPECT_EQ(held.session->wait(kPatience), SessionState::Finished);
}

TEST(FirstFrame, IsGivenUpForAnotherScene) {
    HeldSession held(true);
    held.session->post(openingOf(test::meshInstances()));
    ASSERT_TRUE(firstSnapshot(*held.session));
    SceneDescription second = test::meshInstances();
    second.resolution = {48, 32};
    const EditTicket ticket = held.session->post(openingOf(second));
    held.mayBuild = true;
    ASSERT_EQ(held.session->wait(kPatience), SessionState::Finished);
    EXPECT_EQ(held.session->snapshot()->ticket, ticket);
    EXPECT_EQ(held.session->snapshot()->width, 48);
}

}  // namespace
}  // namespace glint
