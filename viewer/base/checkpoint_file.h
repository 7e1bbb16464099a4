// The checkpoint that a render saves again and again: never over a longer film, one of another scene, or what
// another render saved under the same name meanwhile.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>

#include "engine/render/checkpoint.h"

namespace glint {

/// "a-2.film" for "a.film", or the next number that is free.
std::string freeNameBeside(const std::string& path);

class CheckpointFile {
  public:
    /// An empty path: nothing is ever saved. `overwrite`: whatever is there is replaced.
    CheckpointFile(std::string path, bool overwrite);

    /// Where that would throw another film away, the file gets a free name beside it, and a warning says so.
    Status save(const SessionCapture& capture);

  private:
    /// Device, number and time of the last change, in nanoseconds.
    using Stamp = std::optional<std::tuple<uint64_t, uint64_t, int64_t>>;
    static Stamp stampOf(const std::string& path);

    std::string path_;
    bool overwrite_;
    /// Why a film does not replace what was there at first; "" where it does, or has.
    std::string reasonToKeep(const SessionCapture& capture) const;
    Stamp known_;                            ///< what was there at first, or what was saved last
    std::optional<CheckpointInfo> atFirst_;  ///< of the film that was there; nothing once it is replaced
};

}  // namespace glint
