// Moves a camera: orbit, pan, dolly, fly, frame. Pure functions of the camera, called by the image view.
//
// Pixels are ImGui units over the picture. Nothing here reads input devices or knows of rendering.
#pragma once

#include "engine/math/bounds.h"
#include "engine/scene/scene.h"

namespace glint {

/// Turns the camera around its target. A drag over the picture's height turns by half a circle. The view
/// never passes over the poles of `up`.
void orbit(Camera* camera, Vec2 dragPixels, float imageHeight);
/// Shifts position and target in the picture's plane so that the target stays under the mouse.
void pan(Camera* camera, Vec2 dragPixels, float imageHeight);
/// Moves towards the target (steps > 0) by a fixed share of the distance; never reaches it. With parallel
/// rays, shows so much less instead.
void dolly(Camera* camera, float steps);
/// Moves position and target together: x right, y up, z forwards, in units of the target's distance.
void fly(Camera* camera, const Vec3& amount);
/// Looks around from where the camera stands: turns the target about the position.
void lookAround(Camera* camera, Vec2 dragPixels, float imageHeight);
/// Keeps the direction and moves so that `bounds` fill the picture, which is no longer shifted. Does nothing
/// for empty bounds.
void frameBounds(Camera* camera, const Bounds& bounds, float aspect);
/// Another projection that shows as much at the target's distance.
void setProjection(Camera* camera, ProjectionKind kind);

/// Metres from the position to the target.
float targetDistance(const Camera& camera);

}  // namespace glint
