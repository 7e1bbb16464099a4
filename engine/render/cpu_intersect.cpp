// What all kernels of the host share of looking for hits: the largest function of it, compiled once.
#include "engine/kernels/shapes/revolved_surface.h"

namespace glint {

template bool RevolvedSurface::meet(const ProfileView&, const Ray&, bool, bool, Hit*, NoTests);

}  // namespace glint
