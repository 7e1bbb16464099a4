// A picture of numbers that an integrator has beside its radiance.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace glint {

struct IntegratorMap {
    std::string_view name;      ///< a constant of the integrator, such as kRadiusMap
    std::vector<float> values;  ///< 1 per pixel
};

/// What the numbers of a map are.
enum class MapQuantity : uint8_t {
    Length,    ///< metres
    Count,     ///< of things, fractions too
    Presence,  ///< above 0 or not
};

/// How displays show one of an integrator's maps. Several may show the same values.
struct IntegratorMapInfo {
    std::string_view values;  ///< IntegratorMap::name
    const char* label;        ///< for people and scripts, unlike that of any other image
    MapQuantity quantity;
    const char* noun;    ///< what is measured, counted or present
    const char* absent;  ///< what a value of 0 means; null: it is a number as any other
    const char* about;   ///< what integrators without it lack
};

}  // namespace glint
