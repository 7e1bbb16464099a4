#include "engine/io/baked_image.h"

#include <filesystem>

#include <fmt/format.h>

#include "engine/io/exr_io.h"

namespace glint {

ImageSource bakedImage(const ImageF& image, const std::string& path, size_t number) {
    ExrImage exr{.width = image.width, .height = image.height, .channels = {}, .attributes = {}};
    for (size_t c = 0; c < 3; ++c) {
        exr.channels.push_back({std::string(1, "RGB"[c]), ExrPixelType::Float, {}, {}});
        for (size_t i = c; i < image.rgb.size(); i += 3) {
            exr.channels.back().floats.push_back(image.rgb[i]);
        }
    }
    const Result<std::string> bytes = encodeExr(exr, path);
    const std::string name = fmt::format("{}-{}.exr", std::filesystem::path(path).stem().string(), number);
    return EmbeddedFile{name, std::make_shared<const std::string>(bytes ? *bytes : std::string())};
}

}  // namespace glint
