#include "viewer/window/app.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include "engine/base/log.h"
#include "viewer/base/interrupt.h"
#include "viewer/base/progress.h"
#include "viewer/base/state_folder.h"
#include "viewer/ui/keyboard_walk.h"
#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"
#include "viewer/window/frame_pacer.h"
#include "viewer/window/frame_stats.h"
#include "viewer/window/key_codes.h"
#include "viewer/window/script_player.h"
#include "viewer/window/shell.h"
#include "viewer/window/view_outputs.h"

namespace glint {
namespace {

constexpr uint32_t kHeadlessPasses = 64;
constexpr int kSettleFrames = 3;  // until ImGui's layout and the last image are on screen

using Clock = FramePacer::Clock;

double milliseconds(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count() * 1000.0;
}

bool isResting(SessionState state) {
    return state == SessionState::Finished || state == SessionState::Paused || state == SessionState::Empty ||
           state == SessionState::Failed;
}

class App {
  public:
    App(const ViewerOptions& options, std::unique_ptr<Backend> backend)
        : options_(options),
          workspace_(std::move(backend)),
          pacer_(options.script.has_value() || !options.frameStats.empty() || options.uiSeconds != nullptr) {}
    App(const App&) = delete;
    App& operator=(const App&) = delete;
    ~App();

    Status open(std::optional<SceneDescription> scene);
    /// False: interrupted.
    Result<bool> run(bool* scriptFailed);

  private:
    void fitToScreen();
    void drawFrame();
    bool mustEnd();
    bool worthDrawing();
    bool isIdle() const;
    std::string currentTitle() const;
    bool headlessDone();
    Status finish();

    ViewerOptions options_;
    std::unique_ptr<Surface> surface_;
    ImGuiContext* imgui_ = nullptr;
    bool rendererStarted_ = false;
    ImagePanes panes_;
    WidgetRegistry registry_;
    Fonts fonts_;
    float loadedScale_ = 0.0f;
    float loadedFramebufferScale_ = 0.0f;
    Shell shell_;
    Workspace workspace_;
    std::unique_ptr<ScriptPlayer> player_;
    std::string title_;

