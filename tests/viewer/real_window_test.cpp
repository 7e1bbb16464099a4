// A real window on an X server of the test's own (Xvfb), with a mouse and a keyboard that are not ours
// (xdotool): a click pauses, a drag on the picture moves the camera, closing ends the program with exit
// code 0.
//
// Nothing here is timed: the test waits for what the window's title says. The guard against hanging is
// generous. Where a widget is comes from a script's `print widgets` in a headless window of the same size.
#include <array>
#include <chrono>
#include <cmath>
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
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

// Last: its macros collide with names of other headers.
#if __has_include(<X11/Xlib.h>)
#include <X11/Xlib.h>
#define GLINT_TEST_HAS_XLIB 1
#else
#define GLINT_TEST_HAS_XLIB 0
#endif

namespace {

using Words = std::vector<std::string>;

constexpr auto kHangGuard = std::chrono::seconds(240);
constexpr auto kPause = std::chrono::milliseconds(60);  // between what a hand does; a frame or more

constexpr const char* kScene = R"({
  "glint": 1,
  "resolution": [96, 72],
  "camera": { "position": [0, 1, 4], "target": [0, 1, 0] },
  "materials": { "grey": { "type": "diffuse", "color": 0.5 } },
  "objects": [{ "type": "sphere", "material": "grey", "center": [0, 1, 0], "radius": 1 }],
  "environment": { "color": 1 }
})";

