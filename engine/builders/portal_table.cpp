#include "engine/builders/portal_table.h"

#include <algorithm>
#include <cmath>

#include "engine/base/parallel.h"
#include "engine/kernels/environment.h"
#include "engine/math/color.h"

namespace glint {
namespace {

/// As many columns span 180 degrees as the image has there, within bounds.
constexpr int kFewestCells = 128, kMostCells = 1024;
/// Of a cell along either side: places at which its light is looked at.
constexpr int kPlaces = 2;

struct Cell {
    double light = 0.0;  ///< luminance times solid angle
    double solidAngle = 0.0;
    double flux = 0.0;  ///< luminance times solid angle times cosine
};

class Square {
  public:
    Square(const EnvironmentView& image, const Mat3& frame, int size)
        : image_(image), frame_(frame), step_(kPiD / (size * kPlaces)) {
        for (int place = 0; place < size * kPlaces; ++place) {
            ratios_.push_back(std::tan(step_ * (place + 0.5) - 0.5 * kPiD));
        }
    }

    Cell cell(int column, int row) const {
        Cell cell;
        for (int y = row * kPlaces; y < (row + 1) * kPlaces; ++y) {
            for (int x = column * kPlaces; x < (column + 1) * kPlaces; ++x) {
                add(ratios_[static_cast<size_t>(x)], ratios_[static_cast<size_t>(y)], &cell);
            }
        }
        return cell;
    }

  private:
    /// A direction by its ratios to the normal: d(solid angle) = (1 - u^2) (1 - v^2) / normal d(angles).
    void add(double ratioU, double ratioV, Cell* cell) const {
        const double cosine = 1.0 / std::sqrt(1.0 + ratioU * ratioU + ratioV * ratioV);
        const double u = ratioU * cosine, v = ratioV * cosine;
        const double solidAngle =
            (v * v + cosine * cosine) * (u * u + cosine * cosine) / cosine * step_ * step_;
        const Vec3 w = frame_ * Vec3(glm::dvec3(u, v, -cosine));
        const float found = luminance(environmentLookup(image_, environmentUv(toEnvironment(image_, w))));
        const double light = std::isfinite(found) && found > 0.0f ? static_cast<double>(found) : 0.0;
        cell->solidAngle += solidAngle;
        cell->light += light * solidAngle;
        cell->flux += light * solidAngle * cosine;
    }

    EnvironmentView image_;
    Mat3 frame_;
    double step_;
    std::vector<double> ratios_;  ///< of each place to the normal, alike along u and v
};

/// Of light and solid angle of each cell.
std::vector<double> runningSums(const std::vector<Cell>& cells, size_t size) {
    Cell all;
    for (const Cell& cell : cells) {
        all.light += cell.light;
        all.solidAngle += cell.solidAngle;
    }
    const double least = all.light > 0.0 ? 1e-3 * all.light / all.solidAngle : 1.0;
    std::vector<double> sums((size + 1) * (size + 1), 0.0);
    for (size_t y = 0; y < size; ++y) {
        double row = 0.0;
        for (size_t x = 0; x < size; ++x) {
            const Cell& cell = cells[y * size + x];
            row += cell.light + least * cell.solidAngle;
            sums[(y + 1) * (size + 1) + x + 1] = sums[y * (size + 1) + x + 1] + row;
        }
    }
    return sums;
}

}  // namespace

EmitterData portalOpening(const Environment& environment) {
    const std::vector<Vec3>& c = environment.portal;
    const Vec3 u = 0.25f * ((c[1] - c[0]) + (c[2] - c[3]));
    const Vec3 v = 0.25f * ((c[3] - c[0]) + (c[2] - c[1]));
    EmitterData e;
    e.position = 0.25f * ((c[0] + c[1]) + (c[2] + c[3]));
    e.direction = glm::normalize(glm::cross(u, v));
    e.axisU = u;
    e.axisV = glm::normalize(glm::cross(e.direction, u)) * glm::length(v);
    e.area = 4.0f * glm::length(u) * glm::length(v);
    e.shape = ShapeKind::Rectangle;
    e.keepsAngles = true;
    return e;
}

std::shared_ptr<const PortalSums> buildPortalSums(const SceneImage& source, const EnvironmentView& image,
                                                  float rotationRad, const EmitterData& opening,
                                                  const std::shared_ptr<const PortalSums>& previous,
                                                  int threads) {
    const Mat3 frame(glm::normalize(opening.axisU), glm::normalize(opening.axisV), opening.direction);
    if (previous && previous->source.bytes == source.bytes && previous->source.floats == source.floats &&
        previous->frame == frame && previous->rotationRad == rotationRad) {
        return previous;
    }
    auto table = std::make_shared<PortalSums>();
    table->source = source;
    table->frame = frame;
    table->rotationRad = rotationRad;
    table->size = std::clamp(image.width / 2, kFewestCells, kMostCells);
    const Square square(image, frame, table->size);
    const auto size = static_cast<size_t>(table->size);
    std::vector<Cell> cells(size * size);
    parallelChunks(table->size, 16, threads, [&](int64_t begin, int64_t end) {
        for (int64_t row = begin; row < end; ++row) {
            for (size_t column = 0; column < size; ++column) {
                cells[static_cast<size_t>(row) * size + column] =
                    square.cell(static_cast<int>(column), static_cast<int>(row));
            }
        }
    });
    double flux = 0.0;
    for (const Cell& cell : cells) {
        flux += cell.flux;
    }
    table->irradiance = static_cast<float>(flux);
    table->sums = runningSums(cells, size);
    return table;
}

}  // namespace glint
