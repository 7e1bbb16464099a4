// Plays a script on a small scene in the built program, headless, and collects what it said.
#pragma once

#include <array>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>

namespace glint::test {

// Small enough that a pass is quick on a busy machine.
inline constexpr const char* kScene = R"({
  "glint": 1,
  "resolution": [64, 48],
  "camera": { "position": [0, 1, 4], "target": [0, 1, 0] },
  "materials": { "grey": { "type": "diffuse", "color": 0.5 } },
  "objects": [{ "type": "sphere", "material": "grey", "center": [0, 1, 0], "radius": 1 }],
  "environment": { "color": 1 }
})";

struct Ran {
    int exitCode = -1;
    std::string output;
};

inline Ran run(const std::string& arguments) {
    Ran ran;
    const std::string command = std::string(GLINT_PROGRAM) + " " + arguments + " 2>&1 < /dev/null";
    std::FILE* pipe = popen(command.c_str(), "r");
    std::array<char, 4096> buffer{};
    for (size_t got; (got = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
        ran.output.append(buffer.data(), got);
    }
    const int status = pclose(pipe);
    ran.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return ran;
}

inline void write(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

/// Plays `script` on the small scene in a window of 1280 x 720.
inline Ran play(const std::string& script, const std::string& more = "") {
    write("scene.json", kScene);
    write("script.txt", script);
    return run("view scene.json --headless --threads 1 --script script.txt " + more);
}

/// What `print "LABEL"` said, in order.
inline std::vector<std::string> printed(const Ran& ran, const std::string& label) {
    std::vector<std::string> values;
    const std::string begin = "\"" + label + "\" ";
    size_t at = 0;
    while ((at = ran.output.find(begin, at)) != std::string::npos) {
        at += begin.size();
        values.push_back(ran.output.substr(at, ran.output.find('\n', at) - at));
    }
    return values;
}

inline void expectPlayed(const Ran& ran) { EXPECT_EQ(ran.exitCode, 0) << ran.output; }

}  // namespace glint::test
