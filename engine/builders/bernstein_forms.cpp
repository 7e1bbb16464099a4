#include "engine/builders/bernstein_forms.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/math/bernstein.h"
#include "engine/math/vec.h"

namespace glint {
namespace {

double binomial(int n, int k) {
    double value = 1.0;
    for (int i = 0; i < k; ++i) {
        value = value * (n - i) / (i + 1);
    }
    return value;
}

}  // namespace

void multiplyBernstein(const double* f, const double* g, int degree, double* product) {
    std::fill(product, product + 2 * degree + 1, 0.0);
    for (int i = 0; i <= degree; ++i) {
        for (int j = 0; j <= degree; ++j) {
            product[i + j] +=
                binomial(degree, i) * binomial(degree, j) / binomial(2 * degree, i + j) * f[i] * g[j];
        }
    }
    product[0] = f[0] * g[0];
    product[2 * degree] = f[degree] * g[degree];
}

void bernsteinToPowers(const double* bernstein, int degree, int axis, double (*powers)[2]) {
    std::vector<double> differences(bernstein, bernstein + degree + 1);
    for (int i = 0; i <= degree; ++i) {
        powers[i][axis] = binomial(degree, i) * differences[0];
        for (size_t k = 0; k + 1 < differences.size(); ++k) {
            differences[k] = differences[k + 1] - differences[k];
        }
        differences.pop_back();
    }
}

double lowerBernsteinDegree(double* f, int degree) {
    double from[kMaxProfileDegree + 1], backwards[kMaxProfileDegree + 1] = {};
    std::copy(f, f + degree + 1, from);
    f[degree] = 0.0;
    backwards[degree - 1] = from[degree];
    for (int i = degree - 1; i > 0; --i) {
        const double share = static_cast<double>(i) / degree;
        backwards[i - 1] = (from[i] - (1.0 - share) * backwards[i]) / share;
    }
    double forwards = from[0], weight = std::ldexp(1.0, 1 - 2 * degree);
    for (int i = 1; i < degree; ++i) {
        const double share = static_cast<double>(i) / degree;
        forwards = (from[i] - share * forwards) / (1.0 - share);
        weight += std::ldexp(binomial(2 * degree, 2 * i), 1 - 2 * degree);
        f[i] = i + 1 < degree ? forwards + weight * (backwards[i] - forwards) : backwards[i];
    }
    const int points = 4 * degree;
    double most = 0.0;
    for (int i = 0; i < points; ++i) {
        const double s = 0.5 - 0.5 * std::cos(kPiD * (i + 0.5) / points);
        most = std::max(most, std::fabs(evaluateBernstein<kMaxProfileDegree>(f, degree - 1, s).value -
                                        evaluateBernstein<kMaxProfileDegree>(from, degree, s).value));
    }
    return most / std::cos(kPiD / 8.0);
}

QuadraticFit fitQuadratic(const double* f, int degree) {
    const double middle = evaluateBernstein<2 * kMaxProfileDegree>(f, degree, 0.5).value;
    QuadraticFit fit{{f[0], 2.0 * middle - 0.5 * (f[0] + f[degree]), f[degree]}, 0.0, 0.0, 0.0};
    std::vector<double> off;
    for (int i = 0; i <= degree; ++i) {
        // The quadratic's coefficient with its degree raised.
        const double n = degree, k = i;
        off.push_back(f[i] - ((n - k) * (n - k - 1.0) * fit.value[0] + 2.0 * k * (n - k) * fit.value[1] +
                              k * (k - 1.0) * fit.value[2]) /
                                 (n * (n - 1.0)));
    }
    for (double* error : {&fit.error, &fit.slopeError, &fit.curvatureError}) {
        const double factor = static_cast<double>(off.size() - 1);
        for (size_t i = 0; i < off.size(); ++i) {
            *error = std::max(*error, std::fabs(off[i]));
            off[i] = i + 1 < off.size() ? factor * (off[i + 1] - off[i]) : 0.0;
        }
        off.pop_back();
    }
    return fit;
}

}  // namespace glint
