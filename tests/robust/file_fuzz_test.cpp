// Valid files with bytes changed, cut off or repeated at random (fixed seeds): loaders return a mesh or
// picture that keeps its promises, or an error with a message. Run under the sanitizers, this is what finds
// wild reads.
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "engine/io/exr_io.h"
#include "engine/io/image_io.h"
#include "engine/io/mesh_normals.h"
#include "engine/io/mitsuba_serialized.h"
#include "engine/io/obj_loader.h"
#include "engine/io/ply_loader.h"
#include "engine/render/checkpoint.h"
#include "tests/support/capture.h"
#include "tests/support/mitsuba_files.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::captureOf;
using test::TempFolder;

constexpr int kRounds = 400;

std::string mutated(std::string bytes, std::mt19937& random) {
    const auto below = [&random](size_t limit) { return limit == 0 ? 0 : random() % limit; };
    switch (random() % 5) {
        case 0:
            return bytes.substr(0, below(bytes.size()));
        case 1: {
            const size_t at = below(bytes.size());
            return bytes.insert(at, bytes.substr(below(bytes.size()), below(64)));
        }
        case 2:
            return bytes.erase(below(bytes.size()), below(32));
        default:
            break;
    }
    for (size_t changes = 1 + below(3); changes > 0; --changes) {
        // Half of the changes stay within the file's own characters, so that more of them get past the
        // first checks.
        bytes[below(bytes.size())] =
            random() % 2 == 0 ? static_cast<char>(random()) : bytes[below(bytes.size())];
    }
    return bytes;
}

void expectSoundMesh(const MeshData& mesh) {
    for (const uint32_t index : mesh.indices) {
        ASSERT_LT(index, mesh.positions.size());
    }
    for (const Vec3& p : mesh.positions) {
        ASSERT_TRUE(isFinite(p));
    }
    EXPECT_TRUE(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size());
    EXPECT_TRUE(mesh.uvs.empty() || mesh.uvs.size() == mesh.positions.size());
    EXPECT_TRUE(mesh.colors.empty() || mesh.colors.size() == mesh.positions.size());
    EXPECT_TRUE(mesh.tangents.empty() || mesh.tangents.size() == mesh.positions.size());
    EXPECT_EQ(mesh.indices.size() % 3, 0u);
}

/// How many of the mutated files still loaded. `load` returns an error, or nothing after checking what
/// it loaded.
int fuzz(const char* name, const std::string& good, uint32_t seed,
         const std::function<std::optional<Error>(const std::string& path)>& load) {
    const TempFolder folder;
    const std::optional<Error> goodError = load(folder.write(name, good));
    EXPECT_FALSE(goodError.has_value()) << goodError->format();
    std::mt19937 random(seed);
    int loaded = 0;
    for (int round = 0; round < kRounds; ++round) {
        const std::optional<Error> error = load(folder.write(name, mutated(good, random)));
        loaded += error ? 0 : 1;
        if (error) {
            EXPECT_FALSE(error->message.empty());
            EXPECT_FALSE(error->place.file.empty());
            EXPECT_FALSE(error->format().empty());
        }
    }
    return loaded;
}

std::optional<Error> checkSound(Result<MeshFile> file, const std::string& path) {
    if (!file) { return file.error(); }
    completeNormals(path, &*file);
    EXPECT_FALSE(file->parts.empty());
    for (const MeshPart& part : file->parts) {
        expectSoundMesh(*part.mesh);
        EXPECT_LT(part.material, static_cast<int>(file->materials.size()));
    }
    return std::nullopt;
}

std::optional<Error> loadSoundObj(const std::string& path) { return checkSound(loadObj(path), path); }

TEST(Fuzz, Obj) {
    const std::string good =
        "# a comment\nmtllib a.mtl\no thing\nv 0 0 0\nv 1.5 0 0\nv 1 1e0 0\nv -0.25 1 0 1 0 0\nv 0.5 0.5 2\n"
        "vt 0 0\nvt 1 0.5\nvn 0 0 1\nvn 1 0 0\nusemtl red\nf 1/1/1 2/2/1 3/1/2 4\nf -1 -2 -3\ng more\ns 1\n"
        "usemtl blue\nf 1//1 \\\n2//2 5//1\nf 1 2 3 4 5\n";
    const int loaded = fuzz("a.obj", good, 1, loadSoundObj);
    EXPECT_GT(loaded,
              kRounds / 40);  // otherwise the mutations are too coarse to test anything but the first check
}

TEST(Fuzz, Mtl) {
    const std::string good =
        "newmtl red\nKa 0 0 0\nKd 1 0.5 0.25\nKs 0.5 0.5 0.5\nKe 0 0 0\nNs 100\nNi 1.5\nd 1\nillum 2\n"
        "map_Kd -s 2 2 1 -o 0.5 0 0 -clamp on -type sphere -imfchan r none.png\nnewmtl blue\nTr 0.9\nTf 1 1 "
        "1\n"
        "map_Bump -bm 2 none.png\nPr 0.5\nunknown 1 2 3\n";
    const int loaded = fuzz("a.mtl", good, 2, [](const std::string& path) {
        const std::string obj = path.substr(0, path.size() - 3) + "obj";
        std::ofstream(obj)
            << "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 2 3\n";
        return loadSoundObj(obj);
    });
    EXPECT_GT(loaded, kRounds / 40);
}

Result<MeshFile> readPly(const std::string& path) { return parsePly(TempFolder::read(path), path); }

std::optional<Error> loadSoundPly(const std::string& path) { return checkSound(readPly(path), path); }

