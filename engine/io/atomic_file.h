// Whole files in and out of memory. Every file Glint writes goes through writeFileAtomically, so that an
// interrupted save leaves the old file, never half of a new one.
//
// Knows nothing of formats.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "engine/base/result.h"

namespace glint {

/// Largest file that is read into memory at once.
constexpr uint64_t kMaxFileBytes = uint64_t{16} << 30;

/// Error unless `path` leads to a regular file: missing, a folder, a pipe, a device. `expected`: "a scene".
/// What is read by other means asks before it opens, since opening a pipe waits for its other end.
Status checkRegularFile(const std::string& path, std::string_view expected);

/// The file's bytes. Error: missing, a folder, a pipe or a device, unreadable, more than `most`; the place
/// names the file.
Result<std::string> readFile(const std::string& path, uint64_t most = kMaxFileBytes);

/// Error: writeFileAtomically() would find that nothing can be written to `path`: no such folder, none that
/// may be written to, a folder, a pipe that nobody may read, a name that is too long. Makes the new file and
/// removes it again.
Status checkWritable(const std::string& path);

/// Replaces `path` by `bytes`: writes a new file in the same folder, flushes it to the disk and renames it.
/// On any error (no such folder, not writable, disk full, `path` is a folder) the old file stays and the new
/// one is removed, as are those that killed saves left in the folder. A symbolic link stays, and its target
/// is replaced or made. Devices cannot be replaced; they are written directly, as are pipes that the program
/// was started with (/dev/stdout, bash's >(...)). Others are refused: they may have no reader.
Status writeFileAtomically(const std::string& path, std::string_view bytes);

}  // namespace glint
