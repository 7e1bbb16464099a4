#include "engine/builders/environment_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/log.h"
#include "engine/base/parallel.h"
#include "engine/math/color.h"

namespace glint {
namespace {

std::shared_ptr<const ImageF> linearImage(const SceneImage& source, int threads) {
    if (source.floats) { return source.floats; }
    if (!source.bytes) { return nullptr; }
    auto image = std::make_shared<ImageF>();
    image->width = source.bytes->width;
    image->height = source.bytes->height;
    image->rgb.resize(source.bytes->rgb.size());
    parallelChunks(static_cast<int64_t>(image->rgb.size()), 1 << 16, threads,
                   [&](int64_t begin, int64_t end) {
                       for (int64_t i = begin; i < end; ++i) {
                           const auto k = static_cast<size_t>(i);
                           image->rgb[k] = srgbToLinear(static_cast<float>(source.bytes->rgb[k]) / 255.0f);
                       }
                   });
    return image;
}

double texelLuminance(const ImageF& image, int x, int y) {
    const int column = (x + image.width) % image.width;
    const int row = std::clamp(y, 0, image.height - 1);
    const float* rgb = image.rgb.data() + 3 * (static_cast<size_t>(row) * static_cast<size_t>(image.width) +
                                               static_cast<size_t>(column));
    const float value = luminance({rgb[0], rgb[1], rgb[2]});
    return std::isfinite(value) ? std::max(0.0, static_cast<double>(value)) : 0.0;
}

/// Mean over a texel's cell of the bilinear interpolation: along each axis the neighbours weigh 1/8, 3/4,
/// 1/8, the integrals of their hat functions over it.
double cellLuminance(const ImageF& image, int x, int y) {
    constexpr double kWeights[3] = {0.125, 0.75, 0.125};
    double sum = 0.0;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            sum += kWeights[dy + 1] * kWeights[dx + 1] * texelLuminance(image, x + dx, y + dy);
        }
    }
    return sum;
}

/// Makes `cdf` (count + 1 entries) the normalised running sum of `weights`, uniform where all are 0; returns
/// the sum.
double fillCdf(const std::vector<double>& weights, float* cdf) {
    const size_t count = weights.size();
    double sum = 0.0;
    for (const double weight : weights) {
        sum += weight;
    }
    double running = 0.0;
    cdf[0] = 0.0f;
    for (size_t i = 0; i < count; ++i) {
        running += sum > 0.0 ? weights[i] / sum : 1.0 / static_cast<double>(count);
        cdf[i + 1] = std::min(1.0f, static_cast<float>(running));
    }
    // Entries that already rounded to 1 stay: nothing above them could be chosen anyway.
    cdf[count] = 1.0f;
    return sum;
}

/// A picture that packs well may be small as a file.
void warnOfSize(const SceneImage& source) {
    constexpr double kBytesAPixel = 4 * sizeof(float), kManyBytes = 1e9;
    const int width = source.floats ? source.floats->width : source.bytes ? source.bytes->width : 0;
    const int height = source.floats ? source.floats->height : source.bytes ? source.bytes->height : 0;
    const double bytes = kBytesAPixel * width * height;
    if (bytes > kManyBytes) {
        logWarning("the environment's image has {}x{} pixels, which take {:.1f} GB of memory", width, height,
                   1e-9 * bytes);
    }
}

}  // namespace

EnvironmentView EnvironmentTable::view() const {
    EnvironmentView v;
    v.texels = image->rgb.data();
    v.rowCdf = rowCdf.data();
    v.columnCdf = columnCdf.data();
    v.width = image->width;
    v.height = image->height;
    return v;
}

size_t EnvironmentTable::bytes() const {
    return image->rgb.size() * sizeof(float) + (rowCdf.size() + columnCdf.size()) * sizeof(float);
}

std::shared_ptr<const EnvironmentTable> buildEnvironmentTable(const SceneImage& source, int threads) {
    warnOfSize(source);
    auto table = std::make_shared<EnvironmentTable>();
    table->source = source;
    table->image = linearImage(source, threads);
    if (!table->image || table->image->width <= 0 || table->image->height <= 0) { return nullptr; }
    const ImageF& image = *table->image;
    const auto width = static_cast<size_t>(image.width);
    const auto height = static_cast<size_t>(image.height);
    table->columnCdf.resize(height * (width + 1));
    table->rowCdf.resize(height + 1);

    std::vector<double> rowWeights(height);
    parallelChunks(image.height, 16, threads, [&](int64_t begin, int64_t end) {
        std::vector<double> cells(width);
        for (int64_t row = begin; row < end; ++row) {
            for (size_t x = 0; x < width; ++x) {
                cells[x] = cellLuminance(image, static_cast<int>(x), static_cast<int>(row));
            }
            const double step = std::numbers::pi / static_cast<double>(height);
            const double solidAngle =
                std::cos(step * static_cast<double>(row)) - std::cos(step * static_cast<double>(row + 1));
            const auto y = static_cast<size_t>(row);
            rowWeights[y] = fillCdf(cells, table->columnCdf.data() + y * (width + 1)) * solidAngle;
        }
    });
    // Solid angles of all rows sum to 2, and each row has `width` cells.
    table->meanLuminance =
        static_cast<float>(fillCdf(rowWeights, table->rowCdf.data()) / (2.0 * static_cast<double>(width)));
    return table;
}

}  // namespace glint
