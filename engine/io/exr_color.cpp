// The picture among the channels of an OpenEXR file: which of them are its colour, in which primaries, and
// where on the display it lies.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/base/nearest_name.h"
#include "engine/io/atomic_file.h"
#include "engine/io/exr_file.h"
#include "engine/io/image_builder.h"

namespace glint {
namespace {

using DMat3 = glm::dmat3;
using DVec3 = glm::dvec3;

constexpr size_t kNone = static_cast<size_t>(-1);
/// CIE x, y of Rec.709's red, green, blue and D65: what files without chromaticities have.
constexpr std::array<Vec2, 4> kRec709{Vec2{0.64f, 0.33f}, Vec2{0.30f, 0.60f}, Vec2{0.15f, 0.06f},
                                      Vec2{0.3127f, 0.3290f}};
/// Names that programs give to the layer of the whole picture.
constexpr std::string_view kMainLayers[] = {"combined", "beauty", "rgba", "rgb", "color", "colour", "image"};

/// Where a layer's channels are, by their numbers in the part.
struct ColorChannels {
    std::string layer;  ///< "ViewLayer.Combined", empty for the file's own
    size_t rgb[3] = {kNone, kNone, kNone};
    size_t luminance = kNone;
    size_t chroma[2] = {kNone, kNone};  ///< RY and BY

    bool hasRgb() const { return std::ranges::find(rgb, kNone) == std::end(rgb); }
    bool hasChroma() const { return luminance != kNone && chroma[0] != kNone && chroma[1] != kNone; }
    bool hasColor() const { return hasRgb() || luminance != kNone; }
};

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return lower;
}

/// The layers of a part in the order of their names. Identifiers (Uint) are no colour, and of the channels
/// that are not there for each pixel only chroma is read.
std::map<std::string, ColorChannels> layersOf(const ExrPart& part) {
    std::map<std::string, ColorChannels> layers;
    for (size_t i = 0; i < part.channels.size(); ++i) {
        const ExrPartChannel& channel = part.channels[i];
        const size_t dot = channel.name.find_last_of('.');
        const std::string layer = dot == std::string::npos ? "" : channel.name.substr(0, dot);
        const std::string name = lowerCase(channel.name.substr(dot == std::string::npos ? 0 : dot + 1));
        const bool isWhole = channel.xSampling == 1 && channel.ySampling == 1;
        const bool isChroma = channel.xSampling <= 2 && channel.ySampling <= 2;
        if (channel.type == ExrPixelType::Uint) { continue; }
        ColorChannels& found = layers[layer];
        found.layer = layer;
        for (size_t c = 0; c < 3; ++c) {
            if (isWhole &&
                (name == std::string(1, "rgb"[c]) || name == std::array{"red", "green", "blue"}[c])) {
                found.rgb[c] = i;
            }
        }
        if (isWhole && name == "y") { found.luminance = i; }
        if (isChroma && name == "ry") { found.chroma[0] = i; }
        if (isChroma && name == "by") { found.chroma[1] = i; }
    }
    return layers;
}

/// The layer that is the picture: the file's own, the only one, or one with a usual name; null: none is.
const ColorChannels* mainLayer(const std::map<std::string, ColorChannels>& layers) {
    const ColorChannels* only = nullptr;
    size_t count = 0;
    for (const auto& [name, layer] : layers) {
        if (layer.hasColor() && name.empty()) { return &layer; }
        only = layer.hasRgb() ? &layer : only;
        count += layer.hasRgb() ? 1 : 0;
    }
    if (count == 1) { return only; }
    for (const std::string_view usual : kMainLayers) {
        for (const auto& [name, layer] : layers) {
            const size_t dot = name.find_last_of('.');
            if (layer.hasRgb() && lowerCase(name.substr(dot == std::string::npos ? 0 : dot + 1)) == usual) {
                return &layer;
            }
        }
    }
    return nullptr;
}

Error noColor(const ExrFile& file, const std::string& path) {
    constexpr size_t kShown = 12;
    std::vector<std::string_view> names;
    for (const ExrPart& part : file.parts()) {
        for (const ExrPartChannel& channel : part.channels) {
            names.push_back(channel.name);
        }
    }
    const std::string more = names.size() > kShown ? fmt::format(" and {} more", names.size() - kShown) : "";
    names.resize(std::min(names.size(), kShown));
    return imageError(
        path,
        fmt::format("has no colour; expected the channels R, G and B, or Y, in one layer, but found {}{}",
                    fmt::join(names, ", "), more));
}

/// From linear colours of these primaries to CIE XYZ, where their white has Y = 1 (SMPTE RP 177-1993).
DMat3 toXyz(const std::array<Vec2, 4>& primaries) {
    // A primary may have y = 0, as those of XYZ itself do: only its direction counts.
    const auto direction = [](const Vec2& xy) {
        const glm::dvec2 place(xy);
        return DVec3(place.x, place.y, 1.0 - place.x - place.y);
    };
    const DMat3 directions(direction(primaries[0]), direction(primaries[1]), direction(primaries[2]));
    const DVec3 white = direction(primaries[3]);
    const DVec3 scale = glm::inverse(directions) * (white / white.y);
    return DMat3(directions[0] * scale.x, directions[1] * scale.y, directions[2] * scale.z);
}

bool isFinite(const DMat3& m) {
    for (int i = 0; i < 9; ++i) {
        if (!std::isfinite(m[i / 3][i % 3])) { return false; }
    }
    return true;
}

/// What turns the file's colours into Rec.709's; nothing where they are that, or the chromaticities make
/// no sense.
std::optional<DMat3> toRec709(const ExrPart& part) {
    const auto isNear = [](const Vec2& a, const Vec2& b) { return glm::length(a - b) < 2e-4f; };
    if (!part.chromaticities || std::ranges::equal(*part.chromaticities, kRec709, isNear)) {
        return std::nullopt;
    }
    const DMat3 matrix = glm::inverse(toXyz(kRec709)) * toXyz(*part.chromaticities);
    return isFinite(matrix) ? std::optional(matrix) : std::nullopt;
}

/// The share of each channel in the luminance.
DVec3 luminanceWeights(const ExrPart& part) {
    const DMat3 matrix = toXyz(part.chromaticities.value_or(kRec709));
    const DMat3 usual = isFinite(matrix) ? matrix : toXyz(kRec709);
    const DVec3 weights(usual[0].y, usual[1].y, usual[2].y);
    return weights / (weights.x + weights.y + weights.z);
}

/// Chroma of every second column and row, or of all.
struct ChromaPlane {
    std::vector<float> values;
    int width = 0, height = 0, xSampling = 1, ySampling = 1;

