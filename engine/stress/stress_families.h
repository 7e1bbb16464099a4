// The families of the stability suite. Each function appends its cases; stress_suite.cpp calls them in order.
#pragma once

#include <vector>

#include "engine/stress/stress_case.h"

namespace glint {

using StressCases = std::vector<StressCase>;

void addScaleCases(StressCases* cases);    ///< stress_scale.cpp: unit of length
void addOffsetCases(StressCases* cases);   ///< stress_scale.cpp: distance from the origin
void addNeedleCases(StressCases* cases);   ///< stress_needles.cpp: long and narrow triangles
void addMeshCases(StressCases* cases);     ///< stress_mesh.cpp: faulty triangles, sheets, ratios
void addGlossCases(StressCases* cases);    ///< stress_gloss.cpp: roughness and grazing angles
void addEmitterCases(StressCases* cases);  ///< stress_emitter.cpp: small, bright, touching and narrow lamps
void addSpotCases(StressCases* cases);     ///< stress_spot.cpp: narrow cones; part of the lamps
void addGlassCases(StressCases* cases);    ///< stress_glass.cpp: indices of refraction, slabs, critical angle
void addAlbedoCases(StressCases* cases);   ///< stress_albedo.cpp: long paths between white walls
void addCameraCases(StressCases* cases);   ///< stress_camera.cpp: lenses and fields of view
void addEnvironmentCases(StressCases* cases);  ///< stress_environment.cpp: one bright pixel
void addInstanceCases(StressCases* cases);     ///< stress_instances.cpp: transforms
void addPhotonCases(StressCases* cases);       ///< stress_photons.cpp: radii and photon counts
void addRevolvedCases(StressCases* cases);     ///< stress_revolved.cpp: roots along rays at turned profiles
void addRecurrenceCases(StressCases* cases);   ///< stress_sums.cpp: a million passes of the photon statistics
void addFilmCases(StressCases* cases);         ///< stress_sums.cpp: sums with an outlier

}  // namespace glint
