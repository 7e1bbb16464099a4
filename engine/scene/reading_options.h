// How a scene's file was read, so that it can be read so again.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace glint {

/// Names and values that replace `$name` in scenes with parameters, or choose what a file offers.
using SceneParameters = std::vector<std::pair<std::string, std::string>>;

/// io/load_options.h says what each means.
struct ReadingOptions {
    bool allowMissing = false;
    bool noStudio = false;
    SceneParameters parameters;

    bool operator==(const ReadingOptions&) const = default;
};

}  // namespace glint