TEST(Fuzz, PlyText) {
    const std::string good =
        "ply\nformat ascii 1.0\ncomment x\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
        "float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 2\n"
        "property list uchar int vertex_indices\nproperty list uchar float texcoord\nelement tristrips 1\n"
        "property list uchar int vertex_indices\nelement rest 1\nproperty list uchar int items\nend_header\n"
        "0 0 0 255 0 0\n1 0 0 0 255 0\n1 1 0 0 0 255\n0 1 0 9 9 9\n4 0 1 2 3 8 0 0 1 0 1 1 0 1\n3 0 1 2 0\n5 "
        "0 1 2 -1 3\n2 7 7\n";
    EXPECT_GT(fuzz("a.ply", good, 3, loadSoundPly), kRounds / 40);
}

TEST(Fuzz, PlyBinary) {
    for (const bool big : {false, true}) {
        std::string good = std::string("ply\nformat ") +
                           (big ? "binary_big_endian" : "binary_little_endian") +
                           " 1.0\nelement vertex 20\nproperty float x\nproperty float y\nproperty float z\n"
                           "element face 40\nproperty list uchar ushort vertex_indices\nend_header\n";
        for (int i = 0; i < 60; ++i) {  // 1, 2 or 0.5, depending on the last bits: any pattern will do
            const char float32[4] = {'\x3f', static_cast<char>(i % 3 == 0 ? 0x80 : 0x00), 0, 0};
            for (int b = 0; b < 4; ++b) {
                good += float32[big ? b : 3 - b];
            }
        }
        for (int face = 0; face < 40; ++face) {
            const int corners = 3 + face % 3;
            good += static_cast<char>(corners);
            for (int c = 0; c < corners; ++c) {
                const char index = static_cast<char>((face + 7 * c) % 20);
                good += big ? std::string{'\0', index} : std::string{index, '\0'};
            }
        }
        EXPECT_GT(fuzz("a.ply", good, 4, loadSoundPly), kRounds / 40);
    }
}

TEST(Fuzz, Serialized) {
    const std::string good =
        test::serializedFile(4, {test::serializedTriangle<float>(0x1003, std::string("a\0", 2), 1.0f),
                                 test::serializedTriangle<double>(0x2003, std::string("b\0", 2), 2.0f)});
    const int loaded = fuzz("a.serialized", good, 9, [](const std::string& path) -> std::optional<Error> {
        const auto mesh = parseSerialized(TempFolder::read(path), path, 1);
        if (!mesh) { return mesh.error(); }
        expectSoundMesh(*mesh->mesh);
        return std::nullopt;
    });
    EXPECT_GT(loaded, kRounds / 40);
}

std::optional<Error> loadSoundImage(const std::string& path) {
    const Result<SceneImage> image = loadImage(path);
    if (!image) { return image.error(); }
    EXPECT_NE(image->bytes != nullptr, image->floats != nullptr);
    if (image->bytes) {
        EXPECT_EQ(image->bytes->rgb.size(), size_t{3} * static_cast<size_t>(image->bytes->width) *
                                                static_cast<size_t>(image->bytes->height));
    } else {
        EXPECT_EQ(image->floats->rgb.size(), size_t{3} * static_cast<size_t>(image->floats->width) *
                                                 static_cast<size_t>(image->floats->height));
    }
    return std::nullopt;
}

TEST(Fuzz, Images) {
    const TempFolder folder;
    Image8 bytes{40, 30, {}};
    ImageF floats{40, 30, {}};
    for (int i = 0; i < 3 * 40 * 30; ++i) {
        bytes.rgb.push_back(static_cast<uint8_t>(i * i / 7));
        floats.rgb.push_back(0.01f * static_cast<float>(i % 331));
    }
    ASSERT_TRUE(savePng(folder.path("a.png"), bytes));
    ASSERT_TRUE(saveHdr(folder.path("a.hdr"), floats));
    fuzz("a.png", TempFolder::read(folder.path("a.png")), 5, loadSoundImage);
    fuzz("a.hdr", TempFolder::read(folder.path("a.hdr")), 6, loadSoundImage);
}

TEST(Fuzz, Exr) {
    const TempFolder folder;
    ExrImage image{.width = 40, .height = 30, .channels = {}, .attributes = {{"note", "text"}}};
    for (const char* name : {"R", "G", "B"}) {
        std::vector<float> values;
        for (int i = 0; i < 40 * 30; ++i) {
            values.push_back(0.01f * static_cast<float>(i % 331));
        }
        image.channels.push_back({name, ExrPixelType::Half, values, {}});
    }
    ASSERT_TRUE(saveExr(folder.path("a.exr"), image));
    fuzz("a.exr", TempFolder::read(folder.path("a.exr")), 7, loadSoundImage);
}

TEST(Fuzz, Checkpoint) {
    const TempFolder folder;
    SceneDescription scene;
    scene.resolution = {16, 9};
    ASSERT_TRUE(saveCheckpoint(folder.path("a"), captureOf(scene, Film(16, 9), 2.0)));
    const std::string good = TempFolder::read(folder.path("a"));
    const int loaded = fuzz("a", good, 8, [&](const std::string& path) -> std::optional<Error> {
        const Result<ResumePoint> point = loadCheckpoint(path, scene);
        if (!point) { return point.error(); }
        EXPECT_EQ(TempFolder::read(path), good);  // the checksum lets nothing else through
        return std::nullopt;
    });
    EXPECT_LT(loaded, kRounds / 2);
}

}  // namespace
}  // namespace glint
