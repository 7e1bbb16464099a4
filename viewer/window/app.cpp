#include "viewer/window/app.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include "engine/base/log.h"
#include "engine/io/atomic_file.h"
#include "engine/io/image_io.h"
#include "engine/render/image_file.h"
#include "engine/render/snapshot.h"
#include "viewer/commands/progress.h"
#include "viewer/window/frame_stats.h"
#include "viewer/window/script_player.h"
#include "viewer/window/shell.h"
#include "viewer/window/shown_image_source.h"
#include "viewer/window/theme.h"
#include "viewer/window/widgets.h"

namespace glint {
namespace {

constexpr double kFrameSeconds = 1.0 / 60.0;
constexpr double kQuietFrameSeconds = 0.1;  // while it renders and nobody touches anything
constexpr double kIdleFrameSeconds = 0.5;   // while nothing happens at all
constexpr double kLivelySeconds = 0.5;      // 60 Hz for so long after input
constexpr double kMotionEndSeconds = 0.12;  // without an edit, what is held does not move
constexpr uint32_t kHeadlessPasses = 64;
constexpr int kSettleFrames = 3;  // until ImGui's layout and the last picture are on screen

using Clock = std::chrono::steady_clock;

double seconds(Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }
double milliseconds(Clock::time_point from, Clock::time_point to) { return seconds(to - from) * 1000.0; }

class App {
  public:
    App(const ViewerOptions& options, std::unique_ptr<Backend> backend)
        : options_(options), model_(std::move(backend)) {}
    App(const App&) = delete;
    App& operator=(const App&) = delete;
    ~App();

    Status open(std::optional<SceneDescription> scene);
    Status run(bool* scriptFailed);

  private:
    void fitToScreen();
    void drawFrame();
    bool worthDrawing(Clock::time_point now);
    double pause(Clock::time_point now) const;
    std::string currentTitle() const;
    bool headlessDone();
    Status finish();
    Status saveScreenshot(const std::string& path) const;
    Status saveImageFile();
    Status saveFrameStats();

    ViewerOptions options_;
    std::unique_ptr<Surface> surface_;
    ImGuiContext* imgui_ = nullptr;
    bool rendererStarted_ = false;
    std::unique_ptr<ImageDisplay> display_;
    std::unique_ptr<ImageDisplay> otherDisplay_;  // the second picture of a comparison
    ShownImageSource source_;
    ShownImageSource otherSource_;
    WidgetRegistry registry_;
    Fonts fonts_;
    float loadedScale_ = 0.0f;
    float loadedFramebufferScale_ = 0.0f;
    Shell shell_;
    ViewerModel model_;
    std::unique_ptr<ScriptPlayer> player_;
    std::string title_;

