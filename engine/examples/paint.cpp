#include "engine/examples/paint.h"

namespace glint::examples {

double Noise::smooth(double u, double v, int cellsU, int cellsV) const {
    const double x = u * cellsU, y = v * cellsV;
    const double fx = std::floor(x), fy = std::floor(y);
    const auto wrap = [](double c, int cells) {
        const auto i = static_cast<int64_t>(c) % cells;
        return i < 0 ? i + cells : i;
    };
    const int64_t x0 = wrap(fx, cellsU), x1 = wrap(fx + 1.0, cellsU);
    const int64_t y0 = wrap(fy, cellsV), y1 = wrap(fy + 1.0, cellsV);
    const double tx = ramp(0.0, 1.0, x - fx), ty = ramp(0.0, 1.0, y - fy);
    return mix(mix(cell(x0, y0), cell(x1, y0), tx), mix(cell(x0, y1), cell(x1, y1), tx), ty);
}

double Noise::cloud(double u, double v, int cellsU, int cellsV, int octaves) const {
    double sum = 0.0, total = 0.0, strength = 1.0;
    for (int octave = 0; octave < octaves; ++octave) {
        // Each octave begins elsewhere, or their cells' corners would show as a lattice.
        const double offset = cell(-1 - octave, 0);
        sum += strength * smooth(u + offset, v + offset, cellsU << octave, cellsV << octave);
        total += strength;
        strength *= 0.5;
    }
    return sum / total;
}

Masonry::Place Masonry::at(double u, double v) const {
    const double y = v * courses;
    const int row = static_cast<int>(std::floor(y));
    const double x = u * blocks + (row % 2 == 0 ? 0.0 : 0.5);
    const int column = static_cast<int>(std::floor(x)) % blocks;
    const double fu = fraction(x), fv = fraction(y);
    const auto edge = [](double f, double joint) { return ramp(joint, 2.5 * joint, std::min(f, 1.0 - f)); };
    return {std::min(edge(fu, jointU), edge(fv, jointV)), column, row, fu, fv};
}

}  // namespace glint::examples
