// Images through every format we write, and the one that stands for those we only read; whole files in
// and out.
#include "engine/io/image_io.h"

#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "engine/io/atomic_file.h"
#include "engine/io/exr_io.h"
#include "engine/io/temporary_file.h"
#include "engine/math/color.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::TempFolder;
using testing::HasSubstr;

Image8 gradient(int width, int height) {
    Image8 image{.width = width, .height = height, .rgb = {}};
    for (int i = 0; i < 3 * width * height; ++i) {
        image.rgb.push_back(static_cast<uint8_t>((i * 37) % 256));
    }
    return image;
}

TEST(ImageIo, PngKeepsEveryByte) {
    const TempFolder folder;
    const Image8 image = gradient(17, 9);
    ASSERT_TRUE(savePng(folder.path("a.png"), image));
    const auto loaded = loadImage8(folder.path("a.png"));
    ASSERT_TRUE(loaded) << loaded.error().format();
    EXPECT_EQ((*loaded)->width, 17);
    EXPECT_EQ((*loaded)->rgb, image.rgb);

    const auto linear = loadImageF(folder.path("a.png"));
    ASSERT_TRUE(linear);
    EXPECT_EQ((*linear)->rgb[1], srgbToLinear(37.0f / 255.0f));
}

TEST(ImageIo, TgaAndGreyAndAlphaBecomeRgb) {
    const TempFolder folder;
    // Uncompressed TGA: 18 bytes of header; image type 2 (colour) or 3 (grey), size, bits, and "top row
    // first" (0x20).
    const auto tga = [](char type, char bits, std::string pixels) {
        std::string bytes(18, '\0');
        bytes[2] = type;
        bytes[12] = 2;
        bytes[14] = 1;
        bytes[16] = bits;
        bytes[17] = 0x20;
        return bytes + pixels;
    };
    const auto grey = loadImage8(folder.write("grey.tga", tga(3, 8, "\x10\xf0")));
    ASSERT_TRUE(grey) << grey.error().format();
    EXPECT_EQ((*grey)->rgb, (std::vector<uint8_t>{0x10, 0x10, 0x10, 0xf0, 0xf0, 0xf0}));
    const auto alpha =
        loadImage8(folder.write("alpha.tga", tga(2, 32, std::string("\1\2\3\0\4\5\6\x7f", 8))));
    ASSERT_TRUE(alpha) << alpha.error().format();
    EXPECT_EQ((*alpha)->rgb,
              (std::vector<uint8_t>{3, 2, 1, 6, 5, 4}));  // stored blue first; alpha changes nothing
}

TEST(ImageIo, HdrKeepsEightBitsOfEachPixelsLargestChannel) {
    const TempFolder folder;
    ImageF image{.width = 9, .height = 3, .rgb = {}};
    for (int i = 0; i < 81; ++i) {
        image.rgb.push_back(0.001f * std::exp2(static_cast<float>((i / 3) % 25)));
    }
    ASSERT_TRUE(saveHdr(folder.path("a.hdr"), image));
    const auto loaded = loadImageF(folder.path("a.hdr"));
    ASSERT_TRUE(loaded) << loaded.error().format();
    for (size_t i = 0; i < image.rgb.size(); ++i) {
        EXPECT_NEAR((*loaded)->rgb[i], image.rgb[i], image.rgb[i] / 128.0f);
    }
    const auto refused = loadImage8(folder.path("a.hdr"));
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().format(), HasSubstr("expected an 8-bit image"));
}

TEST(ImageIo, ExrKeepsFloatsAndIdsAndRoundsHalves) {
    const TempFolder folder;
    const std::string path = folder.path("a.exr");
    ExrImage image{.width = 2, .height = 2, .channels = {}, .attributes = {{"note", "two\nlines"}}};
    const std::vector<float> values{0.1f, -1e30f, 1e-30f, 3.0f};
    image.channels.push_back({.name = "x.F", .type = ExrPixelType::Float, .floats = values, .ids = {}});
    image.channels.push_back(
        {.name = "x.I", .type = ExrPixelType::Uint, .floats = {}, .ids = {0, 1, 4294967295u, 7}});
    image.channels.push_back(
        {.name = "Y", .type = ExrPixelType::Half, .floats = {0.1f, 1.0f, 1e9f, 0.5f}, .ids = {}});
    ASSERT_TRUE(saveExr(path, image));
    const auto loaded = loadExr(path);
    ASSERT_TRUE(loaded) << loaded.error().format();
    EXPECT_EQ(loaded->find("x.F")->floats, values);
    EXPECT_EQ(loaded->find("x.I")->ids, image.channels[1].ids);
    EXPECT_EQ(loaded->attributes.at("note"), "two\nlines");
    const ExrChannel& half = *loaded->find("Y");
    EXPECT_EQ(half.type, ExrPixelType::Half);
    EXPECT_NEAR(half.floats[0], 0.1f, 0.1f / 2048.0f);
    EXPECT_EQ(half.floats[2], 65504.0f);
    const auto grey = loadImageF(path);  // Y alone is grey
    ASSERT_TRUE(grey) << grey.error().format();
    EXPECT_EQ((*grey)->rgb[11], 0.5f);
    EXPECT_EQ(loaded->find("nothing"), nullptr);
}

