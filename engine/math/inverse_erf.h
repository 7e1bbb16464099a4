// The inverse of the error function without a library call. Host and device.
#pragma once

#include "engine/math/log.h"
#include "engine/math/vec.h"

namespace glint {

/// That of a standard normal variable with 5 % beyond it.
constexpr double kNormal95 = 1.6448536269514722;

/// -log(1 - v^2) for |v| <= 1, finite.
GLINT_HD inline float minusLogOneMinusSquare(float v) {
    return -naturalLog(maxf((1.0f - v) * (1.0f + v), 1e-12f));
}

/// Inverse of the error function for |v| < 1 (Giles 2010, "Approximating the erfinv function", single
/// precision, both branches): relative error below 4e-7.
/// At -1 and 1 it is about 5.1 to either side.
GLINT_HD inline float inverseErf(float v) {
    const float minusLog = minusLogOneMinusSquare(v);
    float p;
    if (minusLog < 5.0f) {
        const float w = minusLog - 2.5f;
        p = 2.81022636e-08f;
        p = 3.43273939e-07f + p * w;
        p = -3.5233877e-06f + p * w;
        p = -4.39150654e-06f + p * w;
        p = 0.00021858087f + p * w;
        p = -0.00125372503f + p * w;
        p = -0.00417768164f + p * w;
        p = 0.246640727f + p * w;
        p = 1.50140941f + p * w;
    } else {
        const float w = std::sqrt(minusLog) - 3.0f;
        p = -0.000200214257f;
        p = 0.000100950558f + p * w;
        p = 0.00134934322f + p * w;
        p = -0.00367342844f + p * w;
        p = 0.00573950773f + p * w;
        p = -0.0076224613f + p * w;
        p = 0.00943887047f + p * w;
        p = 1.00167406f + p * w;
        p = 2.83297682f + p * w;
    }
    return p * v;
}

}  // namespace glint
