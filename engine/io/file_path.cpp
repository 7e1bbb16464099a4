#include "engine/io/file_path.h"

#include <algorithm>
#include <filesystem>

namespace glint {
namespace {

namespace fs = std::filesystem;

fs::path folderOf(const std::string& file) {
    std::error_code code;
    const fs::path absolute = fs::absolute(file, code);
    return (code ? fs::path(file) : absolute).lexically_normal().parent_path();
}

}  // namespace

std::string resolvePath(const std::string& path, const std::string& from) {
    const fs::path given(path);
    return given.is_absolute() ? path : (fs::path(from).parent_path() / given).string();
}

std::string rebasePath(const std::string& path, const std::string& from, const std::string& to) {
    const fs::path given(path);
    if (path.empty() || given.is_absolute()) { return path; }
    const fs::path absolute = (folderOf(from) / given).lexically_normal();
    const fs::path relative = absolute.lexically_relative(folderOf(to));
    return relative.empty() ? absolute.string() : relative.string();
}

std::string seenFromFolder(const std::string& found, std::string_view name, const std::string& scenePath) {
    namespace fs = std::filesystem;
    if (fs::path(name).is_absolute()) { return found; }
    std::error_code code;
    const fs::path absolute = fs::absolute(found, code).lexically_normal();
    const fs::path folder = fs::absolute(scenePath, code).lexically_normal().parent_path();
    const fs::path relative = absolute.lexically_relative(folder);
    return relative.empty() ? found : relative.string();
}

std::string findBeside(std::string_view name, const std::string& scenePath, const std::string& ownPath) {
    std::string file(name);
    std::ranges::replace(file, '\\', '/');
    const std::string beside = resolvePath(file, scenePath), besideOwn = resolvePath(file, ownPath);
    return !fileExists(beside) && fileExists(besideOwn) ? besideOwn : beside;
}

bool fileExists(const std::string& resolvedPath) {
    std::error_code code;
    const auto status = fs::status(resolvedPath, code);
    return fs::exists(status) && !fs::is_directory(status);
}

std::string followLinks(const std::string& path) {
    constexpr int kMostLinks = 40;
    fs::path target(path);
    std::error_code code;
    for (int link = 0; link < kMostLinks && fs::is_symlink(target, code); ++link) {
        // An absolute path stays as it is.
        target = target.parent_path() / fs::read_symlink(target, code);
    }
    return target.string();
}

std::string extensionOf(const std::string& path) {
    std::string ending = fs::path(path).extension().string();
    for (char& c : ending) {
        c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    }
    return ending;
}

bool hasExtension(const std::string& path, std::string_view extensions) {
    const std::string wanted = extensionOf(path);
    for (size_t at = 0; !wanted.empty() && at < extensions.size();) {
        const size_t end = std::min(extensions.find(' ', at), extensions.size());
        if (extensions.substr(at, end - at) == wanted) { return true; }
        at = end + 1;
    }
    return false;
}

}  // namespace glint
