// The frame of a checkpoint file, all numbers little-endian:
//   8 bytes "GLINTCKP", u32 format version, u64 size of the whole file,
//   sections until the checksum: 4 letters, u64 payload size, payload,
//   16 bytes ContentHash of everything before.
// Knows nothing of what sections hold.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/io/byte_stream.h"

namespace glint {

class CheckpointWriter {
  public:
    /// `bytes`: about the size of the file. Growing would copy what is there already, and a film is large.
    explicit CheckpointWriter(size_t bytes);

    /// Writes a section in place; `write` writes the payload.
    template <class Write>
    void section(std::string_view tag, Write write) {
        file_.writeRaw(tag);
        const size_t sizeAt = file_.bytes().size();
        file_.write(uint64_t{0});
        write(&file_);
        file_.overwrite(sizeAt, static_cast<uint64_t>(file_.bytes().size() - sizeAt - sizeof(uint64_t)));
    }
    /// The whole file; nothing may follow.
    const std::string& finish();

  private:
    ByteWriter file_;
};

/// Payloads by tag: views of the file's bytes.
using CheckpointSections = std::map<std::string, std::string_view, std::less<>>;

/// By a file's first bytes.
bool looksLikeCheckpoint(std::string_view head);

/// Checks that the file is a whole one of this version, and finds its sections. Error: a clause about what
/// is wrong.
Result<CheckpointSections> findSections(std::string_view bytes, const std::string& path);

Error checkpointError(const std::string& path, std::string message);

}  // namespace glint
