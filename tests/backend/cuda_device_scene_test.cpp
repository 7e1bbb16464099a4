// The uploaded scene: every pointer leads to a copy on the device, an edit copies what it changed and no
// more, and the memory that is held is the memory that was taken.
#include <gtest/gtest.h>

#if GLINT_HAS_CUDA

#include "cuda/device_scene.h"
#include "cuda/scene_arrays.h"
#include "engine/builders/mesh_builder.h"
#include "engine/builders/scene_builder.h"
#include "tests/support/host_device.h"
#include "tests/support/test_scenes.h"

namespace glint {
namespace {

using test::HostDevice;
using test::HostDeviceControl;

std::shared_ptr<const BuiltScene> build(const SceneDescription& description,
                                        EditKind kinds = EditKind::Everything,
                                        const BuiltScene* previous = nullptr) {
    const SceneEdit edit{std::make_shared<SceneDescription>(description), kinds};
    auto scene = buildScene(edit, previous, 0, nullptr, nullptr);
    EXPECT_TRUE(scene) << scene.error().message;
    return *scene;
}

/// Every kind of array in one scene; its mesh is large enough for blocks of its own, and shines in
/// one instance.
SceneDescription fullScene() {
    SceneDescription scene = test::allMaterials();
    const SceneDescription meshes = test::meshInstances();
    Mesh mesh;
    mesh.name = "large";
    mesh.data = test::bumpySphere(60, 120, true);
    scene.meshes.push_back(mesh);
    scene.environmentImages = meshes.environmentImages;
    scene.environment = meshes.environment;
    Object object = meshes.objects.front();
    object.material = 0;
    object.mesh = 0;
    scene.objects.push_back(object);
    Material emitter = scene.materials.front();
    emitter.emission.value = Vec3(1.0f);
    scene.materials.push_back(emitter);
    object.material = static_cast<int>(scene.materials.size()) - 1;
    object.objectToWorld = translate(Vec3(0.0f, 5.0f, 0.0f));
    scene.objects.push_back(object);
    return scene;
}

struct Upload {
    std::shared_ptr<HostDeviceControl> control = std::make_shared<HostDeviceControl>();
    HostDevice device{control};
    DeviceScene scene{device};
};

struct ArrayAt {
    const void* data;
    size_t bytes;
};

/// All arrays of a scene in the order of scene_arrays.h.
std::vector<ArrayAt> arraysOf(SceneView view) {
    std::vector<ArrayAt> arrays;
    const auto collect = [&](const auto* pointer, size_t count) {
        const bool none = pointer == nullptr || count == 0;
        arrays.push_back({none ? nullptr : pointer, none ? 0 : count * sizeof(*pointer)});
    };
    for (uint32_t i = 0; i < view.geometry.meshes.count; ++i) {
        MeshView mesh = view.geometry.meshes[i];
        forEachArray(mesh, collect);
    }
    for (uint32_t i = 0; i < view.textures.count; ++i) {
        TextureView texture = view.textures[i];
        forEachArray(texture, collect);
    }
    forEachArray(view, collect);
    return arrays;
}

TEST(CudaDeviceScene, EveryArrayIsCopiedAndEveryPointerLeadsToItsCopy) {
    Upload upload;
    const auto built = build(fullScene());
    ASSERT_TRUE(upload.scene.update(built));
    const std::vector<ArrayAt> host = arraysOf(built->view());
    const std::vector<ArrayAt> device = arraysOf(upload.scene.view());
    ASSERT_EQ(host.size(), device.size());
    size_t arrays = 0;
    for (size_t i = 0; i < host.size(); ++i) {
        ASSERT_EQ(host[i].bytes, device[i].bytes) << i;
        if (host[i].bytes == 0) { continue; }
        ++arrays;
        EXPECT_TRUE(upload.control->holds(device[i].data, device[i].bytes)) << i;
        EXPECT_EQ(reinterpret_cast<uintptr_t>(device[i].data) % Device::kArrayAlignment, 0u) << i;
        EXPECT_EQ(std::memcmp(host[i].data, device[i].data, host[i].bytes), 0) << i;
    }
    EXPECT_GE(arrays, 20u) << "the scene was meant to have every kind of array";
    const SceneView view = upload.scene.view();
    EXPECT_TRUE(
        upload.control->holds(view.geometry.meshes.data, view.geometry.meshes.count * sizeof(MeshView)));
    EXPECT_TRUE(upload.control->holds(view.textures.data, view.textures.count * sizeof(TextureView)));
}

TEST(CudaDeviceScene, TheListedLengthsAreTheBuildersOwn) {
    const auto built = build(fullScene());
    const BuiltMesh& mesh = *built->meshes.at(0);
    MeshView view = mesh.view();
    size_t acceleration = 0;
    forEachArray(view, [&](const auto* pointer, size_t count) {
        const void* array = pointer;
        if (array == view.accelerator.data) { EXPECT_EQ(count, mesh.accelerator.view.bytes); }
        if (array == mesh.clusters.data()) { EXPECT_EQ(count, mesh.clusters.size()); }
        if (array == mesh.clusterPrimitives.data()) { EXPECT_EQ(count, mesh.clusterPrimitives.size()); }
        const bool isVertexData = array == view.positions || array == view.indices || array == view.normals ||
                                  array == view.uvs || array == view.colors || array == view.tangents ||
                                  array == view.ownTangents;
        if (!isVertexData) { acceleration += count * sizeof(*pointer); }
    });
    EXPECT_EQ(acceleration, mesh.accelerationBytes());
}

TEST(CudaDeviceScene, ACameraEditCopiesNothing) {
    Upload upload;
    SceneDescription description = fullScene();
    const auto first = build(description);
    ASSERT_TRUE(upload.scene.update(first));
    const HostDeviceControl before = *upload.control;
    description.camera.position.x += 1.0f;
    ASSERT_TRUE(upload.scene.update(build(description, EditKind::Camera, first.get())));
    EXPECT_EQ(upload.control->uploads, before.uploads);
    EXPECT_EQ(upload.control->allocations, before.allocations);
    EXPECT_EQ(upload.scene.lastUpload().arraysCopied, 0u);
    EXPECT_EQ(upload.scene.view().camera.position.x, description.camera.position.x);
}

TEST(CudaDeviceScene, AMaterialEditCopiesTheMaterialsAndKeepsTheRest) {
    Upload upload;
    SceneDescription description = fullScene();
    const auto first = build(description);
    ASSERT_TRUE(upload.scene.update(first));
    const SceneView before = upload.scene.view();
    const UploadReport whole = upload.scene.lastUpload();
    description.materials[1].color.value = Vec3(0.11f);
    const auto second = build(description, EditKind::MaterialParameters, first.get());
    ASSERT_TRUE(upload.scene.update(second));
    const SceneView now = upload.scene.view();
    EXPECT_EQ(now.materials[1].color.x, 0.11f);
    EXPECT_EQ(now.geometry.topLevel.data, before.geometry.topLevel.data);
    EXPECT_EQ(now.lights.environment.texels, before.lights.environment.texels);
    const UploadReport& report = upload.scene.lastUpload();
    EXPECT_EQ(report.arraysCopied, 1u);
    EXPECT_EQ(report.bytesCopied, now.materials.count * sizeof(MaterialData));
    EXPECT_EQ(report.bytesKept + report.bytesCopied, whole.bytesCopied);
}

TEST(CudaDeviceScene, ATransformCopiesInstancesAndLightsButNoMesh) {
    Upload upload;
    SceneDescription description = fullScene();
    const auto first = build(description);
    ASSERT_TRUE(upload.scene.update(first));
    const MeshView meshBefore = upload.scene.view().geometry.meshes[0];
    const float* texelsBefore = upload.scene.view().lights.environment.texels;
    description.objects.back().objectToWorld.translation.y += 1.0f;
    ASSERT_TRUE(upload.scene.update(build(description, EditKind::ObjectTransform, first.get())));
    const SceneView now = upload.scene.view();
    EXPECT_EQ(now.geometry.meshes[0].accelerator.data, meshBefore.accelerator.data);
    EXPECT_EQ(now.geometry.meshes[0].positions, meshBefore.positions);
    EXPECT_EQ(now.lights.environment.texels, texelsBefore);
    EXPECT_EQ(now.geometry.instances[now.geometry.instances.count - 1].objectToWorld.translation.y,
              description.objects.back().objectToWorld.translation.y);
}

TEST(CudaDeviceScene, MemoryHeldIsMemoryTaken) {
    Upload upload;
    SceneDescription description = fullScene();
    auto scene = build(description);
    ASSERT_TRUE(upload.scene.update(scene));
    EXPECT_EQ(upload.scene.bytes(), upload.control->taken());
    const size_t full = upload.scene.bytes();
    EXPECT_GE(full, upload.scene.lastUpload().bytesCopied);

    for (int i = 0; i < 20; ++i) {
        description.materials[1].color.value = Vec3(0.01f * static_cast<float>(i));
        scene = build(description, EditKind::MaterialParameters, scene.get());
        ASSERT_TRUE(upload.scene.update(scene));
        EXPECT_EQ(upload.scene.bytes(), upload.control->taken());
    }
    EXPECT_LE(upload.scene.bytes(), full + 64 * 1024) << "edits must not pile up";

    ASSERT_TRUE(upload.scene.update(build(test::cornellBox())));
    EXPECT_EQ(upload.scene.bytes(), upload.control->taken());
    EXPECT_LT(upload.scene.bytes(), full / 4) << "the large mesh must be gone";
}

TEST(CudaDeviceScene, ASceneThatDoesNotFitIsAnErrorBeforeAnythingIsTaken) {
    const auto large = build(fullScene());
    Upload upload;
    ASSERT_TRUE(upload.scene.update(large));
    Upload small;
    small.control->memoryBytes = upload.scene.bytes() - 1;
    const Status failed = small.scene.update(large);
    ASSERT_FALSE(failed);
    EXPECT_NE(failed.error().message.find("MiB"), std::string::npos) << failed.error().message;
    EXPECT_EQ(small.control->allocations, 0);
    EXPECT_TRUE(small.scene.empty());
    EXPECT_EQ(small.scene.bytes(), 0u);
    EXPECT_TRUE(small.scene.update(build(test::cornellBox()))) << "a smaller scene must still fit";
    small.control->memoryBytes = upload.scene.bytes();
    EXPECT_TRUE(small.scene.update(large)) << "what it said it needs must be enough";
}

}  // namespace
}  // namespace glint

#else
TEST(CudaDeviceScene, NotBuilt) { GTEST_SKIP() << "this build has no CUDA back end (GLINT_CUDA)"; }
#endif
