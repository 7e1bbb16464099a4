// A real window on an X server of the test's own (Xvfb), with a mouse and a keyboard that are not
// ours (xdotool).
//
// Nothing here is timed: the tests wait for what the window's title says. The guard against hanging is
// generous. Where a widget is comes from a script's `print widgets` in a headless window of the same size.
#pragma once

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

namespace glint::test {

using Words = std::vector<std::string>;

inline constexpr auto kHangGuard = std::chrono::seconds(240);
inline constexpr auto kPause = std::chrono::milliseconds(60);  // between what a hand does; a frame or more

inline constexpr const char* kWindowScene = R"({
  "glint": 1,
  "resolution": [96, 72],
  "camera": { "position": [0, 1, 4], "target": [0, 1, 0] },
  "materials": { "grey": { "type": "diffuse", "color": 0.5 } },
  "objects": [{ "type": "sphere", "material": "grey", "center": [0, 1, 0], "radius": 1 }],
  "environment": { "color": 1 }
})";

inline void write(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

inline std::string read(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

inline bool until(const std::function<bool()>& met) {
    const auto end = std::chrono::steady_clock::now() + kHangGuard;
    while (!met()) {
        if (std::chrono::steady_clock::now() > end) { return false; }
        std::this_thread::sleep_for(kPause);
    }
    return true;
}

/// A child process; its output goes into a file. Asked to end if it still runs at the end, and killed if it
/// does not.
class Child {
  public:
    Child(const Words& words, const std::string& outputFile, int inheritedPipe = -1) {
        pid_ = fork();
        if (pid_ != 0) { return; }
        const int output = open(outputFile.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0644);
        dup2(output, STDOUT_FILENO);
        dup2(output, STDERR_FILENO);
        if (inheritedPipe >= 0) { dup2(inheritedPipe, 3); }
        std::vector<char*> argv;
        for (const std::string& word : words) {
            argv.push_back(const_cast<char*>(word.c_str()));
        }
        argv.push_back(nullptr);
        execvp(argv[0], argv.data());
        _exit(127);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        if (!ended()) { kill(pid_, SIGTERM); }
        for (int i = 0; i < 50 && !ended(); ++i) {
            std::this_thread::sleep_for(kPause);
        }
        if (ended()) { return; }
        kill(pid_, SIGKILL);
        waitpid(pid_, nullptr, 0);
    }

    bool ended() {
        int status = 0;
        if (!exitCode_ && waitpid(pid_, &status, WNOHANG) == pid_) {
            exitCode_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        }
        return exitCode_.has_value();
    }
    /// -1: it did not end.
    /// As a crash would.
    void killAtOnce() {
        kill(pid_, SIGKILL);
        exitCode();
    }
    int exitCode() {
        return until([this] { return ended(); }) ? *exitCode_ : -1;
    }

  private:
    pid_t pid_ = -1;
    std::optional<int> exitCode_;
};

inline std::string outputOf(const std::string& command) {
    std::FILE* pipe = popen((command + " 2>&1 < /dev/null").c_str(), "r");
    std::string output;
    std::array<char, 4096> buffer{};
    for (size_t got; (got = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
        output.append(buffer.data(), got);
    }
    pclose(pipe);
    return output;
}

inline bool isInstalled(const std::string& program) {
    return std::system(("command -v " + program + " > /dev/null 2>&1").c_str()) == 0;
}

/// An X server on a display that it chose itself.
class XServer {
  public:
    explicit XServer(const Words& more = {}) {
        int ends[2];
        if (pipe(ends) != 0) { return; }
        Words words{
            "Xvfb", "-displayfd", "3", "-screen", "0", "1280x720x24", "-nolisten", "tcp",
            // Otherwise it starts anew whenever its last client leaves, and drops who is just arriving.
            "-noreset"};
        words.insert(words.end(), more.begin(), more.end());
        server_ = std::make_unique<Child>(words, "xvfb.log", ends[1]);
        close(ends[1]);
        char digit = 0;
        while (::read(ends[0], &digit, 1) == 1 && digit != '\n') {
            name_ += digit;
        }
        close(ends[0]);
        if (!name_.empty()) { name_ = ":" + name_; }
    }
    const std::string& name() const { return name_; }

  private:
    std::unique_ptr<Child> server_;
    std::string name_;
};

struct Rect {
    int x = 0, y = 0, width = 0, height = 0;
    int centreX() const { return x + width / 2; }
    int centreY() const { return y + height / 2; }
};

/// Where the headless window of the same size has the widget.
inline std::optional<Rect> placeOf(const std::string& widgets, const std::string& name) {
    const size_t at = widgets.find("\"" + name + "\" ");
    Rect rect;
    if (at == std::string::npos) { return std::nullopt; }
    const char* numbers = widgets.c_str() + at + name.size() + 3;
    if (std::sscanf(numbers, "%d %d %d %d", &rect.x, &rect.y, &rect.width, &rect.height) != 4) {
        return std::nullopt;
    }
    return rect;
}

class RealWindow : public testing::Test {
  protected:
    void SetUp() override {
        for (const char* program : {"Xvfb", "xdotool"}) {
            if (!isInstalled(program)) { GTEST_SKIP() << program << " is not installed"; }
        }
        write("scene.json", kWindowScene);
        // What sessions keep for a recovery is the test's own.
        setenv("XDG_STATE_HOME", std::filesystem::absolute("state").c_str(), 1);
        setenv("XDG_CONFIG_HOME", std::filesystem::absolute("config").c_str(), 1);
        std::filesystem::remove_all("state");
        std::filesystem::remove_all("config");
    }

    /// Where widgets are once a headless window has played the script, which begins with a picture.
    void findWidgets(const std::string& script) {
        write("widgets.txt", "wait picture\n" + script + "print widgets\n");
        widgets_ = outputOf(std::string(GLINT_PROGRAM) +
                            " view scene.json --headless --size 1280x720 --scale 1 --recovery 3600 "
                            "--script widgets.txt");
    }

    /// Opens the window and waits until it has drawn the scene's first frame.
    void openWindow() {
        findWidgets("");
        display_ = std::make_unique<XServer>();
        ASSERT_FALSE(display_->name().empty()) << read("xvfb.log");
        setenv("DISPLAY", display_->name().c_str(), 1);
        std::remove("view.json");
        glint_ = std::make_unique<Child>(
            Words{GLINT_PROGRAM, "view", "scene.json", "--size", "1280x720", "--scale", "1", "--threads", "1",
                  "--recovery", "0.5", "--json", "view.json"},
            "glint.log");
        ASSERT_TRUE(titleSays("scene.json")) << read("glint.log");
    }

    bool titleSays(const std::string& part) {
        return until([&] {
                   return glint_->ended() ||
                          !(window_ = firstLine(outputOf("xdotool search --name '" + part + "' 2>/dev/null")))
                               .empty();
               }) &&
               !glint_->ended();
    }

    /// Holds Ctrl and the key until the title says so: pressed and released between two frames, a key would
    /// be lost.
    bool titleSaysAfterCtrl(const std::string& key, const std::string& part) {
        hand("keydown ctrl keydown " + key);
        const bool says = titleSays(part);
        hand("keyup " + key + " keyup ctrl");
        return says;
    }

    static std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

    void hand(const std::string& does) {
        const std::string said = outputOf("xdotool " + does);
        EXPECT_EQ(said, "") << does;
        std::this_thread::sleep_for(kPause);
    }

    /// Long enough for a frame to see it.
    void press(const std::string& key) {
        hand("keydown " + key);
        std::this_thread::sleep_for(std::chrono::seconds(1));
        hand("keyup " + key);
        std::this_thread::sleep_for(std::chrono::seconds(1));
    }

    void moveTo(int x, int y) {
        hand("mousemove --window " + window_ + " " + std::to_string(x) + " " + std::to_string(y));
    }

    void click(const std::string& widget) {
        const auto place = placeOf(widgets_, widget);
        ASSERT_TRUE(place) << widget << " is not in:\n" << widgets_;
        moveTo(place->centreX(), place->centreY());
        hand("mousedown 1");
        hand("mouseup 1");
    }

    void dragImage(int dx, int dy) { drag("Image", dx, dy); }
    void drag(const std::string& widget, int dx, int dy) {
        const auto place = placeOf(widgets_, widget);
        ASSERT_TRUE(place) << widgets_;
        moveTo(place->centreX(), place->centreY());
        hand("mousedown 1");
        for (int step = 1; step <= 12; ++step) {
            moveTo(place->centreX() + dx * step / 12, place->centreY() + dy * step / 12);
        }
        hand("mouseup 1");
    }

    /// An edit of the scene; the panels above it are closed for it.
    void dragAperture() {
        click("Render");
        findWidgets("close \"Render\"\nwait frames 3\n");
        click("Convergence");
        findWidgets("close \"Render\"\nclose \"Convergence\"\nwait frames 3\n");
        drag("Lens/Aperture", 60, 0);
    }

    nlohmann::json report() { return nlohmann::json::parse(read("view.json"), nullptr, false); }

    std::string widgets_;
    std::unique_ptr<XServer> display_;
    std::unique_ptr<Child> glint_;
    std::string window_;
};

}  // namespace glint::test
