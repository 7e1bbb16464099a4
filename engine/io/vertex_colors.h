// What stored vertex colours mean: one rule for OBJ and PLY, as both are written by the same programs.
#pragma once

#include <string>

#include "engine/io/mesh_file.h"

namespace glint {

/// From colours as a file stores them to linear ones. They are sRGB-encoded, from 0 to 1, or to 255 or 65535
/// where the file's say so: whole numbers above 2, or most of those that are not 0 above 1 and one above 16;
/// one above 255. `wholeNumbers` are from 0 to 255 at least. What lies beyond is clamped. Notes a range that
/// was guessed.
void decodeVertexColors(const std::string& path, MeshFile* file, bool wholeNumbers = false);

}  // namespace glint