    FrameStats stats_;
    double wakeMs_ = 0.0;
    FramePacer pacer_;
    int settled_ = 0;
    InterruptGuard interrupt_;
    std::optional<ProgressLine> progress_;  // headless, when no script says what happens
};

App::~App() {
    panes_.release();
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
    if (Status created = panes_.create(surface_->gl()); !created) { return created.error(); }
    if (options_.script) {
        player_ = std::make_unique<ScriptPlayer>(
            *options_.script, &registry_, &workspace_,
            [this](const std::string& path) { return saveScreenshot(*surface_, path); });
    }
    uint32_t& passLimit = workspace_.render.request.limits.passes;
    passLimit = options_.passes;
    if (options_.headless && !options_.script) {
        passLimit = passLimit > 0 ? passLimit : kHeadlessPasses;
        progress_.emplace();
    }
    workspace_.frames.makeBackend = options_.anotherBackend;
    workspace_.presets.makeBackend = options_.anotherBackend;
    workspace_.sceneFiles.dialog.usesDesktop = !options_.headless;
    workspace_.display.autoExposure = !options_.noAutoExposure;
    if (options_.ocio) { workspace_.ocio.use(options_.ocio); }
    if (options_.recoverySeconds > 0.0) {
        workspace_.rememberIn(stateFolder(), options_.recoverySeconds);
        // A script's keys mean the same on every machine.
        const bool isScripted = options_.script && !options_.headless;
        if (!isScripted) { workspace_.keys.begin(preferencesFolder() + "/keys", keyNames()); }
    }
    workspace_.sceneFiles.reading = options_.reading;
    if (scene) { workspace_.adopt(std::move(*scene)); }
    if (!options_.checkpoint.empty()) { workspace_.takeDroppedFile(options_.checkpoint); }
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
    panes_.takeColors(&workspace_);
    ImGui_ImplOpenGL3_NewFrame();
    surface_->beginFrame();
    if (player_) { player_->feed(&ImGui::GetIO()); }
    ui::prepareWalk();
    ImGui::NewFrame();
    ui::beginFrame(&registry_, &fonts_, loadedScale_ / loadedFramebufferScale_);
    const bool held = shell_.draw(&workspace_, panes_);
    if (workspace_.commitEdits(held, held || pacer_.isLively())) { pacer_.noteEdit(); }
    if (!held || pacer_.motionHasEnded()) { workspace_.finishMotion(); }
    ImGui::Render();
    const auto built = Clock::now();
    panes_.show(&workspace_);
    if (!options_.frameStats.empty()) { surface_->gl().Finish(); }
    const auto uploaded = Clock::now();
    const GlApi& gl = surface_->gl();
    const Vec2i size = surface_->framebufferSize();
    gl.Viewport(0, 0, size.x, size.y);
    gl.ClearColor(0.115f, 0.115f, 0.115f, 1.0f);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    surface_->present();
    pacer_.noteDrawn();
    stats_.add({milliseconds(start, built), milliseconds(built, uploaded),
                milliseconds(uploaded, Clock::now()), wakeMs_});
}

bool App::worthDrawing() {
    const bool hasNews = panes_.areOld(workspace_);
    const SessionState state = workspace_.render.status().state;
    const bool isBusy = state == SessionState::Rendering || state == SessionState::Building ||
                        workspace_.busy() || workspace_.awaitsEdit();
    return pacer_.worthDrawing(hasNews, isBusy);
}

bool App::isIdle() const {
    return isResting(workspace_.render.status().state) && !workspace_.busy() &&
           !workspace_.sceneFiles.opening() && !workspace_.awaitsEdit() && !workspace_.displayIsBehind &&
           !options_.headless;
}

Result<bool> App::run(bool* scriptFailed) {
    auto planned = Clock::now();
    while (!mustEnd()) {
        wakeMs_ = std::max(0.0, milliseconds(planned, Clock::now()));
        workspace_.refresh();
        if (player_) {
            if (Status stepped = player_->step(); !stepped) {
                *scriptFailed = true;
                return stepped.error();
            }
        }
        if (surface_->takeInputFlag() || (player_ && player_->hasActed())) { pacer_.noteInput(); }
        for (const std::string& file : surface_->takeDroppedFiles()) {
            workspace_.takeDroppedFile(file);
        }
        if (worthDrawing()) { drawFrame(); }
        if (const std::string title = currentTitle(); title != title_) { surface_->setTitle(title_ = title); }
        if (progress_) { progress_->update(workspace_.render.status(), workspace_.render.request.limits); }
        if (player_ ? player_->done() : headlessDone()) { break; }
        const auto now = Clock::now();
        const double wait = pacer_.pause(isIdle());
        planned = now + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(wait));
        surface_->waitEvents(wait);
        if (surface_->hasDisplay() && Clock::now() < planned) {
            planned = Clock::now();  // an event woke it
        }
    }
    if (const Status finished = finish(); !finished) { return finished.error(); }
    return !interrupt_.interrupted();
}

bool App::mustEnd() {
    if (surface_->shouldClose()) {
        shell_.dialogs.askToClose(workspace_);
        surface_->refuseClose();
        pacer_.noteInput();
    }
    return interrupt_.interrupted() || shell_.dialogs.mustClose(workspace_.document);
}

std::string App::currentTitle() const {
    if (!workspace_.document.isOpen()) { return "Glint"; }
    const std::string file = std::filesystem::path(workspace_.document.draft().path).filename().string();
    const bool paused = workspace_.render.status().state == SessionState::Paused && !workspace_.render.isHeld;
    const bool isUnsaved = workspace_.document.unsaved() != SceneDocument::Unsaved::Nothing;
    return fmt::format("{}{}{} – Glint", file, isUnsaved ? "*" : "", paused ? " (paused)" : "");
}

bool App::headlessDone() {
    if (!options_.headless) { return false; }
    const SessionStatus& status = workspace_.render.status();
    const auto& snapshot = workspace_.render.snapshot();
    const bool over = status.state == SessionState::Failed ||
                      (status.state == SessionState::Finished && !workspace_.awaitsEdit() && snapshot &&
                       snapshot->passes == status.passes);
    settled_ = over && snapshot == panes_.own.drawn && !workspace_.displayIsBehind ? settled_ + 1 : 0;
    if (over) {
        pacer_.noteInput();  // draw the frames that are left without pause
    }
    return settled_ > kSettleFrames;
}

Status App::finish() {
    workspace_.layout.save();
    if (progress_) { progress_->finish(); }
    // A session that is ended from outside could not ask.
    if (interrupt_.interrupted() && workspace_.document.hasUnsavedEdits()) { workspace_.backup.keep(); }
    if (workspace_.render.status().state == SessionState::Failed && options_.headless) {
        return Error{workspace_.render.status().error, {}};
    }
    if (options_.uiSeconds != nullptr) { *options_.uiSeconds = stats_.uiSeconds(); }
    return saveViewOutputs(options_, *surface_, stats_, interrupt_.interrupted(), &workspace_);
}

}  // namespace

Result<bool> runViewer(const ViewerOptions& options, std::unique_ptr<Backend> backend,
                       std::optional<SceneDescription> scene, bool* scriptFailed) {
    App app(options, std::move(backend));
    if (Status opened = app.open(std::move(scene)); !opened) { return opened.error(); }
    return app.run(scriptFailed);
}

}  // namespace glint
