// A light without a shape as a placed thing, for handles: it shines along the third axis of its place.
#pragma once

#include "engine/math/transform.h"
#include "engine/scene/light.h"
#include "viewer/model/gizmo.h"

namespace glint {

/// `infinite`: where the handles of a light stand that comes from infinitely far away.
Affine placeOf(const Light& light, const Vec3& infinite);
/// Position and direction, whose length stays, as far as its kind has them.
void placeLight(Light* light, const Affine& placed);
/// Points only move, directions only turn, and nothing has a size.
GizmoSettings settingsFor(const Light& light, GizmoSettings settings);

}  // namespace glint
