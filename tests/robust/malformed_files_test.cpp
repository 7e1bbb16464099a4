// Broken meshes, materials, images and checkpoints: each gives one clear error that says where and what
// was expected.
#include <cstring>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/exr_io.h"
#include "engine/io/file_path.h"
#include "engine/io/files_read.h"
#include "engine/io/image_io.h"
#include "engine/io/obj_loader.h"
#include "engine/io/ply_loader.h"
#include "engine/io/scene_loader.h"
#include "engine/render/checkpoint.h"
#include "tests/support/capture.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::captureOf;
using test::TempFolder;
using testing::HasSubstr;

struct BadFile {
    std::string content;
    std::string expected;  ///< part of the message, with the place where there is one
};

void expectErrors(const char* name, const std::vector<BadFile>& files,
                  const std::function<std::optional<Error>(const std::string&)>& load) {
    const TempFolder folder;
    for (const BadFile& bad : files) {
        const std::string path = folder.write(name, bad.content);
        const std::optional<Error> error = load(path);
        const std::string shown = bad.content.substr(0, 200);
        ASSERT_TRUE(error.has_value()) << "accepted: " << shown;
        const std::string message = error->format();
        EXPECT_THAT(message, HasSubstr(path)) << shown;
        EXPECT_THAT(message, HasSubstr(bad.expected)) << shown;
    }
}

template <class T>
std::optional<Error> errorOf(const Result<T>& result) {
    return result ? std::nullopt : std::optional(result.error());
}

TEST(Malformed, ObjFiles) {
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const std::vector<BadFile> files = {
        {"", "the file has no faces"},
        {"v 0 0 0\n", "the file has no faces (1 vertices): a point cloud"},
        {"v 0 0\n", ":1:6: expected z, but the line ends"},
        {"v 0 x 0\n", ":1:5: expected y, a number, but found \"x\""},
        {"v 0 1,5 0\n", ":1:5: expected y, a number, but found \"1,5\""},
        {"v 0 nan 0\n", ":1:5: expected y, a finite number"},
        {"\n\nv 0 0 -inf\n", ":3:7: expected z, a finite number"},
        {"v 0 0 1e39\n", ":1:7: expected z, a finite number"},
        {"v 0 0 1e20\n", ":1:7: this coordinate is too large"},
        {"v 0 0 1.2.3\n", ":1:7: expected z, a number, but found \"1.2.3\""},
        {triangle + "f 1 2 4\n", ":4:7: there is no vertex 4; 3 are defined"},
        {triangle + "f 1 2 -4\n", ":4:7: there is no vertex -4"},
        {triangle + "f 0 1 2\n", ":4:3: the vertex has number 0; they count from 1"},
        {triangle + "f 1 2 99999999999999999999\n", ":4:7: there is no vertex 99999999999999999999"},
        {triangle + "f 1 2 3x\n", ":4:8: expected a corner like 1, 1/2, 1//3 or 1/2/3"},
        {triangle + "f 1 2 1.5\n", ":4:7: expected the number of a vertex"},
        {triangle + "f 1 2 3 x 2\n", ":4:9: expected the number of a vertex"},
        {triangle + "v 0 0 nan\nf 1 2 3\nf 2 3 4\n", ":4:7: expected z, a finite number"},
        {"v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", ":1:7: expected z, a finite number"},
        {triangle + "v 0 0 1e20\nf 2 3 -1\n", ":4:7: this coordinate is too large"},
        {triangle + "f a b c\n", ":4:3: expected the number of a vertex"},
        {triangle + "f 1 2 3\nf 1 \\\n 2 \\\n 7\n", ":7:2: there is no vertex 7"},
        {"\x89PNG\r\n\x1a\n", ":1:1: expected an OBJ statement"},
        {std::string("v 0 0 0\0v", 9), ":1:7: expected z, a number"},
        {"<html><body>not found</body></html>\n", ":1:1: expected an OBJ statement"},
    };
    expectErrors("bad.obj", files, [](const std::string& path) { return errorOf(loadObj(path)); });
}

