// GIF through giflib: the first picture of an animation, on the file's own canvas.
#include <cstring>

#include <gif_lib.h>

#include "engine/io/image_builder.h"
#include "engine/io/image_formats.h"

namespace glint {
namespace {

/// A code of 12 bits stands for up to 4096 pixels.
constexpr double kMostPixelsPerByte = 4096.0 * 8.0 / 12.0;

int readBytes(GifFileType* gif, GifByteType* out, int count) {
    auto* rest = static_cast<std::string_view*>(gif->UserData);
    const size_t read = std::min(static_cast<size_t>(std::max(count, 0)), rest->size());
    if (read > 0) { std::memcpy(out, rest->data(), read); }
    rest->remove_prefix(read);
    return static_cast<int>(read);
}

struct CloseGif {
    void operator()(GifFileType* gif) const { DGifCloseFile(gif, nullptr); }
};
using Gif = std::unique_ptr<GifFileType, CloseGif>;

/// Goes to the first picture; `transparent` becomes the colour that is none, -1 where there is no such.
/// False: there is no picture.
bool findImage(GifFileType* gif, int* transparent) {
    for (GifRecordType record{}; DGifGetRecordType(gif, &record) == GIF_OK;) {
        if (record == IMAGE_DESC_RECORD_TYPE) { return DGifGetImageDesc(gif) == GIF_OK; }
        if (record == TERMINATE_RECORD_TYPE) { return false; }
        int code = 0;
        GifByteType* block = nullptr;
        if (DGifGetExtension(gif, &code, &block) != GIF_OK) { return false; }
        while (block != nullptr) {
            if (code == GRAPHICS_EXT_FUNC_CODE && block[0] == 4) {
                *transparent = (block[1] & 1) != 0 ? block[4] : -1;
            }
            if (DGifGetExtensionNext(gif, &block) != GIF_OK) { return false; }
        }
    }
    return false;
}

/// The rows of an interlaced picture come in four passes.
std::vector<int> rowOrder(int height, bool interlaced) {
    std::vector<int> order;
    const int passes[][2] = {{0, 8}, {4, 8}, {2, 4}, {1, 2}};
    for (const auto& [first, step] : passes) {
        for (int row = interlaced ? first : 0; row < height; row += interlaced ? step : 1) {
            order.push_back(row);
        }
        if (!interlaced) { break; }
    }
    return order;
}

/// Draws the picture on the canvas, which it need not cover. Error: cut off, or a colour that the
/// palette lacks.
Status drawImage(GifFileType* gif, int transparent, const std::string& path, Image8Builder* canvas) {
    const GifImageDesc& image = gif->Image;
    const ColorMapObject* colors = image.ColorMap != nullptr ? image.ColorMap : gif->SColorMap;
    if (colors == nullptr) { return brokenImage(path, "it has no palette"); }
    const int canvasWidth = canvas->places().storedWidth;
    std::vector<uint8_t> line(static_cast<size_t>(image.Width));
    std::vector<uint8_t> rgba(size_t{4} * static_cast<size_t>(canvasWidth));
    for (int row = 0; row < canvas->places().storedHeight; ++row) {
        canvas->setRow(row, rgba);  // nothing is there yet
    }
    for (const int row : rowOrder(image.Height, image.Interlace)) {
        if (DGifGetLine(gif, line.data(), image.Width) != GIF_OK) {
            return brokenImage(path, GifErrorString(gif->Error));
        }
        for (int x = 0; x < image.Width; ++x) {
            const int index = line[static_cast<size_t>(x)];
            if (index >= colors->ColorCount) { return brokenImage(path, "a colour is not in the palette"); }
            const GifColorType& color = colors->Colors[index];
            if (const int column = image.Left + x; column < canvasWidth) {
                uint8_t* pixel = &rgba[4 * static_cast<size_t>(column)];
                pixel[0] = color.Red;
                pixel[1] = color.Green;
                pixel[2] = color.Blue;
                pixel[3] = index == transparent ? 0 : 255;
            }
        }
        if (image.Top + row < canvas->places().storedHeight) { canvas->setRow(image.Top + row, rgba); }
    }
    return {};
}

Result<SceneImage> decode(const std::string& bytes, const std::string& path) {
    std::string_view rest = bytes;
    int code = 0;
    const Gif gif(DGifOpen(&rest, readBytes, &code));
    if (!gif) { return brokenImage(path, GifErrorString(code)); }
    const auto checkSize = [&](int width, int height) {
        return checkStatedSize(path, static_cast<uint64_t>(width), static_cast<uint64_t>(height),
                               bytes.size(), kMostPixelsPerByte);
    };
    if (Status size = checkSize(gif->SWidth, gif->SHeight); !size) { return size.error(); }
    int transparent = -1;
    if (!findImage(gif.get(), &transparent)) { return brokenImage(path, "there is no picture in it"); }
    if (Status size = checkSize(gif->Image.Width, gif->Image.Height); !size) { return size.error(); }
    Image8Builder canvas({gif->SWidth, gif->SHeight});
    if (Status drawn = drawImage(gif.get(), transparent, path, &canvas); !drawn) { return drawn.error(); }
    return canvas.take();
}

}  // namespace

extern const ImageFormat kImageGif;
const ImageFormat kImageGif{.name = "GIF",
                            .extensions = ".gif",
                            .looksLike = [](std::string_view head) { return head.starts_with("GIF8"); },
                            .decode = decode};

}  // namespace glint
