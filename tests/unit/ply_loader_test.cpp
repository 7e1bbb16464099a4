// PLY files in all three encodings, with properties in any order and of any type.
#include "engine/io/ply_loader.h"

#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/math/color.h"

namespace glint {
namespace {

using testing::ElementsAre;

/// Appends numbers in either byte order.
class Bytes {
  public:
    Bytes(std::string header, bool big) : text(std::move(header)), big_(big) {}

    template <class T>
    Bytes& add(T value) {
        char raw[sizeof(T)];
        std::memcpy(raw, &value, sizeof raw);
        for (size_t i = 0; i < sizeof raw; ++i) {
            text += raw[big_ ? sizeof raw - 1 - i : i];
        }
        return *this;
    }

    std::string text;

  private:
    bool big_;
};

std::shared_ptr<const MeshData> parse(const std::string& bytes) {
    auto file = parsePly(bytes, "test.ply");
    EXPECT_TRUE(file) << file.error().format();
    return file ? file->parts[0].mesh : std::make_shared<MeshData>();
}

TEST(PlyLoader, AsciiWithEverything) {
    const auto mesh = parse(
        "ply\r\nformat ascii 1.0\r\ncomment written on C:\\temp\\\r\nobj_info x\r\n"
        "element vertex 4\r\nproperty float quality\r\nproperty double z\r\nproperty float y\r\nproperty "
        "short x\r\n"
        "property float nx\r\nproperty float ny\r\nproperty float nz\r\nproperty float s\r\nproperty float "
        "t\r\n"
        "property uchar red\r\nproperty uchar green\r\nproperty uchar blue\r\nproperty list uchar float "
        "weights\r\n"
        "element edge 1\r\nproperty int vertex1\r\nproperty int vertex2\r\n"
        "element face 2\r\nproperty uchar flags\r\nproperty list uchar int vertex_indices\r\n"
        "element material 1\r\nproperty float x\r\nend_header\r\n"
        "nan 0 0 0  0 0 1  0 0  255 0 0  0\r\n"
        "0 0 0 1  0 0 1  1 0  255 255 255  2 0.5 0.5\r\n"
        "0 0 1 1  0 0 1  1 1  0 0 0  1 1\r\n"
        "0 0 1 0  0 0 1  0 1  128 0 0  0\r\n"
        "0 1\r\n"
        "7 4 0 1 2 3\r\n"
        "7 3 0 1 2\r\n"
        "1.5");
    EXPECT_THAT(mesh->positions, ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)));
    EXPECT_EQ(mesh->triangleCount(), 3u);
    EXPECT_THAT(mesh->normals, testing::Each(Vec3(0, 0, 1)));
    EXPECT_THAT(mesh->uvs, ElementsAre(Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)));
    EXPECT_EQ(mesh->colors[1], Vec3(1.0f));
    EXPECT_FLOAT_EQ(mesh->colors[3].x, srgbToLinear(128.0f / 255.0f));
}

std::string header(const char* format) {
    return std::string("ply\nformat ") + format +
           " 1.0\nelement vertex 3\nproperty float x\nproperty double y\nproperty int z\nproperty uchar "
           "extra\n"
           "property float red\nproperty float green\nproperty float blue\n"
           "element skipped 2\nproperty list ushort short items\n"
           "element face 1\nproperty list uint ushort vertex_index\nproperty float area\nend_header\n";
}

TEST(PlyLoader, BinaryInBothByteOrders) {
    for (const bool big : {false, true}) {
        Bytes bytes(header(big ? "binary_big_endian" : "binary_little_endian"), big);
        for (int i = 0; i < 3; ++i) {
            bytes.add(0.5f * static_cast<float>(i))
                .add(static_cast<double>(i * i))
                .add(int32_t{-i})
                .add(uint8_t{9});
            bytes.add(1.0f).add(0.25f).add(2.0f);
        }
        bytes.add(uint16_t{2}).add(int16_t{1}).add(int16_t{2}).add(uint16_t{0});
        bytes.add(uint32_t{3}).add(uint16_t{0}).add(uint16_t{1}).add(uint16_t{2}).add(4.0f);
        const auto mesh = parse(bytes.text);
        EXPECT_THAT(mesh->positions, ElementsAre(Vec3(0, 0, 0), Vec3(0.5f, 1, -1), Vec3(1, 4, -2)));
        EXPECT_THAT(mesh->indices, ElementsAre(0, 1, 2));
        EXPECT_THAT(mesh->colors, testing::Each(Vec3(1.0f, srgbToLinear(0.25f), 1.0f)));
    }
}

TEST(PlyLoader, ConcavePolygonKeepsItsArea) {
    const auto mesh = parse(
        "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar uint vertex_indices\nend_header\n"
        "0 0 0\n0 4 0\n0 4 4\n0 2 4\n0 2 2\n0 0 2\n6 0 1 2 3 4 5\n");
    float area = 0.0f;
    for (size_t i = 0; i < mesh->indices.size(); i += 3) {
        const Vec3& a = mesh->positions[mesh->indices[i]];
        area += 0.5f * glm::cross(mesh->positions[mesh->indices[i + 1]] - a,
                                  mesh->positions[mesh->indices[i + 2]] - a)
                           .x;
    }
    EXPECT_EQ(mesh->triangleCount(), 4u);
    EXPECT_FLOAT_EQ(area, 12.0f);
}

}  // namespace
}  // namespace glint
