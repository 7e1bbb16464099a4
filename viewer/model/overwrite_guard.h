// Asks before a file is replaced that this session did not write itself.
#pragma once

#include <functional>
#include <set>
#include <string>

namespace glint {

class OverwriteGuard {
  public:
    /// Runs `save` at once where nothing is lost by it, else when the user agrees. A new question takes the
    /// place of an old one.
    void save(const std::string& path, std::function<void()> save);
    /// Something would be lost, that the session did not write.
    bool mustAsk(const std::string& path) const;
    /// The session goes on with this file: it may be replaced without a question.
    void mayReplace(const std::string& path);

    /// What is to be replaced; "" while nothing is asked.
    const std::string& asked() const { return asked_; }
    void agree();
    void refuse();

  private:
    std::set<std::string> ours_;
    std::string asked_;
    std::function<void()> save_;
};

}  // namespace glint
