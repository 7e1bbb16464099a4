// Asks before a file is replaced that this session did not write itself, or wrote of something else.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace glint {

class OverwriteGuard {
  public:
    /// Runs `save` at once where nothing is lost by it, else when the user agrees. A new question takes the
    /// place of an old one. `of`: what the file holds, where a file of something else is not to be replaced.
    void save(const std::string& path, std::function<void()> save, const std::string& of = {});
    /// The same of many files at once, by one question.
    void save(const std::vector<std::string>& paths, std::function<void()> save);
    /// Something would be lost, that the session did not write, or wrote of something else.
    bool mustAsk(const std::string& path, const std::string& of = {}) const;
    /// The session goes on with this file: it may be replaced without a question, by what is of the same.
    void mayReplace(const std::string& path, const std::string& of = {});

    /// What is to be replaced, of `save`'s paths those that the question is about; empty while nothing
    /// is asked.
    const std::vector<std::string>& asked() const { return asked_; }
    void agree();
    void refuse();

  private:
    std::map<std::string, std::string> ours_;  ///< full names, and what they hold
    std::vector<std::string> asked_;
    std::string askedOf_;
    std::function<void()> save_;
};

}  // namespace glint
