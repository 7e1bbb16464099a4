// Asks the user for a file: by the desktop's own dialog where one is installed (zenity, kdialog), else
// by ours.
#pragma once

#include <functional>
#include <string>

#include "viewer/base/job_queue.h"
#include "viewer/model/file_browser.h"

namespace glint {

class FileDialog {
  public:
    explicit FileDialog(JobQueue* jobs) : jobs_(jobs) {}

    struct Question {
        std::string title;
        std::string path;  ///< begins in its folder; of a file to save, its name is proposed
        bool isForSaving = false;
        /// Called with what was chosen; not at all where nothing was.
        std::function<void(const std::string& path)> answer{};
    };
    /// One at a time: a new question replaces the one before.
    void ask(Question question);

    /// Ours is to be drawn.
    bool isOpen() const { return browser.isOpen(); }
    const Question& question() const { return question_; }
    FileBrowser browser;
    /// Enters a folder, or answers and closes.
    void choose(const std::string& name);
    void close() { browser.close(); }

    bool usesDesktop = false;

  private:
    JobQueue* jobs_;
    Question question_;
};

}  // namespace glint