Result<MeshFile> readPly(const std::string& path) { return parsePly(TempFolder::read(path), path); }

TEST(Malformed, PlyFiles) {
    const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
    const std::string faces = "property list uchar int vertex_indices\n";
    const std::string ascii = "ply\nformat ascii 1.0\n";
    const std::string mesh = ascii + "element vertex 3\n" + xyz + "element face 1\n" + faces + "end_header\n";
    const std::string binary = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" + xyz +
                               "element face 1\n" + faces + "end_header\n";
    const std::string vertices(36, '\0');
    std::string notANumber = vertices;
    std::memcpy(notANumber.data() + 16, "\x00\x00\xc0\x7f", 4);
    const std::vector<BadFile> files = {
        {"", ":1:1: expected the word ply"},
        {"solid\n", ":1:1: expected the word ply"},
        {"ply\n", "the header does not end"},
        {"ply\nend_header\n", "expected a format line"},
        {"ply\nformat text 1.0\n", ":2:8: expected ascii"},
        {ascii + "element vertex\n", ":3:15: expected the number of elements"},
        {ascii + "element vertex -1\n", ":3:16: there cannot be -1 elements"},
        {ascii + "element vertex many\n", ":3:16: expected the number of elements, a whole number"},
        {ascii + "property float x\n", ":3:1: expected an element line"},
        {ascii + "element vertex 1\nproperty quaternion x\n", ":4:10: expected a type"},
        {ascii + "element vertex 1\nproperty float\n", ":4:1: expected a type and a name"},
        {ascii + "element vertex 3\n" + xyz + "end_header\n0 0 0\n1 0 0\n0 1 0\n",
         "the file has no faces (3 vertices): a point cloud"},
        {ascii + "element vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n",
         ":3:16: expected the properties x, y"},
        {ascii + "element vertex 1\nproperty list uchar float x\nproperty float y\nproperty float "
                 "z\nend_header\n1 0 0 0\n",
         "cannot be lists"},
        {ascii + "element face 1\n" + faces + "end_header\n3 0 1 2\n", ":3:14: expected the element vertex"},
        {ascii + "element vertex 1\n" + xyz +
             "element face 1\nproperty int vertex_indices\nend_header\n0 0 0\n0\n",
         ":7:14: expected the property"},
        {ascii + "element vertex 1000000000000\n" + xyz + "end_header\n0 0 0\n",
         ":3:16: 1000000000000 \"vertex\" elements need"},
        {mesh + "0 0 0\n1 0\n0 1 0\n3 0 1 2\n", ":11:4: expected z, but the line ends"},
        {mesh + "0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n", ":11:5: z is nan; expected a finite number"},
        {mesh + "0 0 0\n1 0 0\n0 1 1e30\n3 0 1 2\n", ":12:5: z is 1.00000001504746"},
        {mesh + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", ":13:7: there is no vertex 3; they count from 0 to 2"},
        {mesh + "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", ":13:7: there is no vertex -1"},
        {mesh + "0 0 0\n1 0 0\n0 1 0\n3 0 1 x\n", ":13:7: expected a vertex number, a whole number"},
        {mesh + "0 0 0\n1 0 0\n0 1 0\n900 0 1 2\n", ":13:1: the list \"vertex_indices\" has 900 items"},
        {mesh + "0 0 0\n1 0 0\n0 1 0        \n", "ends too early"},
        {binary, ":3:16: 3 \"vertex\" elements need at least 36 bytes, but only 0 are left"},
        {binary + vertices, ":7:14: 1 \"face\" elements need at least 1 bytes"},
        {binary + notANumber + std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13), "byte 185: y is nan"},
        {binary + vertices + "\3", "byte 205: the list \"vertex_indices\" has 3 items, but only 0 bytes"},
        {binary + vertices + std::string("\3\0\0\0\0\0\0\0\0\3\0\0\0", 13), "there is no vertex 3"},
    };
    expectErrors("bad.ply", files, [](const std::string& path) { return errorOf(readPly(path)); });
}

