// The page's pictures, as data inside it.
#include <filesystem>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/image_io.h"
#include "engine/report/convergence_page_parts.h"
#include "engine/report/heat_map.h"
#include "engine/report/html_text.h"

namespace glint {
namespace {

/// Box-filtered down by a whole factor, in display values.
Image8 reduced(const Image8& image, int factor) {
    Image8 out{image.width / factor, image.height / factor, {}};
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < 3 * out.width; ++x) {
            int sum = 0;
            for (int k = 0; k < factor * factor; ++k) {
                const int row = y * factor + k / factor, column = x / 3 * factor + k % factor;
                sum += image.rgb[3 * (static_cast<size_t>(row) * static_cast<size_t>(image.width) +
                                      static_cast<size_t>(column)) +
                                 static_cast<size_t>(x % 3)];
            }
            out.rgb.push_back(static_cast<uint8_t>(sum / (factor * factor)));
        }
    }
    return out;
}

class PageImages {
  public:
    PageImages(const ConvergenceReport& report, const std::string& folder, const ImageLegend& legend)
        : report_(report), folder_(folder), legend_(legend) {}

    std::string write() const {
        std::string out = fmt::format(
            "<h2>Pictures of the first seed, and where they are wrong</h2>\n<p class=\"soft\">Error maps: "
            "relative squared error, logarithmic, {:.0e} <span class=\"ramp\" style=\"background:"
            "linear-gradient(to right{})\"></span> {:.0e}, the same for all.</p>\n"
            "<h3>Reference</h3>\n<div class=\"pictures\">\n",
            legend_.low, rampStops(), legend_.high);
        out += figure("pictures/reference.png", "the reference");
        if (report_.reference.knowsItsError()) {
            out += figure("pictures/reference-error.png", "its own squared standard error, relative");
        }
        out += "</div>\n";
        for (size_t i = 0; i < report_.result.variants.size(); ++i) {
            if (const std::string shown = imagesOf(report_.result.variants[i]); !shown.empty()) {
                out += fmt::format("<h3>{}</h3>\n<div class=\"pictures\">\n{}</div>\n", pageName(report_, i),
                                   shown);
            }
        }
        return out;
    }

  private:
    static std::string rampStops() {
        std::string stops;
        for (int i = 0; i <= 8; ++i) {
            const Vec3 color = heatColor(static_cast<float>(i) / 8.0f) * 255.0f;
            stops += fmt::format(",rgb({:.0f} {:.0f} {:.0f})", color.x, color.y, color.z);
        }
        return stops;
    }

    std::string imagesOf(const MeasuredVariant& variant) const {
        std::string out;
        for (const KeptImage& kept : variant.images) {
            const MeasuredPoint& point = variant.curves.front().points[kept.point];
            out += figure(kept.file, fmt::format("{} s, {} pass{}", secondsText(point.seconds), point.passes,
                                                 point.passes == 1 ? "" : "es"));
            const double error = at(point.errors, ErrorMeasure::RelativeError);
            out += figure(kept.errorFile, "relative error " + pagePercent(error));
        }
        return out;
    }

    /// An <img> with the picture inside, or nothing.
    std::string image(const std::string& file, const std::string& about) const {
        const std::string path = (std::filesystem::path(folder_) / file).string();
        Result<std::string> bytes = readFile(path);
        if (!bytes) { return {}; }
        const int width = report_.scene.resolution.width;
        if (width > kMostPagePixels) {
            const auto whole = loadImage8(path);
            const std::string small = path + ".small.png";
            const int factor = (width + kMostPagePixels - 1) / kMostPagePixels;
            if (whole && (*whole)->height >= factor && savePng(small, reduced(**whole, factor))) {
                Result<std::string> fewer = readFile(small);
                bytes = fewer ? std::move(fewer) : std::move(bytes);
            }
            std::error_code ignored;
            std::filesystem::remove(small, ignored);
        }
        return fmt::format("<img alt=\"{0}\" title=\"{0}\" src=\"data:image/png;base64,{1}\">",
                           htmlText(about), base64(*bytes));
    }

    std::string figure(const std::string& file, const std::string& caption) const {
        const std::string tag = image(file, caption);
        return tag.empty()
                   ? ""
                   : fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", tag, htmlText(caption));
    }

    const ConvergenceReport& report_;
    const std::string& folder_;
    const ImageLegend& legend_;
};

}  // namespace

std::string pageImages(const ConvergenceReport& report, const std::string& folder,
                       const ImageLegend& legend) {
    return PageImages(report, folder, legend).write();
}

}  // namespace glint
