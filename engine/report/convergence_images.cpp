#include "engine/report/convergence_images.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "engine/io/image_io.h"
#include "engine/render/tonemap.h"
#include "engine/report/error_maps.h"

namespace glint {
namespace {

/// The variant's text with nothing in it that a file system could mind.
std::string fileName(std::string text) {
    for (char& c : text) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '+';
        c = plain ? c : '-';
    }
    return text;
}

/// What the reference's own noise adds to the relative squared error, as a map.
ErrorMap ownErrorMap(const ReferenceImage& reference) {
    const double epsilon = MetricOptions().relativeEpsilon;
    ErrorMap map{ErrorMapKind::RelativeSquared, reference.image.width, reference.image.height, {}};
    for (size_t i = 0; i < reference.variance.size(); i += 3) {
        double sum = 0.0;
        for (size_t c = i; c < i + 3; ++c) {
            const double value = static_cast<double>(reference.image.rgb[c]);
            sum += static_cast<double>(reference.variance[c]) / (value * value + epsilon) / 3.0;
        }
        map.values.push_back(static_cast<float>(sum));
    }
    return map;
}

/// Of the values above zero; `otherwise` without any.
double positiveQuantile(std::vector<float> values, double share, double otherwise) {
    std::erase_if(values, [](float value) { return !(value > 0.0f) || !std::isfinite(value); });
    if (values.empty()) { return otherwise; }
    const auto at =
        values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return static_cast<double>(*at);
}

class ImageFolder {
  public:
    ImageFolder(const std::string& folder, const ConvergencePlan& plan, const ReferenceImage& reference)
        : folder_(folder), plan_(plan), reference_(reference) {}

    /// The maps' common range: from where a tenth of the best last picture lies below, to where a tenth of
    /// the worst first one lies above. Single bright pixels would stretch it beyond use.
    Status chooseRange(const ConvergenceResult& result) {
        double low = 1e-2, high = 0.0;
        for (const MeasuredVariant& variant : result.variants) {
            for (const KeptImage& kept : variant.images) {
                const auto map = errorMap(ErrorMapKind::RelativeSquared, kept.image, reference_.image);
                if (!map) { return map.error(); }
                low = std::min(low, positiveQuantile(map->values, 0.1, low));
                high = std::max(high, positiveQuantile(map->values, 0.9, high));
            }
        }
        range_.logarithmic = true;
        range_.high = std::pow(10.0, std::ceil(std::log10(std::clamp(high, 1e-9, 1e9))));
        range_.low =
            std::pow(10.0, std::floor(std::log10(std::clamp(low, 1e-6 * range_.high, 0.1 * range_.high))));
        return {};
    }

    Status save(const std::string& name, const ImageF& image) const {
        return savePng(path(name), toneMapImage(image.rgb.data(), image.width, image.height,
                                                {static_cast<float>(plan_.exposureStops)}, 0));
    }

    Status saveMap(const std::string& name, const ErrorMap& map) const {
        return savePng(path(name), falseColors(map, range_));
    }

    Status saveKept(const MeasuredVariant& variant, KeptImage* kept) const {
        const uint32_t passes = variant.curves.front().points[kept->point].passes;
        const std::string stem = fmt::format("pictures/{}-{}", fileName(variant.variant.text), passes);
        kept->file = stem + ".png";
        kept->errorFile = stem + "-error.png";
        if (Status saved = save(kept->file, kept->image); !saved) { return saved; }
        const auto map = errorMap(ErrorMapKind::RelativeSquared, kept->image, reference_.image);
        return map ? saveMap(kept->errorFile, *map) : Status(map.error());
    }

    const MapRange& range() const { return range_; }

  private:
    std::string path(const std::string& name) const {
        return (std::filesystem::path(folder_) / name).string();
    }

    const std::string& folder_;
    const ConvergencePlan& plan_;
    const ReferenceImage& reference_;
    MapRange range_;
};

}  // namespace

Result<ImageLegend> saveImages(const std::string& folder, const ConvergencePlan& plan,
                               const ReferenceImage& reference, ConvergenceResult* result) {
    std::error_code problem;
    std::filesystem::create_directories(std::filesystem::path(folder) / "pictures", problem);
    if (problem) { return Error{fmt::format("{}/pictures: {}", folder, problem.message()), {}}; }
    ImageFolder out(folder, plan, reference);
    if (const Status chosen = out.chooseRange(*result); !chosen) { return chosen.error(); }
    if (const Status saved = out.save("pictures/reference.png", reference.image); !saved) {
        return saved.error();
    }
    if (reference.knowsItsError()) {
        const Status saved = out.saveMap("pictures/reference-error.png", ownErrorMap(reference));
        if (!saved) { return saved.error(); }
    }
    for (MeasuredVariant& variant : result->variants) {
        for (KeptImage& kept : variant.images) {
            if (const Status saved = out.saveKept(variant, &kept); !saved) { return saved.error(); }
        }
    }
    return ImageLegend{out.range().low, out.range().high};
}

}  // namespace glint
