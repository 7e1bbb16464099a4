#include "viewer/model/file_dialog.h"

#include <filesystem>
#include <utility>

#include "viewer/base/desktop_dialog.h"

namespace glint {

void FileDialog::ask(Question question) {
    question_ = std::move(question);
    const std::string command =
        usesDesktop ? desktopDialog(question_.title, question_.path, question_.isForSaving) : "";
    if (command.empty()) {
        browser.open(question_.path);
        if (question_.isForSaving) {
            browser.typed = std::filesystem::path(question_.path).filename().string();
        }
        return;
    }
    jobs_->start(
        [command, answer = question_.answer]() -> JobQueue::Completion {
            const std::string path = outputOf(command);
            return [path, answer] {
                if (!path.empty()) { answer(path); }
            };
        },
        false);
}

void FileDialog::choose(const std::string& name) {
    const std::string typed = browser.typed;
    const std::string file = browser.choose(name);
    if (file.empty()) {
        if (question_.isForSaving && name != typed) { browser.typed = typed; }
        return;
    }
    browser.close();
    question_.answer(file);
}

}  // namespace glint
