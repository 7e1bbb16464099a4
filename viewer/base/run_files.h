// The files that a run reads and those that it writes: no input is ever written to, and no two outputs are
// one file.
//
// Every option of every command and the window ask here. What counts is the file (its device and number, or
// its folder and name while it is not there yet), not how its name is written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "viewer/base/numbered_files.h"

namespace glint {

/// False also where one of them is empty, a device or a pipe.
bool isSameFile(const std::string& a, const std::string& b);

class RunFiles {
  public:
    /// `what` it is, in messages: "the scene". An empty path is none.
    void reads(const std::string& what, const std::string& path);
    /// All of sceneFiles() (used_assets.h).
    void readsScene(const SceneDescription& scene);

    /// Error: `path` cannot be written (checkWritable), is a file that is read, or another output. Empty and
    /// "-" are none; devices and pipes can be many outputs.
    Status writes(const std::string& path);
    /// Error: `path` is a file that is read or an output. For files that are written on the way.
    Status checkIsFree(const std::string& path) const;
    /// The same, or it cannot be written.
    Status checkCanWrite(const std::string& path) const;
    /// The same of any of these, however many they are, at the cost of listing their folder.
    Status checkCanWrite(const NumberedFiles& images) const;
    /// The first error of all outputs: again, after further inputs came to light.
    Status check() const;
    /// Error: `path` is a file that is read, or empty.
    Status checkIsNoInput(const std::string& path) const;
    /// Error: `folder`, or a folder in it, has a file that is read.
    Status checkHoldsNoInput(const std::string& folder) const;

  private:
    Status checkIsNoOutput(const std::string& path) const;

    struct Input {
        std::string what, path;
    };
    std::vector<Input> inputs_;
    std::vector<std::string> outputs_;
};

/// True of ".png" and "a/.png", which are names without an ending.
bool isOnlyEnding(const std::string& path);

/// Error: `path` names an existing file that `mayReplace`, asked about its first bytes, does not accept.
/// `kind`: "a report". Files without a byte, devices and pipes are always accepted.
Status checkReplaces(const std::string& path, bool (*mayReplace)(std::string_view head),
                     std::string_view kind);

}  // namespace glint
