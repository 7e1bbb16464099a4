// Mitsuba's sensors, films and integrators as Glint's camera and options. Internal to the Mitsuba importer.
#pragma once

#include "engine/io/mitsuba_object.h"

namespace glint {

/// Sets the camera, the picture's size and its filter, and how the scene is placed (MitsubaContext::world).
void readMitsubaSensor(MitsubaContext* context, const MitsubaElement& sensor);
/// The angle of view across the height of a picture, of a sensor or a projector.
float mitsubaVerticalFov(MitsubaObject* object, float aspect);
/// Sets the integrator and its depth: Mitsuba's maximum counts edges, Glint's scattering events, one less.
void readMitsubaIntegrator(MitsubaContext* context, const MitsubaElement& integrator);

}  // namespace glint
