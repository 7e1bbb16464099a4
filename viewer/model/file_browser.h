// Looking for a file in folders, for a dialog of our own.
#pragma once

#include <string>
#include <vector>

namespace glint {

class FileBrowser {
  public:
    /// Opens the dialog in the folder of `path`, or in the working folder.
    void open(const std::string& path);
    void close() { isOpen_ = false; }
    bool isOpen() const { return isOpen_; }

    struct Entry {
        std::string name;  ///< of folders with a slash at its end
        bool isFolder = false;
    };
    /// Folders first, "../" before all; hidden files are left out.
    const std::vector<Entry>& entries() const { return entries_; }
    const std::string& folder() const { return folder_; }

    /// Enters a folder, and answers ""; or the path of a file. `name` may be a path of its own, with "~" for
    /// the home folder.
    std::string choose(const std::string& name);

    std::string typed;  ///< the name field

  private:
    void list(const std::string& folder);

    bool isOpen_ = false;
    std::string folder_;
    std::vector<Entry> entries_;
};

}  // namespace glint