TEST(ImageIo, NothingToSaveIsRefused) {
    const TempFolder folder;
    EXPECT_FALSE(savePng(folder.path("a.png"), Image8{}));
    EXPECT_FALSE(savePng(folder.path("a.png"), Image8{2, 2, {1, 2, 3}}));
    EXPECT_FALSE(saveHdr(folder.path("a.hdr"), ImageF{}));
    EXPECT_FALSE(saveExr(folder.path("a.exr"), ExrImage{}));
    EXPECT_EQ(folder.size(), 0u);
}

TEST(AtomicFile, ReplacesAndKeepsPermissionsAndLinks) {
    const TempFolder folder;
    const std::string path = folder.path("file");
    ASSERT_TRUE(writeFileAtomically(path, "first"));
    ::chmod(path.c_str(), 0640);
    std::filesystem::create_symlink(path, folder.path("link"));
    ASSERT_TRUE(writeFileAtomically(folder.path("link"), "second"));
    EXPECT_EQ(TempFolder::read(path), "second");
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link")));
    struct stat info {};
    ASSERT_EQ(::stat(path.c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 0777, 0640u);
    EXPECT_EQ(folder.size(), 2u);
    const Result<std::string> read = readFile(path);
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, "second");
}

TEST(AtomicFile, FailuresKeepTheOldFileAndLeaveNothing) {
    const TempFolder folder;
    const std::string path = folder.write("file", "old");
    EXPECT_FALSE(writeFileAtomically(folder.path("no/such/folder/file"), "new"));
    const Status isFolder = writeFileAtomically(folder.path(), "new");
    ASSERT_FALSE(isFolder);
    EXPECT_THAT(isFolder.error().format(), HasSubstr("is a folder"));

    // A file size limit stands for a full disk: the write fails half-way.
    struct rlimit before {};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
    struct rlimit tight = before;
    tight.rlim_cur = 1000;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
    const Status full = writeFileAtomically(path, std::string(5000, 'x'));
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, oldHandler);
    ASSERT_FALSE(full);
    EXPECT_THAT(full.error().format(), HasSubstr("cannot write: File too large"));
    EXPECT_EQ(TempFolder::read(path), "old");
    EXPECT_EQ(folder.size(), 1u);
}

