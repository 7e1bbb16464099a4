// The new file beside an old one while it is being written.
//
// A writer that is killed leaves its temporary file behind, which the next save into the same folder removes.
// A temporary file is locked for as long as its writer lives, so nobody's work in progress is taken for a
// leftover, not even that of another machine on a shared disk or of a process that sleeps.
#pragma once

#include <string>

namespace glint {

/// Creates a file `target`.glint-<process>-<n>.tmp that did not exist and locks it until it is closed. Of a
/// long name the end is left out. Answers its descriptor, or -1 and errno.
int createTemporary(const std::string& target, std::string* name);

/// Removes the temporary files beside `target` whose writers are gone. Files of other names, and all on disks
/// that know no locks, stay.
void removeStaleTemporaries(const std::string& target);

}  // namespace glint
