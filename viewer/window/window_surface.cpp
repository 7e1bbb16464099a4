// A surface in a GLFW window.

#define GLFW_INCLUDE_NONE
#include <algorithm>
#include <cmath>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <fmt/format.h>
#include <imgui.h>

#include "viewer/window/surface.h"

namespace glint {
namespace {

std::string lastGlfwError() {
    const char* description = nullptr;
    glfwGetError(&description);
    return description != nullptr ? description : "unknown reason";
}

class WindowSurface final : public Surface {
  public:
    explicit WindowSurface(const SurfaceOptions& options) : options_(options) {}
    WindowSurface(const WindowSurface&) = delete;
    WindowSurface& operator=(const WindowSurface&) = delete;

    ~WindowSurface() override {
        if (backendStarted_) { ImGui_ImplGlfw_Shutdown(); }
        if (window_ != nullptr) { glfwDestroyWindow(window_); }
        glfwTerminate();
    }

    Status open() {
        if (!glfwInit()) { return Error{fmt::format("no window can be opened: {}", lastGlfwError()), {}}; }
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
        window_ = glfwCreateWindow(options_.width, options_.height, "Glint", nullptr, nullptr);
        if (window_ == nullptr) {
            return Error{fmt::format("no window with OpenGL 3.3 can be opened: {}", lastGlfwError()), {}};
        }
        glfwSetWindowSizeLimits(window_, 640, 400, GLFW_DONT_CARE, GLFW_DONT_CARE);
        glfwMakeContextCurrent(window_);
        glfwSwapInterval(1);
        watchInput();
        auto loaded = loadGlApi([](const char* name) { return glfwGetProcAddress(name); });
        if (!loaded) { return loaded.error(); }
        gl_ = *loaded;
        return {};
    }

    const GlApi& gl() const override { return gl_; }
    void waitEvents(double seconds) override {
        if (seconds > 0.0) {
            glfwWaitEventsTimeout(seconds);
        } else {
            glfwPollEvents();
        }
    }

    void beginFrame() override {
        // ImGui chains to our callbacks, so it is started after them; its context exists only by now.
        if (!backendStarted_) { backendStarted_ = ImGui_ImplGlfw_InitForOpenGL(window_, true); }
        ImGui_ImplGlfw_NewFrame();
    }

    void present() override { glfwSwapBuffers(window_); }
    bool shouldClose() const override { return glfwWindowShouldClose(window_) != 0; }
    void refuseClose() override { glfwSetWindowShouldClose(window_, GLFW_FALSE); }
    bool takeInputFlag() override { return std::exchange(inputArrived_, false); }
    std::vector<std::string> takeDroppedFiles() override { return std::exchange(droppedFiles_, {}); }

    Vec2i framebufferSize() const override {
        Vec2i size{0};
        glfwGetFramebufferSize(window_, &size.x, &size.y);
        return size;
    }

    float contentScale() const override {
        if (options_.contentScale > 0.0f) { return options_.contentScale; }
        float x = 1.0f;
        float y = 1.0f;
        glfwGetWindowContentScale(window_, &x, &y);
        return std::clamp(std::max(x, y), 0.5f, 4.0f);
    }

    float framebufferScale() const override {
        int width = 0;
        int height = 0;
        glfwGetWindowSize(window_, &width, &height);
        const int pixels = framebufferSize().x;
        return width > 0 && pixels > 0 ? static_cast<float>(pixels) / static_cast<float>(width) : 1.0f;
    }

    void setTitle(const std::string& title) override { glfwSetWindowTitle(window_, title.c_str()); }
    bool hasDisplay() const override { return true; }

  private:
    void watchInput() {
        glfwSetWindowUserPointer(window_, this);
        glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int, int, int) { noteInput(w); });
        glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double) { noteInput(w); });
        glfwSetKeyCallback(window_, [](GLFWwindow* w, int, int, int, int) { noteInput(w); });
        glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned int) { noteInput(w); });
        glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double, double) { noteInput(w); });
        glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int) { noteInput(w); });
        glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int) { noteInput(w); });
        glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { noteInput(w); });
        glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { noteInput(w); });
        glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) { noteInput(w); });
        glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
            noteInput(w);
            auto& files = static_cast<WindowSurface*>(glfwGetWindowUserPointer(w))->droppedFiles_;
            files.insert(files.end(), paths, paths + count);
        });
    }

    static void noteInput(GLFWwindow* window) {
        static_cast<WindowSurface*>(glfwGetWindowUserPointer(window))->inputArrived_ = true;
    }

    SurfaceOptions options_;
    GLFWwindow* window_ = nullptr;
    GlApi gl_;
    bool backendStarted_ = false;
    bool inputArrived_ = true;
    std::vector<std::string> droppedFiles_;
};

}  // namespace

Result<std::unique_ptr<Surface>> makeWindowSurface(const SurfaceOptions& options) {
    auto surface = std::make_unique<WindowSurface>(options);
    if (Status opened = surface->open(); !opened) { return opened.error(); }
    return std::unique_ptr<Surface>(std::move(surface));
}

}  // namespace glint
