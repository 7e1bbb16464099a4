// A finished picture to a file: PNG for the eye, HDR and EXR with linear radiance, EXR with layers
// and metadata.
//
// Formats are engine/io's business, tone curves tonemap.h's.
#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/io/exr_io.h"
#include "engine/render/render_session.h"
#include "engine/render/tonemap.h"

namespace glint {

struct ImageOptions {
    DisplayLook look{};                          ///< PNG only
    ExrPixelType exrColor = ExrPixelType::Half;  ///< Half or Float, for radiance, albedo and normals
    uint32_t aovs = 0;  ///< EXR only: bits of Aov; those the snapshot does not carry are an error
    int threads = 0;
};

/// The format goes by the extension: .png, .exr or .hdr. Error: another extension, a picture that is not at
/// full resolution, an AOV that is missing, or the file cannot be written.
///
/// EXR layers: R G B (radiance), albedo.R/G/B, normal.X/Y/Z, geometricNormal.X/Y/Z, depth.Z (float),
/// objectId.id and materialId.id (32-bit integers, 0: nothing), and standardError.Y, bias.Y (SPPM) and
/// errorBound.Y where the snapshot has them (snapshot.h). Text attributes: glintVersion, sceneHash, passes,
/// renderSeconds, relativeError, relativeErrorLow, relativeErrorHigh (of the film as it was rendered),
/// denoised (yes; else it is not there), and one setting.NAME for
/// each of renderSettings().
Status saveImage(const std::string& path, const FilmSnapshot& snapshot, const SceneDescription& scene,
                 const ImageOptions& options);

}  // namespace glint