/// As large as a film of a night may be, and without a byte that its kind begins with.
TEST(Malformed, WhatIsOfNoKindIsNotReadWhole) {
    const TempFolder folder;
    for (const char* name : {"a.json", "a.txt", "a.obj", "a.ply", "a.stl", "a.gltf", "a.glb", "a.xml",
                             "a.pbrt", "a.glintfilm"}) {
        const std::string path = folder.write(name, "");
        std::error_code error;
        std::filesystem::resize_file(path, uintmax_t{1} << 30, error);
        if (error) { GTEST_SKIP() << "the disk has no sparse files: " << error.message(); }
        const FilesRead read;
        const std::string message = hasExtension(name, ".glintfilm")
                                        ? readCheckpointInfo(path).error().format()
                                        : loadScene(path).error().format();
        EXPECT_THAT(message, testing::HasSubstr(name));
        EXPECT_THAT(read.paths(), testing::IsEmpty()) << name << ": " << message;
        std::filesystem::remove(path);
    }
}

TEST(Malformed, BinaryTextIsNotShown) {
    const std::string zeros(300, '\0');
    const Error ofLine{"expected a word", {.file = "a.obj", .line = 3, .column = 150, .lineText = zeros}};
    EXPECT_EQ(ofLine.format(), "a.obj:3:150: expected a word");
    const Error ofWord{"\"" + zeros + "v\" is no word", {.file = "a.obj"}};
    EXPECT_EQ(ofWord.format(), "a.obj: \"?v\" is no word");
    const Error ofText{"expected a\tb", {.file = "a.obj", .line = 1, .column = 3, .lineText = "v \x01 2"}};
    EXPECT_EQ(ofText.format(), "a.obj:1:3: expected a b\n  v ? 2\n    ^");
    const TempFolder folder;
    for (const std::string& bytes : {zeros, "Shape " + zeros + "\n", std::string("\1\2\3\4")}) {
        const std::string message = loadScene(folder.write("a.pbrt", bytes)).error().format();
        EXPECT_THAT(message, HasSubstr("a.pbrt: is no text; expected a pbrt scene"));
    }
}

/// The bytes that a save wrote.
template <class Save>
std::string savedBytes(const char* name, Save save) {
    const TempFolder folder;
    const Status status = save(folder.path(name));
    EXPECT_TRUE(status) << status.error().format();
    return TempFolder::read(folder.path(name));
}

std::string replaced(std::string bytes, size_t at, const std::string& by) {
    return bytes.replace(at, by.size(), by);
}

TEST(Malformed, Images) {
    const std::string png = savedBytes("a.png", [](const std::string& path) {
        return savePng(path, Image8{20, 10, std::vector<uint8_t>(600, 7)});
    });
    const std::string hdr = savedBytes("a.hdr", [](const std::string& path) {
        return saveHdr(path, ImageF{20, 10, std::vector<float>(600, 7.0f)});
    });
    std::string bmp(54, '\0');
    bmp.replace(0, 2, "BM");
    bmp[10] = 54;
    bmp[14] = 40;
    bmp[26] = 1;
    bmp[28] = 24;
    const std::vector<BadFile> files = {
        {"", "the file is empty"},
        {"GIF89a", "the image is broken or cut off"},
        {"hello", "expected PNG, JPEG, BMP, TGA, TIFF, WebP, DDS, HDR, EXR, GIF"},
        {png.substr(0, 20), "the image is broken or cut off"},
        {png.substr(0, png.size() / 2), "the image is broken or cut off"},
        {replaced(png, 45, std::string(8, '\xff')), "broken or cut off"},
        {replaced(png, 16, std::string("\x00\x01\x00\x00\x00\x01\x00\x00", 8)),
         "the image is broken or cut off"},
        {replaced(png, 16, std::string(8, '\x7f')), "the image is broken or cut off"},
        {replaced(png, 16, std::string(4, '\0')), "the image is broken or cut off"},
        {bmp, "the image has no pixels (0 x 0)"},
        {"\xff\xd8\xff\xe0", "the image is broken or cut off"},
        {hdr.substr(0, hdr.size() / 2), "broken or cut off"},
        {"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 100000 +X 100000\n", "the image is too large"},
        {"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1000 +X 1000\n",
         "1000 x 1000 pixels cannot be in 51 bytes"},
        {"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n+Y 1 +X 1\n", "not all of its pixels are there"},
        {"#?RADIANCE\n\n1 x 1\n", "is a broken HDR image: its size is \"1 x 1\""},
    };
    expectErrors("bad.img", files, [](const std::string& path) { return errorOf(loadImage(path)); });
}