void write(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

std::string read(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

bool until(const std::function<bool()>& met) {
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
    int exitCode() {
        return until([this] { return ended(); }) ? *exitCode_ : -1;
    }

  private:
    pid_t pid_ = -1;
    std::optional<int> exitCode_;
};

std::string outputOf(const std::string& command) {
    std::FILE* pipe = popen((command + " 2>&1 < /dev/null").c_str(), "r");
    std::string output;
    std::array<char, 4096> buffer{};
    for (size_t got; (got = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
        output.append(buffer.data(), got);
    }
    pclose(pipe);
    return output;
}

bool isInstalled(const std::string& program) {
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
std::optional<Rect> placeOf(const std::string& widgets, const std::string& name) {
    const size_t at = widgets.find("\"" + name + "\" ");
    Rect rect;
    if (at == std::string::npos) { return std::nullopt; }
    const char* numbers = widgets.c_str() + at + name.size() + 3;
    if (std::sscanf(numbers, "%d %d %d %d", &rect.x, &rect.y, &rect.width, &rect.height) != 4) {
        return std::nullopt;
    }
    return rect;
}

#if GLINT_TEST_HAS_XLIB
/// What a window manager sends when its close button is clicked.
void askToClose(const std::string& display, unsigned long window) {
    ::Display* connection = XOpenDisplay(display.c_str());
    ASSERT_NE(connection, nullptr);
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window;
    event.xclient.message_type = XInternAtom(connection, "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(XInternAtom(connection, "WM_DELETE_WINDOW", False));
    event.xclient.data.l[1] = CurrentTime;
    XSendEvent(connection, window, False, NoEventMask, &event);
    XCloseDisplay(connection);
}

/// Another program that files are dragged from, by the XDND protocol (version 5, as a file manager
/// speaks it).
class DragSource {
  public:
    explicit DragSource(const std::string& display) : display_(XOpenDisplay(display.c_str())) {
        window_ = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
    }
    DragSource(const DragSource&) = delete;
    DragSource& operator=(const DragSource&) = delete;
    ~DragSource() { XCloseDisplay(display_); }

    /// Drops what `uriList` names in the target's middle; true when the target said that it took it.
    bool drop(::Window target, const std::string& uriList) {
        XSetSelectionOwner(display_, atom("XdndSelection"), window_, CurrentTime);
        const long list = static_cast<long>(atom("text/uri-list"));
        say(target, "XdndEnter", {5L << 24, list, 0, 0});
        const long copy = static_cast<long>(atom("XdndActionCopy"));
        say(target, "XdndPosition", {0, (300L << 16) | 300, CurrentTime, copy});
        if (!answered("XdndStatus", uriList)) { return false; }
        say(target, "XdndDrop", {0, CurrentTime, 0, 0});
        return answered("XdndFinished", uriList);
    }

  private:
    Atom atom(const char* name) { return XInternAtom(display_, name, False); }

    void say(::Window target, const char* message, const std::array<long, 4>& data) {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = target;
        event.xclient.message_type = atom(message);
        event.xclient.format = 32;
        event.xclient.data.l[0] = static_cast<long>(window_);
        for (size_t i = 0; i < data.size(); ++i) {
            event.xclient.data.l[i + 1] = data[i];
        }
        XSendEvent(display_, target, False, NoEventMask, &event);
        XFlush(display_);
    }

    /// Hands out the list when asked, until the answer arrives that is waited for.
    bool answered(const char* message, const std::string& uriList) {
        const Atom wanted = atom(message);
        bool isThere = false;
        return until([&] {
            while (!isThere && XPending(display_) > 0) {
                XEvent event{};
                XNextEvent(display_, &event);
                if (event.type == SelectionRequest) { handOut(event.xselectionrequest, uriList); }
                isThere = event.type == ClientMessage && event.xclient.message_type == wanted;
            }
            return isThere;
        });
    }

    void handOut(const XSelectionRequestEvent& request, const std::string& uriList) {
        XChangeProperty(display_, request.requestor, request.property, request.target, 8, PropModeReplace,
                        reinterpret_cast<const unsigned char*>(uriList.data()),
                        static_cast<int>(uriList.size()));
        XEvent event{};
        event.xselection.type = SelectionNotify;
        event.xselection.requestor = request.requestor;
        event.xselection.selection = request.selection;
        event.xselection.target = request.target;
        event.xselection.property = request.property;
        event.xselection.time = request.time;
        XSendEvent(display_, request.requestor, False, NoEventMask, &event);
        XFlush(display_);
    }

    ::Display* display_;
    ::Window window_ = 0;
};
#endif

class RealWindow : public testing::Test {
  protected:
    void SetUp() override {
        for (const char* program : {"Xvfb", "xdotool"}) {
            if (!isInstalled(program)) { GTEST_SKIP() << program << " is not installed"; }
        }
        write("scene.json", kScene);
    }

    /// Opens the window and waits until it has drawn the scene's first frame.
    void openWindow() {
        write("widgets.txt", "wait picture\nprint widgets\n");
        widgets_ = outputOf(std::string(GLINT_PROGRAM) +
                            " view scene.json --headless --size 1280x720 --scale 1 --script widgets.txt");
        display_ = std::make_unique<XServer>();
        ASSERT_FALSE(display_->name().empty()) << read("xvfb.log");
        setenv("DISPLAY", display_->name().c_str(), 1);
        std::remove("view.json");
        glint_ = std::make_unique<Child>(Words{GLINT_PROGRAM, "view", "scene.json", "--size", "1280x720",
                                               "--scale", "1", "--threads", "1", "--json", "view.json"},
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

    static std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

    void hand(const std::string& does) {
        const std::string said = outputOf("xdotool " + does);
        EXPECT_EQ(said, "") << does;
        std::this_thread::sleep_for(kPause);
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

    void dragImage(int dx, int dy) {
        const auto place = placeOf(widgets_, "Image");
        ASSERT_TRUE(place) << widgets_;
        moveTo(place->centreX(), place->centreY());
        hand("mousedown 1");
        for (int step = 1; step <= 12; ++step) {
            moveTo(place->centreX() + dx * step / 12, place->centreY() + dy * step / 12);
        }
        hand("mouseup 1");
    }

    nlohmann::json report() { return nlohmann::json::parse(read("view.json"), nullptr, false); }

    std::string widgets_;
    std::unique_ptr<XServer> display_;
    std::unique_ptr<Child> glint_;
    std::string window_;
};

TEST_F(RealWindow, AClickPausesADragMovesTheCameraAndClosingEndsIt) {
#if GLINT_TEST_HAS_XLIB
    openWindow();
    if (HasFatalFailure()) { return; }
    click("Render/Pause");
    ASSERT_TRUE(titleSays("paused")) << read("glint.log");
    dragImage(120, 30);
    askToClose(display_->name(), std::stoul(window_));
    EXPECT_EQ(glint_->exitCode(), 0) << read("glint.log");
    const nlohmann::json left = report();
    ASSERT_TRUE(left.contains("session")) << read("view.json");
    EXPECT_GE(left["session"]["restarts"], 2) << left["session"];
    const auto position = left["camera"]["position"].get<std::vector<double>>();
    // Orbiting keeps the distance to the target.
    EXPECT_GT(std::abs(position[0]), 0.1);
    EXPECT_NEAR(std::hypot(position[0], position[1] - 1.0, position[2]), 4.0, 1e-3);
#else
    GTEST_SKIP() << "Xlib's headers are not installed";
#endif
}

TEST_F(RealWindow, FilesAreDroppedOnIt) {
#if GLINT_TEST_HAS_XLIB
    openWindow();
    if (HasFatalFailure()) { return; }
    write("another scene.json", kScene);
    write("broken.json", "{\n  \"glint\": 1,\n  \"camra\": 3\n}\n");
    write("no picture.png", "hello");
    const std::string folder = "file://" + std::filesystem::current_path().string() + "/";
    const ::Window target = std::stoul(window_);
    DragSource source(display_->name());
    const auto logSays = [](const char* what) {
        return until([&] { return read("glint.log").find(what) != std::string::npos; });
    };
    EXPECT_TRUE(source.drop(target, folder + "broken.json\r\n"));
    EXPECT_TRUE(logSays("camra")) << read("glint.log");
    EXPECT_TRUE(source.drop(target, folder + "no%20picture.png\r\n" + folder + "\r\n"));
    EXPECT_TRUE(logSays("no picture.png: ")) << read("glint.log");
    EXPECT_TRUE(logSays("is a folder; expected a scene file")) << read("glint.log");
    EXPECT_TRUE(source.drop(target, folder + "another%20scene.json\r\n"));
    EXPECT_TRUE(titleSays("another scene.json")) << read("glint.log");
    askToClose(display_->name(), target);
    EXPECT_EQ(glint_->exitCode(), 0) << read("glint.log");
#else
    GTEST_SKIP() << "Xlib's headers are not installed";
#endif
}

TEST_F(RealWindow, TheKeyboardPausesAndQuits) {
    openWindow();
    if (HasFatalFailure()) { return; }
    hand("windowfocus " + window_);
    // Held until it is seen: pressed and released between two frames, a key would be lost.
    hand("keydown space");
    ASSERT_TRUE(titleSays("paused")) << read("glint.log");
    hand("keyup space");
    hand("keydown ctrl keydown q");
    EXPECT_EQ(glint_->exitCode(), 0) << read("glint.log");
    const nlohmann::json left = report();
    ASSERT_TRUE(left.contains("session")) << read("view.json");
    EXPECT_EQ(left["session"]["state"], "paused");
    EXPECT_EQ(left["session"]["restarts"], 1);
}

TEST_F(RealWindow, ADisplayWithoutOpenGlIsExitTwoWithTheCause) {
    XServer display({"-extension", "GLX"});
    ASSERT_FALSE(display.name().empty()) << read("xvfb.log");
    setenv("DISPLAY", display.name().c_str(), 1);
    Child glint({GLINT_PROGRAM, "view", "scene.json"}, "glint.log");
    EXPECT_EQ(glint.exitCode(), 2);
    EXPECT_THAT(read("glint.log"), testing::HasSubstr("no window with OpenGL 3.3 can be opened: "));
}

TEST_F(RealWindow, OpenGlThatIsTooOldIsExitTwoWithTheCause) {
    XServer display;
    ASSERT_FALSE(display.name().empty()) << read("xvfb.log");
    setenv("DISPLAY", display.name().c_str(), 1);
    Child glint({"env", "MESA_GL_VERSION_OVERRIDE=2.1", GLINT_PROGRAM, "view", "scene.json"}, "glint.log");
    EXPECT_EQ(glint.exitCode(), 2);
    EXPECT_THAT(read("glint.log"), testing::HasSubstr("no window with OpenGL 3.3 can be opened: "));
}

TEST_F(RealWindow, ADisplayThatIsNotThereIsExitTwoWithTheCause) {
    setenv("DISPLAY", ":987", 1);
    Child glint({GLINT_PROGRAM, "view", "scene.json"}, "glint.log");
    EXPECT_EQ(glint.exitCode(), 2);
    EXPECT_THAT(read("glint.log"), testing::HasSubstr("no window can be opened: "));
}

}  // namespace
