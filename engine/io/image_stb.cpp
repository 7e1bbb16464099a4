// What only libstb reads: PSD and Softimage PIC. It takes bytes beyond the end of a file for 0, so they are
// asked for one by one here, and a picture that needed some is refused. stb_image comes compiled; only its
// declarations are included.
#include <cstring>

#include <stb/stb_image.h>

#include "engine/io/file_kind.h"
#include "engine/io/image_builder.h"
#include "engine/io/image_formats.h"
#include "engine/io/image_io.h"

namespace glint {
namespace {

/// Runs take 2 bytes for at most 128 values of one channel; a file may have one channel.
constexpr double kMostPixelsPerByte = 64.0;

struct Reading {
    std::string_view rest;
    bool beyondEnd = false;
};

int readBytes(void* user, char* out, int count) {
    auto* reading = static_cast<Reading*>(user);
    reading->beyondEnd |= reading->rest.empty();
    const size_t read = std::min(static_cast<size_t>(std::max(count, 0)), reading->rest.size());
    if (read > 0) { std::memcpy(out, reading->rest.data(), read); }
    reading->rest.remove_prefix(read);
    return static_cast<int>(read);
}

void skipBytes(void* user, int count) {
    auto* reading = static_cast<Reading*>(user);
    const auto wanted = static_cast<size_t>(std::max(count, 0));
    reading->beyondEnd |= wanted > reading->rest.size();
    reading->rest.remove_prefix(std::min(wanted, reading->rest.size()));
}

int isAtEnd(void* user) { return static_cast<Reading*>(user)->rest.empty() ? 1 : 0; }

constexpr stbi_io_callbacks kCallbacks{readBytes, skipBytes, isAtEnd};

struct FreePixels {
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

Result<SceneImage> decode(const std::string& bytes, const std::string& path) {
    int width = 0, height = 0, channels = 0;
    Reading header{bytes};
    if (stbi_info_from_callbacks(&kCallbacks, &header, &width, &height, &channels) == 0) {
        return brokenImage(path, stbi_failure_reason());
    }
    if (Status size =
            checkStatedSize(path, static_cast<uint64_t>(std::max(width, 0)),
                            static_cast<uint64_t>(std::max(height, 0)), bytes.size(), kMostPixelsPerByte);
        !size) {
        return size.error();
    }
    Reading reading{bytes};
    const std::unique_ptr<stbi_uc, FreePixels> pixels(
        stbi_load_from_callbacks(&kCallbacks, &reading, &width, &height, &channels, 4));
    if (!pixels) { return brokenImage(path, stbi_failure_reason()); }
    if (reading.beyondEnd) { return brokenImage(path, "the file ends too early"); }
    Image8Builder builder({width, height});
    const size_t rowBytes = 4 * static_cast<size_t>(width);
    for (int row = 0; row < height; ++row) {
        builder.setRow(row, {pixels.get() + static_cast<size_t>(row) * rowBytes, rowBytes});
    }
    return builder.take();
}

}  // namespace

extern const ImageFormat kImagePsd, kImageSoftimage;
const ImageFormat kImagePsd{.name = "PSD",
                            .extensions = ".psd",
                            .looksLike = [](std::string_view head) { return head.starts_with("8BPS"); },
                            .decode = decode};
const ImageFormat kImageSoftimage{
    .name = "Softimage PIC",
    .extensions = ".pic",
    .looksLike = [](std::string_view head) { return head.starts_with("\x53\x80\xf6\x34"); },
    .decode = decode};

std::optional<uint64_t> statedPixelBytes(const std::string& path) {
    const std::string head = readHead(path, size_t{64} << 10);
    const auto* bytes = reinterpret_cast<const stbi_uc*>(head.data());
    const int size = static_cast<int>(head.size());
    int width = 0, height = 0, channels = 0;
    if (stbi_info_from_memory(bytes, size, &width, &height, &channels) == 0 || width <= 0 || height <= 0) {
        return {};
    }
    return uint64_t{3} * static_cast<uint64_t>(width) * static_cast<uint64_t>(height) *
           (stbi_is_hdr_from_memory(bytes, size) != 0 ? sizeof(float) : 1);
}

}  // namespace glint