TEST(Malformed, ExrFiles) {
    const auto bytesOf = [](const std::string& channel, float value) {
        return savedBytes("a.exr", [&](const std::string& path) {
            ExrImage image{.width = 20, .height = 10, .channels = {}, .attributes = {}};
            image.channels.push_back({channel, ExrPixelType::Float, std::vector<float>(200, value), {}});
            return saveExr(path, image);
        });
    };
    const std::string exr = bytesOf("Y", 0.5f);
    const size_t window =
        exr.find("dataWindow") + std::strlen("dataWindow") + 1 + std::strlen("box2i") + 1 + 4;
    const std::string huge("\0\0\0\0\0\0\0\0\xff\xff\xff\x00\xff\xff\xff\x00", 16);
    const std::string backwards("\5\0\0\0\5\0\0\0\0\0\0\0\0\0\0\0", 16);
    const std::vector<BadFile> files = {
        {exr.substr(0, 4), "broken or unsupported OpenEXR file"},
        {exr.substr(0, 100), "broken or unsupported OpenEXR file"},
        {exr.substr(0, exr.size() - 10), "broken or unsupported OpenEXR file"},
        {replaced(exr, window, huge), "the image is too large"},
        {replaced(exr, window, backwards), "broken or unsupported OpenEXR file"},
        {replaced(exr, 4, "\x7f"), "broken or unsupported OpenEXR file"},
        {bytesOf("depth.Z", 0.5f), "has no colour; expected the channels R, G and B, or Y"},
        {bytesOf("Y", std::numeric_limits<float>::quiet_NaN()), "the pixel in column 0, row 0 is nan"},
        {bytesOf("Y", std::numeric_limits<float>::infinity()), "is inf; expected finite numbers"},
    };
    expectErrors("bad.exr", files, [](const std::string& path) { return errorOf(loadImage(path)); });
}

TEST(Malformed, Checkpoints) {
    SceneDescription scene;
    scene.resolution = {8, 6};
    const std::string good = savedBytes("a.checkpoint", [&](const std::string& path) {
        return saveCheckpoint(path, captureOf(scene, Film(8, 6), 1.0));
    });
    const std::vector<BadFile> files = {
        {"", "is not a Glint checkpoint"},
        {"GLINTCK", "is not a Glint checkpoint"},
        {"GLINTCKP", "is cut off or damaged"},
        {std::string("\x89PNG\r\n\x1a\n") + good.substr(8), "is not a Glint checkpoint"},
        {replaced(good, 8, "\1"), "has checkpoint format 1; this program reads format 2"},
        {good.substr(0, 30), "it has 30 bytes and should have"},
        {good.substr(0, good.size() - 1), "is cut off or damaged"},
        {good + "x", "is cut off or damaged"},
        {replaced(good, good.size() / 2, "\x55"), "its checksum is wrong"},
        {replaced(good, 20, "x"), "its checksum is wrong"},
    };
    expectErrors("bad.checkpoint", files,
                 [&](const std::string& path) { return errorOf(loadCheckpoint(path, scene)); });
    expectErrors("bad.checkpoint", files,
                 [](const std::string& path) { return errorOf(readCheckpointInfo(path)); });
}

}  // namespace
}  // namespace glint
