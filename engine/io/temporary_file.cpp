// POSIX files and flock().
#include "engine/io/temporary_file.h"

#include <algorithm>
#include <cerrno>
#include <memory>
#include <string_view>

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace glint {
namespace {

constexpr std::string_view kMark = ".glint-";
constexpr std::string_view kEnding = ".tmp";
constexpr size_t kMostAdded = 30;  ///< bytes of all that follows the target's name
constexpr size_t kMostNameBytes = 255 - kMostAdded;

/// Whether `name` still is the file that `fd` has open.
bool isStillNamed(int fd, const std::string& name) {
    struct stat opened {};
    struct stat named {};
    return ::fstat(fd, &opened) == 0 && ::lstat(name.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
           opened.st_ino == named.st_ino;
}

/// Whether a name ends in .glint-<digits>-<digits>.tmp.
bool isOurs(std::string_view name) {
    const size_t mark = name.rfind(kMark);
    if (mark == std::string_view::npos || !name.ends_with(kEnding)) { return false; }
    name.remove_suffix(kEnding.size());
    name.remove_prefix(std::min(mark + kMark.size(), name.size()));
    const size_t dash = name.find('-');
    const auto isNumber = [](std::string_view text) {
        return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
    };
    return dash != std::string_view::npos && isNumber(name.substr(0, dash)) &&
           isNumber(name.substr(dash + 1));
}

/// `target` with as much of its name as leaves room for more, whole characters of UTF-8.
std::string shortened(const std::string& target) {
    const size_t name = target.find_last_of('/') + 1;  // npos + 1 is 0
    size_t length = std::min(target.size() - name, kMostNameBytes);
    const auto isInsideCharacter = [&](size_t at) {
        return at < target.size() && (static_cast<unsigned char>(target[at]) & 0xc0) == 0x80;
    };
    while (length > 0 && isInsideCharacter(name + length)) {
        --length;
    }
    return target.substr(0, name + length);
}

void removeIfAbandoned(const std::string& name) {
    const int fd = ::open(name.c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    struct stat info {};
    if (fd < 0) { return; }
    // The name may have become another file, or none, between the look into the folder and the lock.
    if (::fstat(fd, &info) == 0 && S_ISREG(info.st_mode) && ::flock(fd, LOCK_EX | LOCK_NB) == 0 &&
        isStillNamed(fd, name)) {
        ::unlink(name.c_str());
    }
    ::close(fd);
}

}  // namespace

int createTemporary(const std::string& target, std::string* name) {
    const std::string start = shortened(target);
    for (unsigned attempt = 0; attempt < 10000; ++attempt) {
        *name = fmt::format("{}{}{}-{}{}", start, kMark, ::getpid(), attempt, kEnding);
        const int fd = ::open(name->c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (fd < 0 && errno != EEXIST) { return fd; }
        // Without a lock the file is as good, and nobody else can lock it either.
        if (fd >= 0 && (::flock(fd, LOCK_EX | LOCK_NB) != 0 || isStillNamed(fd, *name))) { return fd; }
        if (fd >= 0) {
            ::close(fd);  // taken for a leftover before it was locked
        }
    }
    return -1;
}

void removeStaleTemporaries(const std::string& target) {
    const size_t name = target.find_last_of('/') + 1;  // npos + 1 is 0
    const std::string folder = target.substr(0, name);
    // std::filesystem allocates where it must not throw.
    const std::unique_ptr<DIR, int (*)(DIR*)> entries(::opendir(name > 0 ? folder.c_str() : "."), ::closedir);
    while (const dirent* entry = entries ? ::readdir(entries.get()) : nullptr) {
        if (isOurs(entry->d_name)) { removeIfAbandoned(folder + entry->d_name); }
    }
}

}  // namespace glint