    /// Between the samples linearly.
    float at(int x, int y) const {
        const int left = x / xSampling, top = y / ySampling;
        const int right = std::min(left + (x % xSampling != 0 ? 1 : 0), width - 1);
        const int bottom = std::min(top + (y % ySampling != 0 ? 1 : 0), height - 1);
        const auto value = [this](int column, int row) {
            return values[static_cast<size_t>(row) * static_cast<size_t>(width) +
                          static_cast<size_t>(column)];
        };
        return 0.25f * (value(left, top) + value(right, top) + value(left, bottom) + value(right, bottom));
    }
};

/// Luminance Y and chroma (R - Y) / Y, (B - Y) / Y to red, green and blue; Y stands in all of them already.
Status addChroma(ExrFile* file, const ExrPart& part, const ColorChannels& layer, ImageF* image) {
    ChromaPlane planes[2];
    std::vector<ExrTarget> targets;
    for (size_t i = 0; i < 2; ++i) {
        const ExrPartChannel& channel = part.channels[layer.chroma[i]];
        ChromaPlane& plane = planes[i];
        plane.xSampling = channel.xSampling;
        plane.ySampling = channel.ySampling;
        plane.width = (image->width + plane.xSampling - 1) / plane.xSampling;
        plane.height = (image->height + plane.ySampling - 1) / plane.ySampling;
        plane.values.resize(static_cast<size_t>(plane.width) * static_cast<size_t>(plane.height));
        targets.push_back({.channel = layer.chroma[i], .values = plane.values.data()});
    }
    if (Status read = file->read(part, targets); !read) { return read; }
    const DVec3 weights = luminanceWeights(part);
    for (int y = 0; y < image->height; ++y) {
        for (int x = 0; x < image->width; ++x) {
            float* rgb = &image->rgb[3 * (static_cast<size_t>(y) * static_cast<size_t>(image->width) +
                                          static_cast<size_t>(x))];
            const double luminance = rgb[0];
            const double red = (double{planes[0].at(x, y)} + 1.0) * luminance;
            const double blue = (double{planes[1].at(x, y)} + 1.0) * luminance;
            rgb[0] = static_cast<float>(red);
            rgb[1] = static_cast<float>((luminance - weights.x * red - weights.z * blue) / weights.y);
            rgb[2] = static_cast<float>(blue);
        }
    }
    return {};
}

Result<ImageF> readColor(ExrFile* file, const ExrPart& part, const ColorChannels& layer) {
    ImageF image{static_cast<int>(part.data.width()), static_cast<int>(part.data.height()), {}};
    image.rgb.resize(size_t{3} * static_cast<size_t>(image.width) * static_cast<size_t>(image.height));
    const size_t pixelBytes = 3 * sizeof(float);
    std::vector<ExrTarget> targets;
    for (size_t c = 0; c < (layer.hasRgb() ? 3 : 1); ++c) {
        targets.push_back({layer.hasRgb() ? layer.rgb[c] : layer.luminance, &image.rgb[c], pixelBytes});
    }
    if (Status read = file->read(part, targets); !read) { return read.error(); }
    if (!layer.hasRgb()) {
        for (size_t i = 0; i < image.rgb.size(); i += 3) {
            image.rgb[i + 1] = image.rgb[i + 2] = image.rgb[i];
        }
        if (layer.hasChroma()) {
            if (Status added = addChroma(file, part, layer, &image); !added) { return added.error(); }
        }
    }
    if (const std::optional<DMat3> matrix = toRec709(part)) {
        for (size_t i = 0; i < image.rgb.size(); i += 3) {
            const DVec3 color = *matrix * DVec3(image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]);
            for (int c = 0; c < 3; ++c) {
                image.rgb[i + static_cast<size_t>(c)] = static_cast<float>(color[c]);
            }
        }
    }
    return image;
}

