// Attributes of a PLY file's vertices and faces, which Mitsuba's textures show. Internal to the
// Mitsuba importer.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/math/vec.h"

namespace glint {

struct PlyAttribute {
    std::vector<Vec3> values;       ///< of each vertex or face; grey where it is one number
    std::vector<uint32_t> corners;  ///< of each face, where it is the faces'
};

/// `name` as Mitsuba has it: "vertex_color" are the vertices' properties color_0 to color_2, or r, g and b;
/// "face_weight" the faces' weight_0. Error: no such property, a broken file.
Result<PlyAttribute> readPlyAttribute(const std::string& bytes, const std::string& path,
                                      std::string_view name);

}  // namespace glint
