// The comparisons are written so that NaN fails them.
#include "viewer/commands/option_checks.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "viewer/commands/output_files.h"

namespace glint {
namespace {

template <typename Accepts>
CLI::Validator numberCheck(const std::string& expected, Accepts accepts) {
    return {[=](std::string& text) {
                double value = std::numeric_limits<double>::quiet_NaN();
                const bool isNumber = CLI::detail::lexical_cast(text, value);
                return isNumber && accepts(value) ? std::string()
                                                  : fmt::format("'{}' is not {}", text, expected);
            },
            ""};
}

}  // namespace

CLI::Validator between(double least, double most) {
    return numberCheck(fmt::format("a number from {} to {}", least, most),
                       [=](double value) { return value >= least && value <= most; });
}

CLI::Validator aboveZero() {
    return numberCheck("a number greater than 0",
                       [](double value) { return value > 0.0 && std::isfinite(value); });
}

CLI::Validator writableFile() {
    return {[](std::string& path) {
                const Status writable = path == "-" ? Status() : checkWritable(path);
                return writable ? std::string() : writable.error().format();
            },
            ""};
}

}  // namespace glint
