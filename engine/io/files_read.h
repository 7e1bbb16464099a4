// Which files a piece of work reads, whatever reads them: no importer needs to report its own.
#pragma once

#include <string>
#include <vector>

namespace glint {

/// From here to its end, notes the files that readFile() (atomic_file.h) opens on this thread. Those that are
/// made in another one's life note for both.
class FilesRead {
  public:
    FilesRead();
    FilesRead(const FilesRead&) = delete;
    FilesRead& operator=(const FilesRead&) = delete;
    ~FilesRead();

    /// Each once, as it was opened, in order of their names.
    std::vector<std::string> paths() const;

    /// For readFile().
    static void note(const std::string& path);

  private:
    FilesRead* outer_;
    std::vector<std::string> paths_;
};

}  // namespace glint