/// The picture as the display window shows it, black where there are no data; all data where it shows none.
Result<ImageF> onDisplay(ImageF data, const ExrPart& part, const std::string& path) {
    const ExrWindow& display = part.display;
    const bool isBeside = display.maxX < part.data.minX || display.minX > part.data.maxX ||
                          display.maxY < part.data.minY || display.minY > part.data.maxY;
    if (display == part.data || isBeside) { return data; }
    const auto width = static_cast<uint64_t>(std::max(display.width(), int64_t{0}));
    const auto height = static_cast<uint64_t>(std::max(display.height(), int64_t{0}));
    if (Status size = checkStatedSize(path, width, height, 1, HUGE_VAL); !size) { return size.error(); }
    // An empty window costs the file nothing, so that it may be so much larger than what is in it.
    constexpr uint64_t kMostEmptyPixels = uint64_t{1} << 24;
    if (width * height > kMostEmptyPixels + 8 * data.rgb.size()) {
        return imageError(
            path, fmt::format("has data of {} x {} pixels in a display window of {} x {}; expected at "
                              "most {} pixels without data",
                              data.width, data.height, width, height, kMostEmptyPixels));
    }
    ImageF image{static_cast<int>(width), static_cast<int>(height), {}};
    image.rgb.resize(3 * static_cast<size_t>(width * height));
    const int64_t left = std::max(display.minX, part.data.minX);
    const int64_t columns = std::min(display.maxX, part.data.maxX) - left + 1;
    for (int64_t y = std::max(display.minY, part.data.minY);
         columns > 0 && y <= std::min(display.maxY, part.data.maxY); ++y) {
        const auto place = [&](const ExrWindow& window) {
            return 3 * ((y - window.minY) * window.width() + left - window.minX);
        };
        std::copy_n(data.rgb.begin() + place(part.data), 3 * columns, image.rgb.begin() + place(display));
    }
    return image;
}

}  // namespace

Result<ExrColorImage> decodeExrColor(std::string_view bytes, const std::string& path) {
    Result<ExrFile> file = ExrFile::open(bytes, path);
    if (!file) { return file.error(); }
    for (const ExrPart& part : file->parts()) {
        const std::map<std::string, ColorChannels> layers = layersOf(part);
        const ColorChannels* layer = mainLayer(layers);
        if (layer == nullptr) { continue; }
        Result<ImageF> color = readColor(&*file, part, *layer);
        if (!color) { return color.error(); }
        Result<ImageF> shown = onDisplay(std::move(*color), part, path);
        if (!shown) { return shown.error(); }
        return ExrColorImage{std::move(*shown), part.attributes};
    }
    return noColor(*file, path);
}

Result<ExrColorImage> loadExrColor(const std::string& path) {
    const Result<std::string> bytes = readFile(path);
    if (!bytes) { return bytes.error(); }
    return decodeExrColor(*bytes, path);
}

}  // namespace glint
