#include "engine/base/console.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>

#include <fcntl.h>
#include <fmt/format.h>

namespace glint {
namespace {

std::atomic<int> outputProblem{0};

void noteOutput(bool written) {
    int none = 0;
    if (!written) { outputProblem.compare_exchange_strong(none, errno == 0 ? EIO : errno); }
}

bool write(std::string_view bytes, std::FILE* stream) {
    return std::fwrite(bytes.data(), 1, bytes.size(), stream) == bytes.size();
}

}  // namespace

std::string printable(std::string text, char lineEnd) {
    unsigned char before = 0;
    for (char& c : text) {
        const auto code = static_cast<unsigned char>(c);
        const bool isSecondOfControl = before == 0xc2 && code >= 0x80 && code < 0xa0;
        before = code;
        if (c == '\n') {
            c = lineEnd;
        } else if (c == '\t') {
            c = ' ';
        } else if (code < 0x20 || code == 0x7f || isSecondOfControl) {
            c = '?';
        }
    }
    return text;
}

void sayText(std::string_view text) { write(printable(std::string(text)), stderr); }

void sayFormatted(fmt::string_view format, fmt::format_args args) noexcept {
    try {
        sayText(fmt::vformat(format, args));
    } catch (const std::exception&) { write("error: there is not enough memory to say more\n", stderr); }
}

void sayOverLine(std::string_view text) { write("\r\x1b[K" + printable(std::string(text)), stderr); }

void putText(std::string_view text) { putData(printable(std::string(text))); }

void putData(std::string_view bytes) { noteOutput(write(bytes, stdout)); }

int finishOutput() {
    noteOutput(std::fflush(stdout) == 0 && std::ferror(stdout) == 0);
    return outputProblem;
}

void prepareStandardStreams() {
    for (const int stream : {0, 1, 2}) {
        if (::fcntl(stream, F_GETFD) < 0) { ::open("/dev/null", stream == 0 ? O_WRONLY : O_RDONLY); }
    }
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace glint