TEST(AtomicFile, DevicesAreWrittenNotReplaced) {
    if (!std::filesystem::is_character_file("/dev/full")) { GTEST_SKIP() << "no /dev/full here"; }
    const Status full = writeFileAtomically("/dev/full", "x");
    ASSERT_FALSE(full);
    EXPECT_THAT(full.error().format(), HasSubstr("No space left"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
    EXPECT_TRUE(writeFileAtomically("/dev/null", "x"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(AtomicFile, ReadErrorsNameTheFile) {
    const TempFolder folder;
    const Result<std::string> missing = readFile(folder.path("none"));
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().format(), HasSubstr("none: cannot open: No such file"));
    EXPECT_FALSE(readFile(folder.path()));
}

TEST(AtomicFile, OnlyRegularFilesAreRead) {
    const TempFolder folder;
    const std::string pipe = folder.path("pipe");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    // Nobody ever writes to the pipe: opening it in the ordinary way would never return.
    const Result<std::string> fromPipe = readFile(pipe);
    ASSERT_FALSE(fromPipe);
    EXPECT_THAT(fromPipe.error().format(), HasSubstr("pipe: is a pipe; expected a file"));
    const Result<std::string> null = readFile("/dev/null");
    ASSERT_FALSE(null);
    EXPECT_THAT(null.error().format(), HasSubstr("/dev/null: is a device; expected a file"));
    const std::string file = folder.write("file", "text");
    std::filesystem::create_symlink(file, folder.path("link"));
    const Result<std::string> throughLink = readFile(folder.path("link"));
    ASSERT_TRUE(throughLink);
    EXPECT_EQ(*throughLink, "text");
    EXPECT_TRUE(checkRegularFile(folder.path("link"), "a file"));
}

TEST(AtomicFile, ASaveRemovesTheLeftoversOfKilledOnesAndNothingOfAUsers) {
    const TempFolder folder;
    const std::string path = folder.write("file", "old");
    const std::string stale = folder.write("file.glint-4711-0.tmp", "half");
    const std::string staleOfAnother = folder.write("file-000050.png.glint-4711-12.tmp", "half");
    const std::string busy = folder.write("file.glint-4711-1.tmp", "in work");
    const std::vector<std::string> others = {
        folder.write("file.2024-11.tmp", "x"),    folder.write("file.glint-4711-0.tmp.txt", "x"),
        folder.write("file.glint-4711.tmp", "x"), folder.write("file.glint--0.tmp", "x"),
        folder.write("file.glint-a-0.tmp", "x"),  folder.write("file.glint-4711-0", "x"),
        folder.write("file.glint-.tmp", "x"),     folder.write("file.glint.4711-0.tmp", "x")};
    std::filesystem::create_directory(folder.path("file.glint-4711-2.tmp"));
    std::filesystem::create_symlink(path, folder.path("file.glint-4711-3.tmp"));
    // A lock belongs to an open file: it holds against this process, too.
    const int writer = ::open(busy.c_str(), O_WRONLY | O_CLOEXEC);
    ASSERT_GE(writer, 0);
    ASSERT_EQ(::flock(writer, LOCK_EX), 0);

    ASSERT_TRUE(writeFileAtomically(path, "new"));
    EXPECT_EQ(TempFolder::read(path), "new");
    EXPECT_FALSE(std::filesystem::exists(stale));
    EXPECT_FALSE(std::filesystem::exists(staleOfAnother));
    EXPECT_EQ(TempFolder::read(busy), "in work");
    for (const std::string& other : others) {
        EXPECT_TRUE(std::filesystem::exists(other)) << other;
    }
    EXPECT_TRUE(std::filesystem::is_directory(folder.path("file.glint-4711-2.tmp")));
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path("file.glint-4711-3.tmp")));
    ::close(writer);

    ASSERT_TRUE(writeFileAtomically(path, "newer"));
    EXPECT_FALSE(std::filesystem::exists(busy)) << "its writer is gone now";
}

TEST(AtomicFile, NamesAsLongAsTheyMayBeAreWritten) {
    const TempFolder folder;
    for (const char* character : {"a", "\u00e9", "\U0001f4a1"}) {
        std::string name;
        while (name.size() + std::strlen(character) <= 255) {
            name += character;
        }
        const std::string path = folder.path(name);
        EXPECT_TRUE(checkWritable(path));
        ASSERT_TRUE(writeFileAtomically(path, "x")) << name.size();
        EXPECT_EQ(TempFolder::read(path), "x");
        std::filesystem::remove(path);
    }
    EXPECT_FALSE(checkWritable(folder.path(std::string(256, 'a'))));
    EXPECT_EQ(folder.size(), 0u);
}

TEST(AtomicFile, ALinkToAFileThatIsNotThereYetStays) {
    const TempFolder folder;
    std::filesystem::create_directory(folder.path("there"));
    std::filesystem::create_symlink("there/second", folder.path("first"));
    std::filesystem::create_symlink("file", folder.path("there/second"));
    EXPECT_TRUE(checkWritable(folder.path("first")));
    ASSERT_TRUE(writeFileAtomically(folder.path("first"), "x"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path("first")));
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path("there/second")));
    EXPECT_EQ(TempFolder::read(folder.path("there/file")), "x");

    std::filesystem::create_symlink("round", folder.path("round"));
    EXPECT_FALSE(checkWritable(folder.path("round")));
    EXPECT_FALSE(writeFileAtomically(folder.path("round"), "x"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path("round")));
}

TEST(AtomicFile, ATemporaryFileIsLockedWhileItIsWritten) {
    const TempFolder folder;
    const std::string target = folder.path("file");
    std::string name;
    const int writer = createTemporary(target, &name);
    ASSERT_GE(writer, 0);
    removeStaleTemporaries(target);
    EXPECT_TRUE(std::filesystem::exists(name));
    ::close(writer);
    removeStaleTemporaries(target);
    EXPECT_FALSE(std::filesystem::exists(name));
}

}  // namespace
}  // namespace glint