    FrameStats stats_;
    double wakeMs_ = 0.0;
    Clock::time_point lastInput_ = Clock::now();
    Clock::time_point lastEdit_ = Clock::now();
    Clock::time_point lastDrawn_{};
    std::shared_ptr<const FilmSnapshot> drawnSnapshot_;
    std::shared_ptr<const FilmSnapshot> drawnOther_;
    int settled_ = 0;
    std::optional<ProgressLine> progress_;  // headless, when no script says what happens
};

App::~App() {
    display_.reset();
    otherDisplay_.reset();
    if (rendererStarted_) { ImGui_ImplOpenGL3_Shutdown(); }
    // The surface ends ImGui's platform back end, which lives in ImGui's context.
    surface_.reset();
    if (imgui_ != nullptr) { ImGui::DestroyContext(imgui_); }
}

Status App::open(std::optional<SceneDescription> scene) {
    imgui_ = ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    auto surface =
        options_.headless ? makeHeadlessSurface(options_.surface) : makeWindowSurface(options_.surface);
    if (!surface) { return surface.error(); }
    surface_ = std::move(*surface);
    rendererStarted_ = ImGui_ImplOpenGL3_Init("#version 330 core");
    if (!rendererStarted_) { return Error{"Dear ImGui cannot use this OpenGL context", {}}; }
    auto display = ImageDisplay::create(surface_->gl());
    if (!display) { return display.error(); }
    display_ = std::move(*display);
    auto other = ImageDisplay::create(surface_->gl());
    if (!other) { return other.error(); }
    otherDisplay_ = std::move(*other);
    if (options_.script) {
        player_ =
            std::make_unique<ScriptPlayer>(*options_.script, &registry_, &model_,
                                           [this](const std::string& path) { return saveScreenshot(path); });
    }
    model_.limits.passes = options_.passes;
    if (options_.headless && !options_.script && options_.passes == 0) {
        model_.limits.passes = kHeadlessPasses;
    }
    if (options_.headless && !options_.script) { progress_.emplace(); }
    if (scene) { model_.adopt(std::move(*scene)); }
    return {};
}

void App::fitToScreen() {
    const float content = surface_->contentScale();
    const float framebuffer = surface_->framebufferScale();
    if (content == loadedScale_ && framebuffer == loadedFramebufferScale_) { return; }
    if (loadedScale_ > 0.0f) { ImGui_ImplOpenGL3_DestroyFontsTexture(); }
    fonts_ = loadFonts(content, framebuffer);
    if (!fonts_.note.empty() && loadedScale_ == 0.0f) { logWarning("{}", fonts_.note); }
    applyTheme(content / framebuffer);
    loadedScale_ = content;
    loadedFramebufferScale_ = framebuffer;
}

void App::drawFrame() {
    const auto start = Clock::now();
    fitToScreen();
    ImGui_ImplOpenGL3_NewFrame();
    surface_->beginFrame();
    if (player_) { player_->feed(&ImGui::GetIO()); }
    ImGui::NewFrame();
    ui::beginFrame(&registry_, &fonts_, loadedScale_ / loadedFramebufferScale_);
    const bool held = shell_.draw(&model_, {display_.get(), otherDisplay_.get(), &source_, &otherSource_});
    const auto now = Clock::now();
    if (model_.commitEdits(held) != EditKind::None) { lastEdit_ = now; }
    if (!held || seconds(now - lastEdit_) > kMotionEndSeconds) { model_.finishMotion(); }
    ImGui::Render();
    const auto built = Clock::now();
    const auto reference = model_.usableReference();
    ShownImageSource::Wanted wanted{model_.snapshot(),
                                    model_.display.shown,
                                    reference,
                                    {model_.display.exposureStops, model_.display.toneMap}};
    source_.show(wanted, nullptr, display_.get());
    if (model_.display.split) {
        wanted.snapshot = model_.otherSnapshot();
        otherSource_.show(wanted, &source_, otherDisplay_.get());
    }
    model_.displayIsBehind = source_.isBehind() || (model_.display.split && otherSource_.isBehind());
    drawnSnapshot_ = model_.snapshot();
    drawnOther_ = model_.otherSnapshot();
    if (!options_.frameStats.empty()) { surface_->gl().Finish(); }
    const auto uploaded = Clock::now();
    const GlApi& gl = surface_->gl();
    const Vec2i size = surface_->framebufferSize();
    gl.Viewport(0, 0, size.x, size.y);
    gl.ClearColor(0.115f, 0.115f, 0.115f, 1.0f);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    surface_->present();
    lastDrawn_ = Clock::now();
    stats_.add({milliseconds(start, built), milliseconds(built, uploaded), milliseconds(uploaded, lastDrawn_),
                wakeMs_});
}

bool App::worthDrawing(Clock::time_point now) {
    if (player_ || !options_.frameStats.empty()) { return true; }
    if (seconds(now - lastInput_) < kLivelySeconds || model_.snapshot() != drawnSnapshot_ ||
        model_.otherSnapshot() != drawnOther_ || source_.isReady() || otherSource_.isReady()) {
        return true;
    }
    const bool active = model_.status().state == SessionState::Rendering ||
                        model_.status().state == SessionState::Building || model_.busy() ||
                        model_.awaitsEdit();
    return seconds(now - lastDrawn_) >= (active ? kQuietFrameSeconds : kIdleFrameSeconds);
}

double App::pause(Clock::time_point now) const {
    const SessionState state = model_.status().state;
    const bool idle = !player_ && options_.frameStats.empty() &&
                      seconds(now - lastInput_) >= kLivelySeconds &&
                      (state == SessionState::Finished || state == SessionState::Paused ||
                       state == SessionState::Empty || state == SessionState::Failed) &&
                      !model_.busy() && !model_.opening() && !model_.awaitsEdit() &&
                      !model_.displayIsBehind && !options_.headless;
    if (idle) { return kIdleFrameSeconds; }
    // A loop that had nothing to draw sleeps as well: without that it would take a core from the renderer.
    const double sinceDrawn = seconds(now - lastDrawn_);
    return sinceDrawn < kFrameSeconds ? kFrameSeconds - sinceDrawn : kFrameSeconds;
}

Status App::run(bool* scriptFailed) {
    auto planned = Clock::now();
    while (!surface_->shouldClose() && !shell_.quitWanted()) {
        wakeMs_ = std::max(0.0, milliseconds(planned, Clock::now()));
        model_.refresh();
        if (player_) {
            if (Status stepped = player_->step(); !stepped) {
                *scriptFailed = true;
                return stepped;
            }
        }
        if (surface_->takeInputFlag()) { lastInput_ = Clock::now(); }
        for (const std::string& file : surface_->takeDroppedFiles()) {
            model_.takeDroppedFile(file);
        }
        if (worthDrawing(Clock::now())) { drawFrame(); }
        if (const std::string title = currentTitle(); title != title_) { surface_->setTitle(title_ = title); }
        if (progress_) { progress_->update(model_.status(), model_.limits); }
        if (player_ ? player_->done() : headlessDone()) { break; }
        const auto now = Clock::now();
        const double wait = pause(now);
        planned = now + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(wait));
        surface_->waitEvents(wait);
        if (surface_->hasDisplay() && Clock::now() < planned) {
            planned = Clock::now();  // an event woke it
        }
    }
    return finish();
}

std::string App::currentTitle() const {
    if (!model_.hasScene()) { return "Glint"; }
    const std::string file = std::filesystem::path(model_.draft().path).filename().string();
    const bool paused = model_.status().state == SessionState::Paused;
    return fmt::format("{}{} – Glint", file, paused ? " (paused)" : "");
}

bool App::headlessDone() {
    if (!options_.headless) { return false; }
    const SessionStatus& status = model_.status();
    const bool over = status.state == SessionState::Failed ||
                      (status.state == SessionState::Finished && !model_.awaitsEdit() && model_.snapshot() &&
                       model_.snapshot()->passes == status.passes);
    settled_ = over && model_.snapshot() == drawnSnapshot_ && !model_.displayIsBehind ? settled_ + 1 : 0;
    if (over) {
        lastInput_ = Clock::now();  // draw the frames that are left without pause
    }
    return settled_ > kSettleFrames;
}

Status App::finish() {
    if (progress_) { progress_->finish(); }
    if (model_.status().state == SessionState::Failed && options_.headless) {
        return Error{model_.status().error, {}};
    }
    if (!options_.screenshot.empty()) {
        if (Status saved = saveScreenshot(options_.screenshot); !saved) { return saved; }
        fmt::print(stderr, "the window is in {}\n", options_.screenshot);
    }
    if (!options_.output.empty()) {
        if (Status saved = saveImageFile(); !saved) { return saved; }
        fmt::print(stderr, "the picture is in {}\n", options_.output);
    }
    return options_.frameStats.empty() ? Status() : saveFrameStats();
}

Status App::saveScreenshot(const std::string& path) const {
    const Vec2i size = surface_->framebufferSize();
    return savePng(path, Image8{size.x, size.y, readSurface(*surface_)});
}

Status App::saveImageFile() {
    const auto capture = model_.session().capture();
    if (!capture) { return Error{"there is no picture to save", SourcePlace{options_.output, 0, 0, ""}}; }
    auto image = makeSnapshot(*capture, {.standardError = true}, 0);
    const ImageOptions look{.exposureStops = model_.display.exposureStops, .toneMap = model_.display.toneMap};
    return saveImage(options_.output, *image, *capture->scene, look);
}

Status App::saveFrameStats() {
    const std::string report = stats_.json(model_.session().status(), model_.draft().camera);
    if (options_.frameStats != "-") { return writeFileAtomically(options_.frameStats, report); }
    std::fputs(report.c_str(), stdout);
    return {};
}

}  // namespace

Status runViewer(const ViewerOptions& options, std::unique_ptr<Backend> backend,
                 std::optional<SceneDescription> scene, bool* scriptFailed) {
    App app(options, std::move(backend));
    if (Status opened = app.open(std::move(scene)); !opened) { return opened; }
    return app.run(scriptFailed);
}

}  // namespace glint
