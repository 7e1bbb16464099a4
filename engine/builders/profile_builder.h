// Profiles as kernels read them: Bézier curves, and the pieces of them that rays are tested against.
#pragma once

#include <vector>

#include "engine/kernels/profile_view.h"
#include "engine/scene/scene.h"

namespace glint {

/// Any number of profiles, one after the other.
struct ProfileTable {
    std::vector<ProfileData> profiles;
    std::vector<ProfileCurve> curves;  ///< neighbours share the bits of their common end
    std::vector<ProfilePiece> pieces;
    std::vector<PieceGroup> groups;

    ProfileView view(size_t index) const;
    size_t bytes() const;
};

/// The curves of a surface of revolution, its caps included, in their order; its points must be
/// valid (profileFault).
std::vector<ProfileCurve> profileCurvesOf(const Object& object);

/// Adds the profile of a surface of revolution, whose points must be valid, and returns its index.
uint32_t addProfile(const Object& object, ProfileTable* table);

}  // namespace glint
