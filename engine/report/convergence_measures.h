// The measures of error that a convergence run records, by name: what columns, keys and plots are called.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace glint {

enum class ErrorMeasure {
    RelativeError,  ///< rmse over the mean of the reference: what targets and fits are about
    Mse,
    Rmse,
    RelMse,
    RelMseTrimmed,
    Mape,
    Ssim,
    Flip,
    Bias,
    RelativeBias,
    MseWithoutReference,  ///< mse less the reference's own: may be negative
    PictureError,         ///< what a render estimates of itself (engine/render/picture_error.h)
};
constexpr size_t kErrorMeasureCount = 12;

using ErrorValues = std::array<double, kErrorMeasureCount>;

inline double& at(ErrorValues& values, ErrorMeasure m) { return values[static_cast<size_t>(m)]; }
inline double at(const ErrorValues& values, ErrorMeasure m) { return values[static_cast<size_t>(m)]; }

struct MeasureName {
    std::string_view key;    ///< CSV columns and JSON keys
    std::string_view title;  ///< tables and plots
    std::string_view unit;   ///< "" for ratios
};

constexpr std::array<MeasureName, kErrorMeasureCount> kMeasureNames{{
    {"relative_error", "relative error", ""},
    {"mse", "MSE", "radiance²"},
    {"rmse", "RMSE", "radiance"},
    {"rel_mse", "relMSE", ""},
    {"rel_mse_trimmed", "relMSE, trimmed", ""},
    {"mape", "MAPE", ""},
    {"ssim", "SSIM", ""},
    {"flip", "FLIP", ""},
    {"bias", "mean signed error", "radiance"},
    {"relative_bias", "relative bias", ""},
    {"mse_without_reference", "MSE − reference", "radiance²"},
    {"picture_error", "picture error", ""},
}};

}  // namespace glint
