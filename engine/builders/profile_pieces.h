// Short pieces of a profile's curves, with the rings around them.
#pragma once

#include <vector>

#include "engine/kernels/profile_view.h"

namespace glint {

/// Appends the pieces of a profile, of which the box is set, and their groups. Pieces turn back neither in
/// height nor in distance from the axis, and are close to straight; neighbours share the bits of their
/// common end.
void addPieces(const std::vector<ProfileCurve>& curves, const ProfileData& profile,
               std::vector<ProfilePiece>* pieces, std::vector<PieceGroup>* groups);

}  // namespace glint
