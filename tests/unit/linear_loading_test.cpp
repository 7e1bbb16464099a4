// Loading takes time in proportion to the file: what readers look at again is counted, not timed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/io/importer.h"
#include "engine/io/mtl_reader.h"
#include "engine/io/obj_loader.h"
#include "engine/io/obj_parser.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

template <class Line>
std::string lines(int count, const Line& line) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        text += line(i);
    }
    return text;
}

TEST(LinearLoading, PlacesAreCountedOnce) {
    const std::string text = lines(5000, [](int) { return "some words\n"; });
    const std::string name = "in.txt";
    TextCursor cursor(text, name);
    for (int line = 1; !cursor.atEnd(); cursor.nextLine(), ++line) {
        EXPECT_EQ(cursor.lineOf(cursor.position()), line);
        cursor.word();
        EXPECT_EQ(cursor.placeOf(cursor.position()).line, line);
    }
    EXPECT_LE(cursor.charactersCounted(), 2 * text.size());
}

TEST(LinearLoading, ObjWithManySwitchesAndOddLines) {
    const std::string name = "in.obj";
    for (const std::string& text :
         {kTriangle + lines(4000, [](int i) { return fmt::format("usemtl m{}\nf 1 2 3\n", i % 50); }),
          kTriangle + lines(4000, [](int i) { return fmt::format("u{} 1 2 3\n", i); }) + "f 1 2 3\n",
          kTriangle + lines(4000, [](int) { return "f 1 2\nl 1 2\n"; }) + "f 1 2 3\n"}) {
        ObjParser parser(text, name, false);
        ASSERT_TRUE(parser.run());
        EXPECT_LE(parser.cursor().charactersCounted(), 2 * text.size());
        EXPECT_LE(parser.cursor().remarks().lines().size(), 2u);
    }
}

TEST(LinearLoading, ManyTextureCoordinatesAtOneVertex) {
    const std::string name = "in.obj";
    const auto comparisons = [&](int count) {
        const std::string text =
            kTriangle + lines(count, [&](int i) { return fmt::format("vt {} 0\n", 1.0 * i / count); }) +
            lines(count, [](int i) { return fmt::format("f 1/{} 2/1 3/1\n", i + 1); });
        ObjParser parser(text, name, false);
        EXPECT_TRUE(parser.run());
        return parser.builder().comparisons();
    };
    EXPECT_LE(comparisons(4000), 2.3 * static_cast<double>(comparisons(2000)));
}

TEST(LinearLoading, MtlWithManyMaterials) {
    const std::string name = "in.mtl";
    for (const std::string& text :
         {lines(4000, [](int i) { return fmt::format("newmtl m{}\nKd 0.5 0.5 0.5\nillum 2\n", i); }),
          lines(4000, [](int) { return "newmtl m\nKd 1 1 1\n"; }),
          "newmtl m\n" + lines(4000, [](int) { return "map_refl some/long/name.png\n"; })}) {
        const MtlFile file = readMtlEntries(text, name);
        EXPECT_LE(file.charactersCounted, 2 * text.size());
        EXPECT_LE(file.remarks.lines().size(), 1u);
    }
}

TEST(LinearLoading, FewBytesOfMemoryForEachOfTheFile) {
    const std::string text =
        kTriangle + lines(20000, [](int i) { return fmt::format("usemtl {}\nf 1 2 3\n", i % 2); });
    const auto file = readMeshFile(text, "in.obj");
    ASSERT_TRUE(file);
    size_t bytes = file->parts.capacity() * sizeof(MeshPart);
    for (const MeshPart& part : file->parts) {
        bytes += sizeof(MeshData) + part.mesh->positions.capacity() * sizeof(Vec3) +
                 part.mesh->indices.capacity() * sizeof(uint32_t) +
                 part.smoothing.capacity() * sizeof(SmoothingRun);
    }
    EXPECT_LE(bytes, 64 * text.size());
}

}  // namespace
}  // namespace glint
