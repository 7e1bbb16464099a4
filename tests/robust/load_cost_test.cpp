// What loading costs: memory in proportion to the file, time that does not grow faster than it. Scenes here
// are of the kinds that take most for their size.
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <new>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include "engine/io/scene_loader.h"
#include "engine/io/text_source.h"
#include "tests/support/gltf_files.h"
#include "tests/support/temp_folder.h"

namespace {

std::atomic<size_t> heldBytes{0}, mostBytes{0};

void* counted(void* block) {
    if (block == nullptr) { throw std::bad_alloc(); }
    const size_t held = heldBytes += malloc_usable_size(block);
    size_t most = mostBytes;
    while (held > most && !mostBytes.compare_exchange_weak(most, held)) {}
    return block;
}

void release(void* block) {
    heldBytes -= malloc_usable_size(block);
    std::free(block);
}

}  // namespace

void* operator new(size_t size) { return counted(std::malloc(size)); }
void* operator new(size_t size, std::align_val_t alignment) {
    return counted(std::aligned_alloc(
        static_cast<size_t>(alignment),
        (size + static_cast<size_t>(alignment) - 1) & ~(static_cast<size_t>(alignment) - 1)));
}
void operator delete(void* block) noexcept { release(block); }
void operator delete(void* block, size_t) noexcept { release(block); }
void operator delete(void* block, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, size_t, std::align_val_t) noexcept { release(block); }

