// What CLI11's own checks let through or say badly: NaN passes its ranges. Used where commands
// declare options.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace glint {

/// A finite number in [least, most].
CLI::Validator between(double least, double most);

/// A finite number greater than zero.
CLI::Validator aboveZero();

/// A file that can be written (checkWritable), or - for standard output.
CLI::Validator writableFile();

}  // namespace glint
