// What a file is told by: its name, and its first bytes where the name says nothing or something else.
#include "engine/io/file_kind.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/image_formats.h"
#include "engine/io/image_io.h"
#include "engine/io/importer.h"
#include "engine/io/scene_loader.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::TempFolder;

std::string_view importerName(const std::string& path, std::string_view head) {
    const Importer* importer = importerOf(path, head);
    return importer != nullptr ? importer->name : "none";
}

std::string_view formatName(const std::string& path, std::string_view head) {
    const ImageFormat* format = imageFormatOf(path, head);
    return format != nullptr ? format->name : "none";
}

TEST(FileKind, ExtensionsAreComparedWithoutCase) {
    EXPECT_EQ(extensionOf("a.b/c.PnG"), ".png");
    EXPECT_EQ(extensionOf("a.b/c"), "");
    EXPECT_TRUE(hasExtension("a.JPEG", ".jpg .jpeg"));
    EXPECT_TRUE(hasExtension("a.jpg", ".jpg .jpeg"));
    EXPECT_FALSE(hasExtension("a.jp", ".jpg .jpeg"));
    EXPECT_FALSE(hasExtension("a", ".jpg .jpeg"));
    EXPECT_FALSE(hasExtension("a.", ""));
}

TEST(FileKind, FirstBytesDecideBetweenNamesAndScenes) {
    constexpr std::string_view kJson = " \r\n{\"glint\": 1}";
    constexpr std::string_view kText = "Materials { numMaterials 0 }";
    constexpr std::string_view kObj = "# v 1 2 3 exported by hand\n\n  # again\nv 0 0 0\n";
    constexpr std::string_view kPly = "ply\r\nformat ascii 1.0\r\n";
    constexpr std::string_view kStl = "solid x\n facet normal 0 0 1\n";
    constexpr std::string_view kGltf = R"({"scenes": [], "asset": {"version": "2.0"}})";
    const std::pair<std::string_view, std::string_view> contents[] = {
        {kJson, "Glint JSON"}, {kText, "6.837 text"}, {kObj, "OBJ"},
        {kPly, "PLY"},         {kStl, "STL"},         {kGltf, "glTF"}};
    for (const auto& [content, name] : contents) {
        for (const char* path : {"a", "a.scene", "a.json", "a.TXT", "a.obj", "a.PLY"}) {
            EXPECT_EQ(importerName(path, content), name) << path;
        }
    }
    EXPECT_EQ(importerName("a", "\xEF\xBB\xBF// a comment"), "Glint JSON");
    EXPECT_EQ(importerName("a", "vertex 1 2 3"), "none");
    EXPECT_EQ(importerName("a", "g"), "none") << "a letter alone says nothing";
    EXPECT_EQ(importerName("a", ""), "none");
    EXPECT_EQ(importerName("a.Obj", "what?"), "OBJ") << "its reader says what is wrong";
    EXPECT_EQ(importerName("a.txt", ""), "6.837 text");
    EXPECT_EQ(importerName("a.stl", std::string(84, ' ')), "STL") << "the binary form has no mark";
}

TEST(FileKind, FirstBytesDecideBetweenImages) {
    const std::string tga("\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\x18\0", 18);
    const std::pair<std::string, std::string_view> contents[] = {
        {"\x89PNG\r\n", "PNG"},   {"\xff\xd8\xff\xe0", "JPEG"},
        {"BM1234", "BMP"},        {tga, "TGA"},
        {"#?RADIANCE\n", "HDR"},  {"\x76\x2f\x31\x01", "EXR"},
        {"GIF89a", "GIF"},        {"P6\n1 1\n255\n", "PNM"},
        {"8BPS", "PSD"},          {std::string("II*\0", 4), "TIFF"},
        {"RIFF1234WEBP", "WebP"}, {"DDS |", "DDS"}};
    for (const auto& [content, name] : contents) {
        for (const char* path : {"a", "a.png", "a.JPG", "a.tga", "a.exr", "a.xyz"}) {
            EXPECT_EQ(formatName(path, content), name) << path;
        }
    }
    EXPECT_EQ(formatName("a.TGA", "?"), "TGA");
    EXPECT_EQ(formatName("a", std::string(18, '\0')), "none");
    EXPECT_EQ(formatName("a", "{\"glint\": 1, \"title\": \"no image\"}"), "none");
}

