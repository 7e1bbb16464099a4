// What a scene file lets its user choose by parameters: animations and variants of materials.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/io/load_options.h"

namespace glint {

struct SceneChoices {
    struct Animation {
        std::string name;
        float beginSeconds = 0.0f, endSeconds = 0.0f;
    };
    std::vector<Animation> animations;  ///< the parameters "animation", and "time" in seconds
    std::vector<std::string> variants;  ///< the parameter "variant"

    bool isEmpty() const { return animations.empty() && variants.empty(); }
};

/// Of a glTF file as its text states them, unchecked; those without a name have their number from 0 for one.
/// Nothing of other files, and where the file cannot be read.
SceneChoices readSceneChoices(const std::string& path);

/// Null: it is not given.
const std::string* findParameter(const SceneParameters& parameters, std::string_view name);

/// An empty value: it is no longer given.
void setParameter(SceneParameters* parameters, const std::string& name, const std::string& value);

/// A finite number, and nothing else.
std::optional<double> numberIn(const std::string& text);

/// The index of `wanted` in `names`, or else what it counts from 0 on.
std::optional<size_t> indexIn(std::span<const std::string> names, const std::string& wanted);

}  // namespace glint
