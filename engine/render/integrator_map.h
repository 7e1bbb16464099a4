// A picture of numbers that an integrator has beside its radiance.
#pragma once

#include <string_view>
#include <vector>

namespace glint {

struct IntegratorMap {
    std::string_view name;      ///< a constant of the integrator, such as kRadiusMap
    std::vector<float> values;  ///< 1 per pixel
};

}  // namespace glint