namespace glint {
namespace {

using test::TempFolder;
using testing::HasSubstr;

std::string repeated(int count, const std::string& text) {
    std::string out;
    for (int i = 0; i < count; ++i) {
        std::string one = text;
        for (size_t at = one.find('#'); at != std::string::npos; at = one.find('#', at + 1)) {
            one.replace(at, 1, std::to_string(i));
        }
        out += one;
    }
    return out;
}

/// A list of JSON values with their commas.
std::string list(int count, const std::string& text) {
    std::string out = repeated(count, text + ",");
    out.pop_back();
    return out;
}

struct Scene {
    const char* name;  ///< its extension tells the kind
    std::string text;
    bool loads = true;
};

TEST(LoadCost, MemoryIsInProportionToTheFile) {
    constexpr int kCount = 30'000;
    const std::string count = std::to_string(kCount);
    const std::string grey = R"({"glint":1,"materials":{"a":{"type":"mirror"}},)";
    const Scene scenes[] = {
        {"materials.txt", "Materials{numMaterials " + count + " " + repeated(kCount, "Material{}") + "}"},
        {"planes.txt", "Group{numObjects " + count + " " + repeated(kCount, "Plane{}") + "}"},
        {"lights.txt", "Lights{numLights " + count + " " + repeated(kCount, "PointLight{}") + "}"},
        {"triangles.txt", "Group{numObjects " + count + " " +
                              repeated(kCount, "Triangle{vertex0 0 0 0 vertex1 1 0 0 vertex2 0 1 0}") + "}"},
        {"materials.json", R"({"glint":1,"materials":{)" + list(kCount, R"("#":{"type":"mirror"})") + "}}"},
        {"objects.json", grey + R"("objects":[)" + list(kCount, R"({"type":"plane","material":"a"})") + "]}"},
        {"own.json",
         grey + R"("objects":[)" + list(kCount, R"({"type":"plane","material":{"type":"mirror"}})") + "]}"},
        {"lights.json",
         R"({"glint":1,"lights":[)" + list(kCount, R"({"type":"point","position":[0,0,0]})") + "]}"},
        {"textures.json", R"({"glint":1,"textures":{)" + list(kCount, R"("#":{"file":"a"})") + "}}"},
        {"meshes.json", grey + R"("meshes":{)" +
                            list(kCount, R"("#":{"positions":[[0,0,0]],"triangles":[[0,0,0]]})") + "}}"},
        {"parts.obj",
         "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + repeated(kCount / 2, "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n")},
        {"names.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + repeated(kCount, "usemtl #\nf 1 2 3\n")},
        {"lists.json", R"({"glint":1,"objects":[)" + list(10 * kCount, "[]") + "]}", false},
        {"keys.json", R"({"glint":1,"objects":{)" + list(kCount, R"("#":0)") + "}}", false},
    };
    const TempFolder folder;
    for (const Scene& scene : scenes) {
        const std::string path = folder.write(scene.name, scene.text);
        mostBytes = heldBytes.load();
        const size_t before = heldBytes;
        const auto loaded = loadScene(path);
        EXPECT_EQ(loaded.ok(), scene.loads) << scene.name << ": " << (loaded ? "" : loaded.error().format());
        EXPECT_LE(mostBytes - before, 64 * scene.text.size()) << scene.name;
        std::printf("%s: %.1f bytes for each of the file's\n", scene.name,
                    static_cast<double>(mostBytes - before) / static_cast<double>(scene.text.size()));
    }
}

TEST(LoadCost, AFileIsParsedOnceHoweverOftenItIsIncluded) {
    const TempFolder folder;
    const std::string include = R"(<include filename="part.xml"/>)";
    folder.write("part.xml", "<scene version=\"3.0.0\"><shape type=\"sphere\"/></scene>");
    const std::string text = "<scene version=\"3.0.0\">" + repeated(20'000, include) + "</scene>";
    const std::string path = folder.write("whole.xml", text);
    mostBytes = heldBytes.load();
    const size_t before = heldBytes;
    const auto loaded = loadScene(path, {.noStudio = true});
    ASSERT_TRUE(loaded) << loaded.error().format();
    EXPECT_EQ(loaded->objects.size(), 20'000u);
    EXPECT_LE(mostBytes - before, 64 * text.size());
}

/// One buffer of vertices for many primitives, each with all of them or with a triangle of its own.
TEST(LoadCost, PrimitivesShareTheirVertices) {
    constexpr int kVertices = 3000, kPrimitives = 2000;
    const TempFolder folder;
    folder.write("v.bin", test::packed<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) +
                              std::string(12 * (kVertices - 3), '\0') + test::packed<uint16_t>({0, 1, 2}));
    const std::string head = fmt::format(R"({{"asset":{{"version":"2.0"}},"scenes":[{{"nodes":[0]}}],
        "nodes":[{{"mesh":0}}],"buffers":[{{"uri":"v.bin","byteLength":{}}}],"bufferViews":[
        {{"buffer":0,"byteLength":{}}},{{"buffer":0,"byteOffset":{},"byteLength":6}}],"accessors":[
        {{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3"}})",
                                         12 * kVertices + 6, 12 * kVertices, 12 * kVertices, kVertices);
    const std::string triangle = R"(,{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"})";
    std::string same, own;
    for (int i = 0; i < kPrimitives; ++i) {
        const char* comma = i > 0 ? "," : "";
        same += fmt::format(R"({}{{"attributes":{{"POSITION":0}}}})", comma);
        own += fmt::format(R"({}{{"attributes":{{"POSITION":0}},"indices":{}}})", comma, i + 1);
    }
    for (const std::string& primitives : {same, own}) {
        const std::string text =
            head + repeated(kPrimitives, triangle) + R"(],"meshes":[{"primitives":[)" + primitives + "]}]}";
        const std::string path = folder.write("a.gltf", text);
        mostBytes = heldBytes.load();
        const size_t before = heldBytes;
        const auto loaded = loadScene(path, {.noStudio = true});
        ASSERT_TRUE(loaded) << loaded.error().format();
        EXPECT_EQ(loaded->objects.size(), static_cast<size_t>(kPrimitives));
        EXPECT_LE(mostBytes - before, 64 * (text.size() + 12 * kVertices));
    }
}

/// Accessors that say the same are one, so that meshes of them are one, too.
TEST(LoadCost, AccessorsOfTheSameBytesAreOne) {
    constexpr int kVertices = 30'000, kAccessors = 40;
    const TempFolder folder;
    folder.write("v.bin", std::string(size_t{12} * (kVertices - 3), '\0') +
                              test::packed<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}));
    std::string accessors, meshes, nodes, children;
    for (int i = 0; i < kAccessors; ++i) {
        const char* comma = i > 0 ? "," : "";
        accessors += fmt::format(R"({}{{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3"}})",
                                 comma, kVertices);
        meshes += fmt::format(R"({}{{"primitives":[{{"attributes":{{"POSITION":{}}}}}]}})", comma, i);
        nodes += fmt::format(R"({}{{"mesh":{}}})", comma, i);
        children += fmt::format("{}{}", comma, i);
    }
    const std::string path = folder.write(
        "a.gltf", fmt::format(R"({{"asset":{{"version":"2.0"}},"scenes":[{{"nodes":[{}]}}],"nodes":[{}],
        "buffers":[{{"uri":"v.bin","byteLength":{}}}],"bufferViews":[{{"buffer":0,"byteLength":{}}}],
        "accessors":[{}],"meshes":[{}]}})",
                              children, nodes, 12 * kVertices, 12 * kVertices, accessors, meshes));
    mostBytes = heldBytes.load();
    const size_t before = heldBytes;
    const auto loaded = loadScene(path, {.noStudio = true});
    ASSERT_TRUE(loaded) << loaded.error().format();
    EXPECT_EQ(loaded->objects.size(), static_cast<size_t>(kAccessors));
    EXPECT_EQ(loaded->meshes.size(), 1u);
    EXPECT_LE(mostBytes - before, size_t{16} * 12 * kVertices);
}

TEST(LoadCost, LinesAreListedOnceHoweverManyAreAskedFor) {
    const TextSource source{"a", repeated(1000, "line #\n") + "last"};
    for (size_t offset = 0, line = 1; offset < source.text.size(); ++offset) {
        ASSERT_EQ(source.warning(offset, "x"), "a:" + std::to_string(line) + ": x");
        ASSERT_EQ(source.place(offset).line, static_cast<int>(line));
        line += source.text[offset] == '\n' ? 1 : 0;
    }
    EXPECT_EQ(source.lines.searchedBytes(), source.text.size());
}

/// Where time grew with the square of the size, these would take hours.
TEST(LoadCost, TimeIsInProportionToTheFile) {
    const TempFolder folder;
    const auto fields =
        loadScene(folder.write("fields.txt", "PerspectiveCamera { " + repeated(500'000, "angle 30 ") + "}"));
    ASSERT_TRUE(fields) << fields.error().format();
    EXPECT_EQ(fields->camera.verticalFovDeg, 30.0f);
    constexpr int kCount = 100'000;
    const std::string missing = R"({"glint":1,"textures":{)" + list(kCount, "\n\"#\":{\"file\":\"none#\"}") +
                                "},\"materials\":{" +
                                list(kCount, R"("#":{"type":"diffuse","color":{"texture":"#"}})") +
                                "},\"objects\":[" + list(kCount, R"({"type":"plane","material":"#"})") + "]}";
    const auto without = loadScene(folder.write("missing.json", missing), {.allowMissing = true});
    ASSERT_TRUE(without) << without.error().format();
    EXPECT_THAT(without->warnings,
                testing::Contains(
                    HasSubstr("missing.json:2: files are missing and left out: \"none0\" (and 99999 more)")));
}

}  // namespace
}  // namespace glint
