// POSIX file calls, since the standard streams can neither flush to the disk nor say why something failed.
#include "engine/io/atomic_file.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "engine/io/file_path.h"
#include "engine/io/files_read.h"
#include "engine/io/temporary_file.h"

namespace glint {
namespace {

Error fileError(const std::string& path, const std::string& what, int code) {
    return {code == 0 ? what : fmt::format("{}: {}", what, std::strerror(code)), {.file = path}};
}

Error notRegular(const std::string& path, mode_t mode, std::string_view expected) {
    const char* const kind = S_ISDIR(mode)    ? "folder"
                             : S_ISFIFO(mode) ? "pipe"
                             : S_ISSOCK(mode) ? "socket"
                                              : "device";
    return fileError(path, fmt::format("is a {}; expected {}", kind, expected), 0);
}

class FileDescriptor {
  public:
    explicit FileDescriptor(int fd) : fd_(fd) {}
    ~FileDescriptor() { close(); }
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;

    int get() const { return fd_; }
    bool valid() const { return fd_ >= 0; }
    /// False when the last of the data could not be written (a network disk may say so only now).
    bool close() {
        const int fd = fd_;
        fd_ = -1;
        return fd < 0 || ::close(fd) == 0;
    }

  private:
    int fd_;
};

/// 0, or errno.
int writeAll(int fd, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(fd, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) { return errno; }
        bytes.remove_prefix(written > 0 ? static_cast<size_t>(written) : 0);
    }
    return 0;
}

/// Makes the new name last through a power cut. Not every file system can; the file itself is safe
/// either way.
void flushFolder(const std::string& target) {
    const size_t slash = target.find_last_of('/');
    const std::string folder = slash == std::string::npos ? "." : target.substr(0, slash + 1);
    const FileDescriptor fd(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (fd.valid()) { ::fsync(fd.get()); }
}

Error cannotCreate(const std::string& path, const std::string& target) {
    const int code = errno;
    const std::string folder = std::filesystem::path(target).parent_path().string();
    return code == ENOENT ? fileError(path, fmt::format("the folder '{}' does not exist", folder), 0)
                          : fileError(path, "cannot create a file in this folder", code);
}

/// What is written to under a name.
struct Target {
    std::string path;
    mode_t mode = 0;        ///< of the old file; 0: there is none
    bool isStream = false;  ///< a device or a pipe
};

/// Whether the program has this pipe open for writing, as its standard output or bash's >(...). Any other may
/// have no reader, and opening it would wait for one.
bool isHeldForWriting(const struct stat& pipe) {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", ignored)) {
        const int fd = std::atoi(entry.path().filename().c_str());
        struct stat open {};
        const bool isIt = ::fstat(fd, &open) == 0 && open.st_dev == pipe.st_dev && open.st_ino == pipe.st_ino;
        if (isIt && (::fcntl(fd, F_GETFL) & O_ACCMODE) != O_RDONLY) { return true; }
    }
    return false;
}

/// Follows links, also to a file that is not there yet. Error: a folder, a socket, a pipe that is not held; a
/// name that can be no file's.
Result<Target> targetOf(const std::string& path) {
    struct stat info {};
    if (::stat(path.c_str(), &info) != 0) {
        return errno == ENOENT && !path.ends_with('/') && !path.empty()
                   ? Result<Target>(Target{followLinks(path)})
                   : Result<Target>(fileError(path, "cannot write", errno));
    }
    if (S_ISDIR(info.st_mode)) { return fileError(path, "is a folder; expected a file name to write to", 0); }
    if (S_ISSOCK(info.st_mode) || (S_ISFIFO(info.st_mode) && !isHeldForWriting(info))) {
        return notRegular(path, info.st_mode, "a file");
    }
    // What /dev/stdout links to is no name where that is a pipe.
    if (!S_ISREG(info.st_mode)) { return Target{.path = path, .isStream = true}; }
    // Renaming over it would ask the folder alone, and whoever took the right to write away meant the file.
    if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) {
        return fileError(path, "cannot write", errno);
    }
    return Target{.path = followLinks(path), .mode = info.st_mode & 07777};
}

