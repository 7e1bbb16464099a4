#include "viewer/model/session_backup.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <future>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "engine/base/log.h"
#include "engine/io/embedded_files.h"
#include "engine/render/checkpoint.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtension = ".glintfilm";
constexpr const char* kFolderExtension = ".files";
constexpr const char* kUnreadableExtension = ".unreadable";
constexpr double kMostOfTime = 0.05;  // that saving may take

double secondsNow() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Of files that the scene holds in memory.
std::string folderOf(const std::string& file) { return file + kFolderExtension; }

std::string lockName(const std::string& file) { return file + ".lock"; }

/// -1: its session lives, or the disk knows no locks.
int lockOf(const std::string& file) {
    const int lock = ::open(lockName(file).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (lock >= 0 && ::flock(lock, LOCK_EX | LOCK_NB) != 0) {
        ::close(lock);
        return -1;
    }
    return lock;
}

void removeFile(const std::string& file, int lock) {
    std::error_code none;
    fs::remove(file, none);
    fs::remove_all(folderOf(file), none);
    fs::remove(lockName(file), none);
    if (lock >= 0) { ::close(lock); }
}

/// A checkpoint's scene names files alone.
Status saveWithFiles(const std::string& file, SessionCapture capture) {
    auto scene = std::make_shared<SceneDescription>(*capture.scene);
    std::error_code problem;
    fs::create_directories(folderOf(file), problem);
    // Paths within the scene count from a file there.
    const std::string inFolder = folderOf(file) + "/scene";
    if (Status written = writeEmbeddedFiles(scene.get(), inFolder); !written) { return written; }
    capture.scene = scene;
    return saveCheckpoint(file, capture);
}

}  // namespace

void restoreBeside(const std::string& file, SceneDescription* scene) { embedFilesOf(folderOf(file), scene); }

void SessionBackup::begin(const std::string& folder, double seconds) {
    std::error_code problem;
    fs::create_directories(folder, problem);
    findLeftovers(folder);
    for (int number = 1; lock_ < 0 && number < 100; ++number) {
        file_ = (fs::path(folder) / fmt::format("{}-{}{}", ::getpid(), number, kExtension)).string();
        if (!fs::exists(file_, problem)) { lock_ = lockOf(file_); }
    }
    if (lock_ < 0) {
        logWarning("{}: cannot be written; this session could not be recovered after a crash", folder);
        return;
    }
    interval_ = seconds;
    lastSaved_ = secondsNow();
}

void SessionBackup::findLeftovers(const std::string& folder) {
    std::error_code problem;
    std::vector<std::pair<fs::file_time_type, std::string>> files;
    std::vector<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(folder, problem)) {
        if (entry.path().extension() == kExtension) {
            files.emplace_back(entry.last_write_time(problem), entry.path().string());
        } else if (entry.path().extension() == kFolderExtension) {
            folders.push_back(entry.path().parent_path() / entry.path().stem());
        }
    }
    for (const fs::path& file : folders) {  // of checkpoints that were never finished
        if (fs::exists(file, problem)) { continue; }
        if (const int lock = lockOf(file.string()); lock >= 0) { removeFile(file.string(), lock); }
    }
    std::ranges::sort(files);
    for (const auto& [time, file] : files) {
        const int lock = lockOf(file);
        if (lock < 0) { continue; }
        const Result<CheckpointInfo> info = readCheckpointInfo(file);
        if (!info) {
            setAside(file, lock, info.error());
        } else if (!info->scenePath.empty()) {
            leftovers_.push_back({{file, info->scenePath, info->passes}, lock});
        } else {
            removeFile(file, lock);
        }
    }
}

void SessionBackup::setAside(const std::string& file, int lock, const Error& why) {
    const std::string aside = file + kUnreadableExtension;
    std::error_code problem;
    fs::rename(folderOf(file), folderOf(aside), problem);  // often there is none
    problem.clear();
    fs::rename(file, aside, problem);
    const std::string text = fmt::format("What a session left cannot be read; it is kept as {}. {}",
                                         problem ? file : aside, why.format());
    logWarning("{}", text);
    notice_->show(text, true);
    fs::remove(lockName(file), problem);
    ::close(lock);
}

SessionBackup::~SessionBackup() {
    jobs_.reset();  // a save that is under way
    if (lock_ >= 0 && !isKept_) { removeFile(file_, lock_); }
}

std::string SessionBackup::takeOver() {
    const Locked taken = leftovers_.back();
    leftovers_.pop_back();
    if (lock_ >= 0) { removeFile(file_, lock_); }
    file_ = taken.info.file;
    lock_ = taken.lock;
    return file_;
}

void SessionBackup::discard() {
    removeFile(leftovers_.back().info.file, leftovers_.back().lock);
    leftovers_.pop_back();
}

void SessionBackup::refresh() {
    jobs_->runCompletions();
    const SessionStatus& status = render_->status();
    const bool isNew = document_->posted() != savedScene_ || status.passes != savedPasses_;
    const bool isDue = interval_ > 0.0 && secondsNow() - lastSaved_ >= interval_;
    const bool isReady = document_->isOpen() && status.passes > 0 && !render_->request.interacting &&
                         !render_->awaitsImage() && status.state != SessionState::Failed;
    if (isDue && isNew && isReady && !isSaving_) { save(); }
}

void SessionBackup::save() {
    isSaving_ = true;
    savedScene_ = document_->posted();
    savedPasses_ = render_->status().passes;
    auto future = std::make_shared<std::future<std::optional<SessionCapture>>>(render_->captureLater());
    jobs_->start(
        [this, future, file = file_]() -> JobQueue::Completion {
            std::optional<SessionCapture> capture = future->get();
            const double began = secondsNow();
            const Status saved = capture ? saveWithFiles(file, std::move(*capture)) : Status();
            return [this, saved, took = secondsNow() - began] {
                isSaving_ = false;
                noteSaved(saved);
                lastSaved_ = secondsNow() - interval_ + std::max(interval_, took / kMostOfTime);
            };
        },
        true);
}

void SessionBackup::noteSaved(const Status& saved) {
    if (isFailing_ == !saved.ok()) { return; }
    isFailing_ = !saved.ok();
    if (!isFailing_) { return logInfo("The session is kept for a crash again"); }
    const std::string text =
        fmt::format("The session cannot be kept for a crash: {}", saved.error().format());
    logWarning("{}", text);
    notice_->show(text, true);
}

}  // namespace glint
