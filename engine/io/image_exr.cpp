#include "engine/io/exr_io.h"
#include "engine/io/image_formats.h"

namespace glint {
namespace {

Result<SceneImage> decode(const std::string& bytes, const std::string& path) {
    Result<ExrColorImage> image = decodeExrColor(bytes, path);
    if (!image) { return image.error(); }
    return SceneImage{.floats = std::make_shared<const ImageF>(std::move(image->color))};
}

Status save(const std::string& path, const ImageForms& image) {
    const Result<ExrImage> layers = image.layers();
    return layers ? saveExr(path, *layers) : Status(layers.error());
}

}  // namespace

extern const ImageFormat kImageExr;
const ImageFormat kImageExr{.name = "EXR",
                            .extensions = ".exr",
                            .looksLike = looksLikeExr,
                            .decode = decode,
                            .save = save,
                            .hasLayers = true};

}  // namespace glint
