// Gathers the channels that go into an EXR file.
#include "engine/render/image_file.h"

#include <fmt/format.h>

#include "engine/io/file_path.h"
#include "engine/io/image_formats.h"
#include "engine/kernels/pass.h"
#include "engine/scene/scene_hash.h"

namespace glint {
namespace {

Error errorOfImage(const std::string& path, std::string message) {
    return {std::move(message), {.file = path}};
}

class ExrBuilder {
  public:
    ExrBuilder(int width, int height, ExrPixelType color) : color_(color) {
        image.width = width;
        image.height = height;
    }

    /// `valueAt(i)` is pixel i's value.
    template <class ValueAt>
    void addFloats(std::string name, ExrPixelType type, ValueAt valueAt) {
        ExrChannel channel{.name = std::move(name), .type = type, .floats = {}, .ids = {}};
        channel.floats.reserve(pixels());
        for (size_t i = 0; i < pixels(); ++i) {
            channel.floats.push_back(valueAt(i));
        }
        image.channels.push_back(std::move(channel));
    }

    template <class VectorAt>
    void addVectors(const std::string& layer, std::string_view axes, VectorAt vectorAt) {
        for (int axis = 0; axis < 3; ++axis) {
            addFloats(fmt::format("{}{}", layer, axes[static_cast<size_t>(axis)]), color_,
                      [&](size_t i) { return vectorAt(i)[axis]; });
        }
    }

    template <class IdAt>
    void addIds(std::string name, IdAt idAt) {
        ExrChannel channel{.name = std::move(name), .type = ExrPixelType::Uint, .floats = {}, .ids = {}};
        channel.ids.reserve(pixels());
        for (size_t i = 0; i < pixels(); ++i) {
            channel.ids.push_back(idAt(i));
        }
        image.channels.push_back(std::move(channel));
    }

    ExrImage image;

  private:
    size_t pixels() const { return static_cast<size_t>(image.width) * static_cast<size_t>(image.height); }

    ExrPixelType color_;
};

void addAovs(const std::vector<AovSample>& samples, uint32_t aovs, ExrBuilder* out) {
    if ((aovs & kAovAlbedo) != 0) {
        out->addVectors("albedo.", "RGB", [&](size_t i) { return samples[i].albedo; });
    }
    if ((aovs & kAovShadingNormal) != 0) {
        out->addVectors("normal.", "XYZ", [&](size_t i) { return samples[i].shadingNormal; });
    }
    if ((aovs & kAovGeometricNormal) != 0) {
        out->addVectors("geometricNormal.", "XYZ", [&](size_t i) { return samples[i].geometricNormal; });
    }
    if ((aovs & kAovDepth) != 0) {
        out->addFloats("depth.Z", ExrPixelType::Float, [&](size_t i) { return samples[i].depth; });
    }
    if ((aovs & kAovObjectId) != 0) {
        out->addIds("objectId.id", [&](size_t i) { return samples[i].objectId; });
    }
    if ((aovs & kAovMaterialId) != 0) {
        out->addIds("materialId.id", [&](size_t i) { return samples[i].materialId; });
    }
    if ((aovs & kAovBoxesTested) != 0) {
        out->addFloats("boxesTested.Y", ExrPixelType::Float,
                       [&](size_t i) { return samples[i].boxesTested; });
    }
    if ((aovs & kAovPrimitivesTested) != 0) {
        out->addFloats("trianglesTested.Y", ExrPixelType::Float,
                       [&](size_t i) { return samples[i].primitivesTested; });
    }
    if ((aovs & kAovNewtonSteps) != 0) {
        out->addFloats("newtonSteps.Y", ExrPixelType::Float,
                       [&](size_t i) { return samples[i].newtonSteps; });
    }
}

std::map<std::string, std::string> metadata(const FilmSnapshot& snapshot, const SceneDescription& scene) {
    std::map<std::string, std::string> out{{"glintVersion", GLINT_VERSION},
                                           {"sceneHash", sceneHash(scene).hex()},
                                           {"passes", fmt::to_string(snapshot.passes)},
                                           {"renderSeconds", fmt::to_string(snapshot.renderSeconds)},
                                           {"relativeError", fmt::to_string(snapshot.relativeError)},
                                           {"relativeErrorLow", fmt::to_string(snapshot.relativeErrorLow)},
                                           {"relativeErrorHigh", fmt::to_string(snapshot.relativeErrorHigh)}};
    if (snapshot.isDenoised) { out["denoised"] = "yes"; }
    for (const Setting& setting : renderSettings(scene)) {
        out["setting." + setting.name] = setting.value;
    }
    return out;
}

Result<ExrImage> layersOf(const std::string& path, const FilmSnapshot& snapshot,
                          const SceneDescription& scene, const ImageOptions& options) {
    const size_t pixels = static_cast<size_t>(snapshot.width) * static_cast<size_t>(snapshot.height);
    if (options.aovs != 0 && (!snapshot.aovs || snapshot.aovs->pixels().size() != pixels)) {
        return errorOfImage(path, "the layers asked for were not rendered; expected them in the picture");
    }
    ExrBuilder builder(snapshot.width, snapshot.height, options.exrColor);
    builder.addVectors("", "RGB", [&](size_t i) {
        return Vec3(snapshot.radiance[3 * i], snapshot.radiance[3 * i + 1], snapshot.radiance[3 * i + 2]);
    });
    if (options.aovs != 0) { addAovs(snapshot.aovs->pixels(), options.aovs, &builder); }
    if (snapshot.standardError.size() == pixels) {
        builder.addFloats("standardError.Y", ExrPixelType::Float,
                          [&](size_t i) { return snapshot.standardError[i]; });
    }
    if (snapshot.bias.size() == pixels) {
        builder.addFloats("bias.Y", ExrPixelType::Float, [&](size_t i) { return snapshot.bias[i]; });
    }
    if (snapshot.errorBound.size() == pixels) {
        builder.addFloats("errorBound.Y", ExrPixelType::Float,
                          [&](size_t i) { return snapshot.errorBound[i]; });
    }
    builder.image.attributes = metadata(snapshot, scene);
    return std::move(builder.image);
}

}  // namespace

Status saveImage(const std::string& path, const FilmSnapshot& snapshot, const SceneDescription& scene,
                 const ImageOptions& options) {
    const size_t pixels = static_cast<size_t>(snapshot.width) * static_cast<size_t>(snapshot.height);
    if (pixels == 0 || snapshot.radiance.size() != 3 * pixels || snapshot.previewScale != 1) {
        return errorOfImage(path, "there is no picture at full resolution to save yet");
    }
    const ImageFormat* format = savedFormatOf(path);
    if (format == nullptr) {
        return errorOfImage(path, fmt::format("cannot tell the format from \"{}\"; expected {}",
                                              extensionOf(path), listSavedExtensions()));
    }
    return format->save(path, {.display =
                                   [&] {
                                       return toneMapImage(snapshot.radiance.data(), snapshot.width,
                                                           snapshot.height, options.look, options.threads);
                                   },
                               .radiance =
                                   [&] {
                                       return ImageF{snapshot.width, snapshot.height, snapshot.radiance};
                                   },
                               .layers = [&] { return layersOf(path, snapshot, scene, options); }});
}

}  // namespace glint
