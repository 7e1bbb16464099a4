// What tests of the pbrt importer share: a folder, and scenes from texts that must open.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "engine/builders/scene_validation.h"
#include "engine/io/scene_loader.h"
#include "tests/support/temp_folder.h"

namespace glint::test {

/// Packed as gzip has it.
inline std::string gzipped(const std::string& bytes) {
    constexpr int kGzip = 16 + MAX_WBITS, kMemory = 8;
    z_stream stream{};
    EXPECT_EQ(deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, kGzip, kMemory, Z_DEFAULT_STRATEGY), Z_OK);
    std::string out(deflateBound(&stream, bytes.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return out;
}

class PbrtTest : public testing::Test {
  protected:
    /// A camera that mirrors nothing, at (0, 0, 5), then the world.
    static constexpr const char* kRightHanded =
        "Scale -1 1 1 LookAt 0 0 5  0 0 0  0 1 0 Camera \"perspective\" ";

    static std::string sceneText(const std::string& world, const std::string& view = kRightHanded) {
        return view + "\nWorldBegin\n" + world + "\n";
    }
    SceneDescription load(const std::string& world, LoadOptions options = {}) {
        return loadText(sceneText(world), std::move(options));
    }
    SceneDescription loadText(const std::string& text, LoadOptions options = {}) {
        options.noStudio = true;
        auto scene = loadScene(folder.write("a.pbrt", text), options);
        EXPECT_TRUE(scene) << scene.error().format();
        if (!scene) { return {}; }
        const Status valid = validateScene(*scene, EditKind::Everything);
        EXPECT_TRUE(valid) << valid.error().format();
        return std::move(*scene);
    }
    std::string errorOf(const std::string& world) {
        const auto scene = loadScene(folder.write("bad.pbrt", sceneText(world)));
        return scene ? "no error" : scene.error().format();
    }
    Object onlyObject(const std::string& world) {
        const SceneDescription scene = load(world);
        keepWarnings(scene);
        EXPECT_EQ(scene.objects.size(), 1u);
        return scene.objects.empty() ? Object() : scene.objects[0];
    }
    /// The triangles of a shape, in the world.
    MeshData meshOf(const std::string& world) {
        const SceneDescription scene = load(world);
        keepWarnings(scene);
        EXPECT_EQ(scene.objects.size(), 1u);
        if (scene.objects.size() != 1 || scene.objects[0].shape != ShapeKind::Mesh) { return {}; }
        MeshData mesh = *scene.meshes[static_cast<size_t>(scene.objects[0].mesh)].data;
        for (Vec3& p : mesh.positions) {
            p = scene.objects[0].objectToWorld.point(p);
        }
        return mesh;
    }
    /// Of a sphere.
    Material materialOf(const std::string& directives) {
        const SceneDescription scene = load(directives + " Shape \"sphere\"");
        keepWarnings(scene);
        textures = scene.textures;
        return scene.objects.empty() ? Material()
                                     : scene.materials[static_cast<size_t>(scene.objects[0].material)];
    }
    /// But that nothing shines.
    void keepWarnings(const SceneDescription& scene) {
        warnings = scene.warnings;
        std::erase_if(warnings, [](const std::string& line) {
            return line.find("nothing shines") != std::string::npos;
        });
    }
    static void expectNear(const Vec3& a, const Vec3& b, float tolerance) {
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(a[c], b[c], tolerance) << c;
        }
    }

    TempFolder folder;
    std::vector<std::string> warnings;
    std::vector<Texture> textures;
};

}  // namespace glint::test
