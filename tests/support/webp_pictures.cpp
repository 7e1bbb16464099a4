#include <webp/encode.h>

#include "tests/support/library_pictures.h"

namespace glint::test {
namespace {

std::string webp(const Image8& image) {
    std::vector<uint8_t> rgba;
    for (size_t i = 0; i < image.rgb.size() / 3; ++i) {
        rgba.insert(rgba.end(), {image.rgb[3 * i], image.rgb[3 * i + 1], image.rgb[3 * i + 2],
                                 image.alpha.empty() ? uint8_t{255} : image.alpha[i]});
    }
    WebPConfig config;
    WebPPicture picture;
    WebPConfigInit(&config);
    WebPConfigLosslessPreset(&config, 6);
    WebPPictureInit(&picture);
    config.exact = 1;
    picture.use_argb = 1;
    picture.width = image.width;
    picture.height = image.height;
    WebPPictureImportRGBA(&picture, rgba.data(), 4 * image.width);
    WebPMemoryWriter writer;
    WebPMemoryWriterInit(&writer);
    picture.writer = WebPMemoryWrite;
    picture.custom_ptr = &writer;
    WebPEncode(&config, &picture);
    std::string bytes(reinterpret_cast<const char*>(writer.mem), writer.size);
    WebPMemoryWriterClear(&writer);
    WebPPictureFree(&picture);
    return bytes;
}

}  // namespace

std::string webpWithOrientation(int orientation) {
    const std::string exif = exifOf(orientation);
    const std::string chunks = "WEBPVP8X" + little(10, 4) + little(8, 4) + little(15, 3) + little(7, 3) +
                               webp(halfWhiteImage()).substr(12) + "EXIF" + little(exif.size(), 4) + exif;
    return "RIFF" + little(chunks.size(), 4) + chunks;
}

void addWebp(std::vector<PictureFile>* files) {
    files->push_back({"plain.webp", webp(patternImage()), patternImage()});
    files->push_back({"alpha.webp", webp(transparentImage()), transparentImage()});
}

}  // namespace glint::test
