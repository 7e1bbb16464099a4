#include "viewer/base/desktop_dialog.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>
#include <unistd.h>

namespace glint {
namespace {

bool isInstalled(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (::access(folder.append("/").append(program).c_str(), X_OK) == 0) { return true; }
    }
    return false;
}

/// As one word of the shell's.
std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) {
        out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return out + "'";
}

}  // namespace

std::string desktopDialog(const std::string& title, const std::string& path, bool isForSaving) {
    std::error_code problem;
    const std::filesystem::path absolute = std::filesystem::absolute(path, problem);
    const std::string begin = isForSaving ? absolute.string() : absolute.parent_path().string() + "/";
    if (isInstalled("zenity")) {
        return fmt::format("zenity --file-selection{} --title={} --filename={} 2> /dev/null",
                           isForSaving ? " --save" : "", quoted(title), quoted(begin));
    }
    if (isInstalled("kdialog")) {
        return fmt::format("kdialog --title {} {} {} 2> /dev/null", quoted(title),
                           isForSaving ? "--getsavefilename" : "--getopenfilename", quoted(begin));
    }
    return "";
}

std::string outputOf(const std::string& command) {
    std::string output;
    std::FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) { return output; }
    std::array<char, 1024> buffer{};
    for (size_t got; (got = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
        output.append(buffer.data(), got);
    }
    ::pclose(pipe);
    while (output.ends_with('\n')) {
        output.pop_back();
    }
    return output;
}

}  // namespace glint
