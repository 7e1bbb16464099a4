#include "engine/builders/environment_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/log.h"
#include "engine/base/parallel.h"
#include "engine/kernels/environment.h"
#include "engine/math/color.h"

namespace glint {
namespace {

/// Without its distribution.
EnvironmentView texelsOf(const EnvironmentTable& table) {
    EnvironmentView v;
    if (const ImageF* floats = table.source.floats.get()) {
        v.texels = floats->rgb.data();
        v.width = floats->width;
        v.height = floats->height;
    } else if (const Image8* bytes = table.source.bytes.get()) {
        v.bytes = bytes->rgb.data();
        v.decoded = table.decoded.data();
        v.width = bytes->width;
        v.height = bytes->height;
    }
    return v;
}

double texelLuminance(const EnvironmentView& image, int x, int y) {
    const float value = luminance(environmentTexel(image, x, y));
    return std::isfinite(value) ? std::max(0.0, static_cast<double>(value)) : 0.0;
}

/// Mean over a texel's cell of the bilinear interpolation: along each axis the neighbours weigh 1/8, 3/4,
/// 1/8, the integrals of their hat functions over it.
double cellLuminance(const EnvironmentView& image, int x, int y) {
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
void warnOfSize(const EnvironmentView& image, size_t bytes) {
    constexpr double kManyBytes = 1e9;
    if (static_cast<double>(bytes) > kManyBytes) {
        logWarning("the environment's image has {}x{} pixels, which take {:.1f} GB of memory", image.width,
                   image.height, 1e-9 * static_cast<double>(bytes));
    }
}

}  // namespace

EnvironmentView EnvironmentTable::view() const {
    EnvironmentView v = texelsOf(*this);
    v.rowCdf = rowCdf.data();
    v.columnCdf = columnCdf.data();
    return v;
}

size_t EnvironmentTable::bytes() const {
    const size_t texels = source.floats ? source.floats->rgb.size() * sizeof(float)
                                        : source.bytes->rgb.size() + decoded.size() * sizeof(float);
    return texels + (rowCdf.size() + columnCdf.size()) * sizeof(float);
}

std::shared_ptr<const EnvironmentTable> buildEnvironmentTable(const SceneImage& source, int threads) {
    auto table = std::make_shared<EnvironmentTable>();
    table->source = source;
    for (int byte = 0; source.bytes && byte < 256; ++byte) {
        table->decoded.push_back(srgbToLinear(static_cast<float>(byte) / 255.0f));
    }
    const EnvironmentView image = texelsOf(*table);
    if (image.width <= 0 || image.height <= 0) { return nullptr; }
    const auto width = static_cast<size_t>(image.width);
    const auto height = static_cast<size_t>(image.height);
    warnOfSize(image, table->bytes() + (height * (width + 1) + height + 1) * sizeof(float));
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
