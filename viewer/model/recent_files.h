// The scenes that were opened last, also by earlier sessions.
#pragma once

#include <string>
#include <vector>

namespace glint {

class RecentFiles {
  public:
    /// Reads the list in `file`, one path a line, and keeps it there from now on. Where it cannot be written,
    /// it lasts as long as the session.
    void begin(const std::string& file);
    /// Makes it the newest one.
    void add(const std::string& path);
    /// Absolute, the newest first.
    const std::vector<std::string>& paths() const { return paths_; }

    static constexpr size_t kMost = 10;

  private:
    std::string file_;
    std::vector<std::string> paths_;
};

}  // namespace glint
