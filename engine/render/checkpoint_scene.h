// The scene in a checkpoint: as it was edited, as Glint JSON, and how its file was read.
#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/render/checkpoint_sections.h"
#include "engine/scene/scene.h"

namespace glint {

/// As the section SCNE has it: absolute, without . and ..; "" of a scene that has no file.
std::string absolutePath(const std::string& path);

/// What the files that the scene holds in memory take in a checkpoint.
size_t embeddedBytes(const SceneDescription& scene);

/// Writes the section SCNE: the scene's path, absolute, as text, then the scene as JSON text whose relative
/// paths count from there. None where the scene cannot be written, since pixels of it were made in code
/// alone. Before it, where the scene holds files in memory, EMBD: u32 count, then of each the path that
/// stands for it in the JSON text, its name and its bytes as texts. Before it, where the scene has a file,
/// READ: its path likewise, u8 allowMissing, u8 noStudio, and the parameters as u32 count, then name and
/// value texts.
void writeCheckpointScene(const SceneDescription& scene, CheckpointWriter* file);

/// Its absolute path, "" where there is none.
std::string checkpointScenePath(const CheckpointSections& sections);
/// As in a new scene where the checkpoint does not say, or is damaged.
ReadingOptions checkpointReadingOptions(const CheckpointSections& sections);

/// The scene with everything that it names, which is read from its files and those in the checkpoint; where
/// that has no scene (pixels made in code) its own file, read as it was. Error: the checkpoint has neither,
/// it is damaged, or one of those files is missing or broken.
Result<SceneDescription> readCheckpointScene(const CheckpointSections& sections, const std::string& path);

}  // namespace glint
