// The lines of an MTL file, made regular for tinyobjloader, which then says what they hold. For
// mtl_loader.cpp only.
//
// tinyobjloader reads a malformed number as 0, knows neither backslashes at a line's end nor keywords in
// other case, and takes a file name for a number where an option has fewer values than it may have. No line
// is an error: none makes geometry wrong.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/io/remarks.h"

namespace tinyobj {
struct material_t;
}

namespace glint {

/// Keys that mean something here, or will; the names are in mtl_reader.cpp.
enum class MtlKey : uint32_t {
    Kd,
    Ks,
    Ke,
    Tf,
    Ns,
    Ni,
    D,
    Tr,
    Illum,
    Pr,
    Pm,
    Ps,
    Pc,
    Pcr,
    Aniso,
    Anisor,
    MapKd,
    MapKe,
    MapD,
    MapBump,
    Bump,
    Norm,
    MapPr,
    MapPm,
    Count
};

struct MtlEntry {
    std::string name;
    int line = 0;                                    ///< of newmtl
    uint32_t given = 0;                              ///< bits of MtlKey
    float tr = 0.0f;                                 ///< as written: tinyobjloader mixes d and Tr
    std::string lines;                               ///< all that it says, made regular
    std::vector<std::pair<MtlKey, int>> mapLines{};  ///< where each map stands

    /// The last one of the map, or newmtl's.
    int lineOf(MtlKey map) const {
        int found = line;
        for (const auto& [key, at] : mapLines) {
            found = key == map ? at : found;
        }
        return found;
    }
    bool has(MtlKey key) const { return (given & (1u << static_cast<uint32_t>(key))) != 0; }
    /// What tinyobjloader makes of it. Large: not to be kept for each material of a file.
    tinyobj::material_t values() const;
};

struct MtlFile {
    std::vector<MtlEntry> entries;  ///< in file order; names differ
    Remarks remarks;
    uint64_t charactersCounted = 0;  ///< TextCursor::charactersCounted
};

MtlFile readMtlEntries(const std::string& text, const std::string& path);

}  // namespace glint