Status replaceFile(const std::string& path, const Target& target, std::string_view bytes) {
    removeStaleTemporaries(target.path);
    std::string temporary;
    FileDescriptor fd(createTemporary(target.path, &temporary));
    if (!fd.valid()) { return cannotCreate(path, target.path); }
    int code = writeAll(fd.get(), bytes);
    if (code == 0 && target.mode != 0) {
        // Keeping the old permissions is a courtesy; failing to is no reason not to save.
        ::fchmod(fd.get(), target.mode);
    }
    if (code == 0 && ::fsync(fd.get()) != 0) { code = errno; }
    if (!fd.close() && code == 0) { code = errno; }
    if (code == 0 && ::rename(temporary.c_str(), target.path.c_str()) != 0) { code = errno; }
    if (code != 0) {
        ::unlink(temporary.c_str());
        return fileError(path, "cannot write", code);
    }
    flushFolder(target.path);
    return {};
}

Status writeDirectly(const std::string& path, std::string_view bytes) {
    // Opening waits for nobody: not for a reader, nor for a terminal's line. Writing does.
    FileDescriptor fd(::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    if (!fd.valid() || ::fcntl(fd.get(), F_SETFL, 0) != 0) {
        return fileError(path, "cannot open for writing", errno == ENXIO ? EPIPE : errno);
    }
    if (const int code = writeAll(fd.get(), bytes); code != 0) {
        return fileError(path, "cannot write", code);
    }
    return fd.close() ? Status() : Status(fileError(path, "cannot write", errno));
}

/// All signals to this thread wait while it lives.
class SignalsHeld {
  public:
    SignalsHeld() {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    ~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;

  private:
    sigset_t before_{};
};

}  // namespace

Status checkRegularFile(const std::string& path, std::string_view expected) {
    struct stat info {};
    if (::stat(path.c_str(), &info) != 0) {
        return errno == ENOENT || errno == ENOTDIR
                   ? fileError(path, fmt::format("no such file; expected {}", expected), 0)
                   : fileError(path, "cannot open", errno);
    }
    return S_ISREG(info.st_mode) ? Status() : Status(notRegular(path, info.st_mode, expected));
}

Result<std::string> readFile(const std::string& path, uint64_t most) {
    // Opening a pipe would otherwise wait until somebody writes to it.
    const FileDescriptor fd(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    struct stat info {};
    if (!fd.valid() || ::fstat(fd.get(), &info) != 0) { return fileError(path, "cannot open", errno); }
    if (!S_ISREG(info.st_mode)) { return notRegular(path, info.st_mode, "a file"); }
    FilesRead::note(path);
    if (static_cast<uint64_t>(info.st_size) > most) {
        return fileError(path, fmt::format("has {} bytes; at most {} are read", info.st_size, most), 0);
    }
    // Files that grow, and those of /proc, have no size to rely on, so reading ends only at the end. The one
    // byte more lets a file of the expected size end without growing the buffer.
    std::string bytes(static_cast<size_t>(info.st_size) + 1, '\0');
    for (size_t filled = 0;;) {
        if (filled == bytes.size()) { bytes.resize(std::max<size_t>(2 * bytes.size(), 65536)); }
        const ssize_t count = ::read(fd.get(), bytes.data() + filled, bytes.size() - filled);
        if (count < 0 && errno != EINTR) { return fileError(path, "cannot read", errno); }
        if (count == 0) {
            bytes.resize(filled);
            return bytes;
        }
        filled += count > 0 ? static_cast<size_t>(count) : 0;
        if (filled > most) { return fileError(path, fmt::format("is longer than {} bytes", most), 0); }
    }
}

Status checkWritable(const std::string& path) {
    const Result<Target> target = targetOf(path);
    if (!target) { return target.error(); }
    if (target->isStream) {
        return ::access(path.c_str(), W_OK) == 0 ? Status() : Status(fileError(path, "cannot write", errno));
    }
    const SignalsHeld held;  // one that ends the program in between would leave the file
    std::string temporary;
    const FileDescriptor fd(createTemporary(target->path, &temporary));
    if (!fd.valid()) { return cannotCreate(path, target->path); }
    ::unlink(temporary.c_str());
    return {};
}

Status writeFileAtomically(const std::string& path, std::string_view bytes) {
    const Result<Target> target = targetOf(path);
    if (!target) { return target.error(); }
    return target->isStream ? writeDirectly(path, bytes) : replaceFile(path, *target, bytes);
}

}  // namespace glint
