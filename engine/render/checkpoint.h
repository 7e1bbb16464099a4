// A render on disk that can be gone on with: the film and the integrator's statistics to the last bit, and
// what they are of.
//
// The file is described in checkpoint.cpp and checkpoint_sections.h. It holds fingerprints of the scene, so
// that resuming says what differs when another one is open, and the scene as it was edited, whose meshes and
// images stay in their files.
#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/render/film.h"
#include "engine/render/render_session.h"
#include "engine/scene/scene_hash.h"

namespace glint {

/// What a checkpoint says about itself.
struct CheckpointInfo {
    std::string glintVersion;  ///< that wrote it
    double renderSeconds = 0.0;
    uint32_t passes = 0;
    std::string scenePath;    ///< absolute; "" where it holds no scene and names none
    ReadingOptions readWith;  ///< how that was read
    std::vector<Setting> settings;
    SceneHashes hashes;
};

/// Saves atomically: an interrupted save leaves the old checkpoint. AOVs are not saved: they are made again
/// in moments.
Status saveCheckpoint(const std::string& path, const SessionCapture& capture);

/// About the size of a checkpoint of a picture of this size in memory while it is written; what is left out
/// are settings, faults and the convergence curve.
size_t checkpointBytes(int width, int height, IntegratorKind integrator);

/// The film and statistics to go on with. Error: not a checkpoint, another format version, cut off or
/// damaged, or the scene or a setting differs from the checkpoint's: each difference is named ("maxDepth is 8
/// in the checkpoint and 16 now").
Result<ResumePoint> loadCheckpoint(const std::string& path, const SceneDescription& scene);

/// The scene that the checkpoint is of, as it was edited (checkpoint_scene.h). Error: as above, but for
/// differences, or the checkpoint holds no scene, or a file that it names cannot be read.
Result<SceneDescription> loadCheckpointScene(const std::string& path);

/// Whether its film is of `scene`, which may be edited: both came from one file, nothing that the picture
/// shows differs, or the checkpoint holds no scene (pixels made in code) and the geometry is the same.
bool isOfScene(const CheckpointInfo& info, const SceneDescription& scene);

/// Error: the file at `path`, where there is one, is no checkpoint, holds a film of more than `passes`, or is
/// of another scene than `scene` (isOfScene; null: of whatever scene): a render is not thrown away for a
/// shorter or another one.
Status checkReplacesCheckpoint(const std::string& path, uint32_t passes, const SceneDescription* scene);

/// For `glint info`. Error: as above, but for differences.
Result<CheckpointInfo> readCheckpointInfo(const std::string& path);

}  // namespace glint
