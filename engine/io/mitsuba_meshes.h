// The meshes of Mitsuba's shapes, with the normals and colours that they have there. Internal to the
// Mitsuba importer.
#pragma once

#include <array>
#include <map>
#include <string>
#include <tuple>

#include "engine/io/mitsuba_materials.h"

namespace glint {

struct MitsubaMesh {
    int index = -1;       ///< in the scene; -1: there is none
    bool isOpen = false;  ///< it has edges of one triangle
};

class MitsubaMeshes {
  public:
    explicit MitsubaMeshes(MitsubaContext* context) : context_(*context) {}

    /// The mesh of an obj, ply or serialized shape. `isMirrored`: its transform mirrors. A file that is
    /// missing is an error, or with LoadOptions::allowMissing a remark.
    MitsubaMesh take(MitsubaObject* shape, const MitsubaSurface& surface, bool isMirrored);
    /// The cube from (-1, -1, -1) to (1, 1, 1).
    MitsubaMesh cube(bool isFlipped);
    /// The same triangles seen from their backs.
    int reversed(int mesh);
    /// What the files needed to be repaired.
    const std::vector<std::string>& warnings() const { return warnings_; }

  private:
    struct Wish;
    struct Raw;

    Wish wishOf(MitsubaObject* shape, const MitsubaSurface& surface, bool isMirrored);
    Result<Raw> read(const Wish& wish);
    /// False where the attribute is not there.
    static bool addAttribute(const Wish& wish, Raw* raw);
    MitsubaMesh add(const Wish& wish, Raw raw);

    using Key = std::tuple<std::string, int, int, float, std::string, std::array<float, 6>>;
    MitsubaContext& context_;
    std::map<Key, MitsubaMesh> taken_;
    std::map<int, int> reversed_;
    MitsubaMesh cubes_[2];
    std::vector<std::string> warnings_;
};

}  // namespace glint