TEST(FileKind, ListsNameEveryImporterAndFormat) {
    EXPECT_EQ(listImporters(),
              "Glint JSON (.json), 6.837 text (.txt), OBJ (.obj), PLY (.ply), STL (.stl), glTF (.gltf "
              ".glb), Mitsuba (.xml) or pbrt (.pbrt .gz)");
    EXPECT_EQ(listImporters(true), "OBJ (.obj), PLY (.ply) or STL (.stl)");
    EXPECT_EQ(listReadableImages(),
              "PNG, JPEG, BMP, TGA, TIFF, WebP, DDS, HDR, EXR, GIF, PNM, PFM, PSD or Softimage PIC");
    EXPECT_EQ(listSavedExtensions(), ".png, .hdr or .exr");
    for (const char* path : {"a.png", "a.PNG", "a.Hdr", "a.EXR"}) {
        EXPECT_NE(savedFormatOf(path), nullptr) << path;
    }
    for (const char* path : {"a.jpg", "a", "png", "a.gif", "a.pic"}) {
        EXPECT_EQ(savedFormatOf(path), nullptr) << path;
    }
}

TEST(FileKind, ScenesAndTheirMeshesOpenUnderWrongNames) {
    const TempFolder folder;
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    for (const char* name : {"mesh", "mesh.json", "mesh.ply"}) {
        const auto scene = loadScene(folder.write(name, obj), {.noStudio = true});
        ASSERT_TRUE(scene) << scene.error().format();
        EXPECT_EQ(scene->objects.size(), 1u) << name;
        const auto holder = loadScene(
            folder.write("holder.json", std::string(R"({"glint": 1, "materials": {"m": {"type": "diffuse"}},
                "objects": [{"type": "mesh", "material": "m", "mesh": {"file": ")") +
                                            name + "\"}}]}"));
        ASSERT_TRUE(holder) << holder.error().format();
        EXPECT_EQ(holder->meshes[0].data->triangleCount(), 1u) << name;
    }
    ASSERT_TRUE(savePng(folder.path("image.exr"), {1, 1, {1, 2, 3}}));
    const auto image = loadImage8(folder.path("image.exr"));
    ASSERT_TRUE(image) << image.error().format();
    EXPECT_EQ((*image)->rgb[2], 3);
}

TEST(FileKind, WhatGlintDoesNotReadIsRefusedByItsName) {
    const TempFolder folder;
    const std::tuple<const char*, std::string, const char*> files[] = {
        {"a.fbx", "Kaydara FBX Binary  ", "a FBX file"},
        {"a.xml", "<?xml version=\"1.0\"?><COLLADA>", "a COLLADA file"},
        {"a.off", "OFF\n8 6 0\n", "a OFF file"}};
    for (const auto& [name, bytes, kind] : files) {
        const auto scene = loadScene(folder.write(name, bytes));
        ASSERT_FALSE(scene) << name;
        EXPECT_THAT(scene.error().format(), testing::HasSubstr(kind)) << name;
        const auto mesh = readMeshFile(bytes, name);
        ASSERT_FALSE(mesh) << name;
        EXPECT_THAT(mesh.error().format(), testing::HasSubstr(kind)) << name;
    }
    EXPECT_TRUE(loadScene(folder.write("b.json", R"({"glint": 1, "title": "\"asset\""})")));
}

TEST(FileKind, WhatIsNoModelIsNamedUnderTheNameOfOne) {
    const TempFolder folder;
    ASSERT_TRUE(savePng(folder.path("a.png"), {1, 1, {1, 2, 3}}));
    const std::pair<std::string, const char*> files[] = {
        {TempFolder::read(folder.path("a.png")), "is a PNG picture, no model"},
        {TempFolder::read(folder.path("a.png")).substr(0, 16), "is a PNG picture, no model"},
        {"\xff\xd8\xff\xe0" + std::string(30, '\0'), "is a JPEG picture, no model"},
        {"GIF89a" + std::string(30, '\1'), "is a GIF picture, no model"},
        {"version https://git-lfs.github.com/spec/v1\noid sha256:12\nsize 12\n", "is a Git LFS pointer"},
        {"PK\x03\x04" + std::string(30, '\0') + "model.obj", "is a ZIP file, which"},
        {"PK\x03\x04" + std::string(30, '\0') + "model.usdc", "is a USD file, which"},
        {"<!DOCTYPE html>\n<html>", "is a HTML file, which"},
        {"\n<HTML><body>404", "is a HTML file, which"},
        {"%PDF-1.4\n", "is a PDF file, which"}};
    for (const auto& [bytes, message] : files) {
        for (const char* name : {"a.obj", "a.ply", "a.stl", "a.json", "a.pbrt", "a.dat"}) {
            const auto scene = loadScene(folder.write(name, bytes));
            ASSERT_FALSE(scene) << name;
            EXPECT_THAT(scene.error().format(), testing::HasSubstr(message)) << name;
        }
    }
}

}  // namespace
}  // namespace glint
