#include "viewer/window/script_player.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <string_view>

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/window/key_codes.h"

namespace glint {
namespace {

constexpr int kScrollFrames = 6;
constexpr int kFramesToShow = 2;             // until what has come is on screen
constexpr double kSettlingSeconds = 5.0;     // by then what was asked for before has had its effect
constexpr double kHangGuardSeconds = 900.0;  // of one wait; only so that a broken script ends

double secondsNow() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int buttonOf(const ScriptStatement& statement, size_t word) {
    if (word >= statement.words.size() || statement.words[word].text == "left") {
        return ImGuiMouseButton_Left;
    }
    return statement.words[word].text == "right" ? ImGuiMouseButton_Right : ImGuiMouseButton_Middle;
}

/// It neither is input nor changes anything.
bool isLooking(std::string_view verb) {
    constexpr std::array<std::string_view, 5> kVerbs{"wait", "expect", "print", "mark", "screenshot"};
    return std::ranges::find(kVerbs, verb) != kVerbs.end();
}

Vec2 centreOf(const WidgetRecord& widget) { return glm::floor((widget.min + widget.max) * 0.5f); }

}  // namespace

ScriptPlayer::ScriptPlayer(std::vector<ScriptStatement> statements, WidgetRegistry* registry,
                           Workspace* workspace, Screenshot screenshot)
    : statements_(std::move(statements)),
      registry_(registry),
      workspace_(workspace),
      screenshot_(std::move(screenshot)) {
    if (!statements_.empty()) { workspace_->inputs.reads("the script", statements_.front().place.file); }
}

Status ScriptPlayer::step() {
    wheel_ = 0.0f;
    typed_.clear();
    hasActed_ = false;
    if (registry_->widgets().empty()) {
        return {};  // the first frames: nothing has been on screen yet
    }
    while (next_ < statements_.size() && actions_.empty() && !finishing_) {
        if (attempts_ == 0) { began_ = secondsNow(); }
        hasActed_ = hasActed_ || !isLooking(statements_[next_].verb);
        auto progress = run(statements_[next_]);
        if (!progress) {
            next_ = statements_.size();
            return progress.error();
        }
        if (*progress == Progress::Again) {
            ++attempts_;
            return {};
        }
        attempts_ = 0;
        ++next_;
    }
    if (actions_.empty()) {
        finishing_ = false;
        return {};
    }
    hasActed_ = true;
    const Action action = actions_.front();
    actions_.pop_front();
    finishing_ = actions_.empty();
    switch (action.kind) {
        case Action::Kind::Move:
            mouse_ = action.at;
            break;
        case Action::Kind::PressAt:
            mouse_ = action.at;
            buttons_[action.code] = true;
            break;
        case Action::Kind::Press:
            buttons_[action.code] = true;
            break;
        case Action::Kind::Release:
            buttons_[action.code] = false;
            break;
        case Action::Kind::KeyDown:
            keys_[action.code] = true;
            break;
        case Action::Kind::KeyUp:
            keys_[action.code] = false;
            break;
        case Action::Kind::Wheel:
            wheel_ = action.at.y;
            break;
        case Action::Kind::Text:
            typed_ = action.text;
            break;
    }
    return {};
}

void ScriptPlayer::feed(ImGuiIO* io) {
    io->MousePos = {mouse_.x, mouse_.y};
    std::copy(std::begin(buttons_), std::end(buttons_), io->MouseDown);
    std::copy(std::begin(keys_), std::end(keys_), io->KeysDown);
    io->MouseWheel = wheel_;
    const auto isDown = [this](const char* name) { return keys_[*keyCode(name)]; };
    io->KeyShift = isDown("shift");
    io->KeyCtrl = isDown("ctrl");
    io->KeyAlt = isDown("alt");
    if (!typed_.empty()) { io->AddInputCharactersUTF8(typed_.c_str()); }
}

void ScriptPlayer::click(Vec2 at, int button) {
    actions_.push_back({Action::Kind::Move, at, 0, ""});
    actions_.push_back({Action::Kind::Press, {}, button, ""});
    actions_.push_back({Action::Kind::Release, {}, button, ""});
}

void ScriptPlayer::drag(Vec2 from, Vec2 to, int button) {
    actions_.push_back({Action::Kind::Move, from, 0, ""});
    actions_.push_back({Action::Kind::Press, {}, button, ""});
    actions_.push_back({Action::Kind::Move, to, 0, ""});
    actions_.push_back({Action::Kind::Release, {}, button, ""});
}

void ScriptPlayer::press(const ScriptStatement& statement) {
    if (statement.words.size() < 2) {
        actions_.push_back({Action::Kind::Press, {}, buttonOf(statement, 0), ""});
    } else {
        const Vec2 at(statement.number(0), statement.number(1));
        actions_.push_back({Action::Kind::PressAt, at, buttonOf(statement, 2), ""});
    }
}

Result<std::optional<WidgetRecord>> ScriptPlayer::reachable(const ScriptStatement& statement) {
    auto widget = registry_->find(statement.words[0].text);
    if (!widget && attempts_ < kScrollFrames) { return std::optional<WidgetRecord>(); }
    if (!widget) { return statement.errorAt(0, widget.error().message); }
    if (widget->visible) { return std::optional<WidgetRecord>(*widget); }
    if (attempts_ >= 2 * kScrollFrames) {
        return statement.errorAt(0,
                                 fmt::format("\"{}\" cannot be scrolled into view", statement.words[0].text));
    }
    registry_->scrollTo(*widget);
    return std::optional<WidgetRecord>();
}

Result<ScriptPlayer::Progress> ScriptPlayer::runPointer(const ScriptStatement& statement) {
    const size_t leastNumbers = statement.verb == "drag" ? 4 : 2;
    if (!statement.words[0].quoted && statement.words.size() >= leastNumbers) {
        const Vec2 at(statement.number(0), statement.number(1));
        if (statement.verb == "move") {
            actions_.push_back({Action::Kind::Move, at, 0, ""});
        } else if (statement.verb == "click") {
            click(at, buttonOf(statement, 2));
        } else {
            drag(at, {statement.number(2), statement.number(3)}, buttonOf(statement, 4));
        }
        return Progress::Done;
    }
    const auto widget = reachable(statement);
    if (!widget) { return widget.error(); }
    if (!*widget) { return Progress::Again; }
    const Vec2 at = centreOf(**widget);
    if (statement.verb == "move") {
        const bool isShared = statement.words.size() > 1;
        const Vec2 share = isShared ? Vec2(statement.number(1), statement.number(2)) : Vec2(0.5f);
        actions_.push_back(
            {Action::Kind::Move, (*widget)->min + ((*widget)->max - (*widget)->min) * share, 0, ""});
    } else if (statement.verb == "click") {
        click(at, ImGuiMouseButton_Left);
    } else {
        drag(at, at + Vec2(statement.number(1), statement.number(2)), ImGuiMouseButton_Left);
    }
    return Progress::Done;
}

Result<ScriptPlayer::Progress> ScriptPlayer::assign(const ScriptStatement& statement,
                                                    std::vector<std::string> words) {
    if (attempts_ == 0) {
        const auto widget = registry_->find(statement.words[0].text);
        if (!widget) { return statement.errorAt(0, widget.error().message); }
        if (widget->kind == WidgetKind::Button || widget->kind == WidgetKind::Value ||
            widget->kind == WidgetKind::Area) {
            return statement.errorAt(
                0, fmt::format("\"{}\" has no value that can be set", statement.words[0].text));
        }
        registry_->assign(*widget, std::move(words));
        return Progress::Again;
    }
    const std::string failure = registry_->assignmentFailure();
    if (!failure.empty()) { return statement.errorAt(1, failure); }
    return Progress::Done;
}

void ScriptPlayer::runKey(const ScriptStatement& statement) {
    const int code = *keyCode(statement.words[0].text);
    const bool both = statement.words.size() == 1;
    if (both || statement.words[1].text == "down") {
        actions_.push_back({Action::Kind::KeyDown, {}, code, ""});
    }
    if (both || statement.words[1].text == "up") { actions_.push_back({Action::Kind::KeyUp, {}, code, ""}); }
}

/// Whether what the statement waits for is there, on screen or not.
bool ScriptPlayer::isThere(const ScriptStatement& statement) const {
    const std::string& what = statement.words[0].text;
    const RenderControl& render = workspace_->render;
    const SessionState state = render.status().state;
    if (what == "jobs") { return !workspace_->busy() && !workspace_->sceneFiles.opening(); }
    if (what == "paused") { return state == SessionState::Paused; }
    if (workspace_->awaitsEdit()) { return false; }
    if (what == "finished") { return state == SessionState::Finished; }
    if (what == "passes") {
        return render.snapshot() && render.snapshot()->passes >= static_cast<uint32_t>(statement.number(1));
    }
    return render.imageIsCurrent() && workspace_->carriesShownImage() && !workspace_->displayIsBehind;
}

/// What is waited for is seen once it has been there while kFramesToShow frames were drawn.
Result<ScriptPlayer::Progress> ScriptPlayer::runWait(const ScriptStatement& statement) {
    const std::string& what = statement.words[0].text;
    const SessionStatus& status = workspace_->render.status();
    const double waited = secondsNow() - began_;
    bool met = false;
    if (what == "frames") {
        met = attempts_ >= static_cast<int>(statement.number(1));
    } else if (what == "seconds") {
        met = waited >= static_cast<double>(statement.number(1));
    } else {
        shownFrames_ = isThere(statement) ? (attempts_ == 0 ? 0 : shownFrames_) + 1 : 0;
        met = shownFrames_ > kFramesToShow;
    }
    if (met) { return Progress::Done; }
    if (status.state == SessionState::Failed) {
        return statement.error(fmt::format("the render failed: {}", status.error));
    }
    const bool isOver =
        !workspace_->awaitsEdit() && status.state == SessionState::Finished && waited > kSettlingSeconds;
    const bool isShort = what == "passes" && status.passes < static_cast<uint32_t>(statement.number(1));
    if (isOver && (isShort || what == "paused")) {
        return statement.error(fmt::format("the render has finished, with {} passes", status.passes));
    }
    if (waited > kHangGuardSeconds) { return statement.error("waited in vain"); }
    return Progress::Again;
}

Result<ScriptPlayer::Progress> ScriptPlayer::run(const ScriptStatement& statement) {
    const std::string& verb = statement.verb;
    const auto wordCount = statement.words.size();
    if (verb == "click" || verb == "drag" || verb == "move") { return runPointer(statement); }
    if (verb == "wait") { return runWait(statement); }
    if (verb == "open" || verb == "close") { return assign(statement, {verb == "open" ? "open" : "closed"}); }
    if (verb == "set") {
        std::vector<std::string> words;
        for (size_t i = 1; i < wordCount; ++i) {
            words.push_back(statement.words[i].text);
        }
        return assign(statement, std::move(words));
    }
    if (verb == "expect") {
        const Status met = runExpect(statement);
        return met ? Result<Progress>(Progress::Done) : Result<Progress>(met.error());
    }
    if (verb == "screenshot") {
        const std::string& path = statement.words[0].text;
        const Status free = workspace_->inputs.checkIsNoInput(path);
        const Status saved = free ? screenshot_(path) : free;
        return saved ? Result<Progress>(Progress::Done)
                     : Result<Progress>(statement.errorAt(0, saved.error().format()));
    }
    if (verb == "press") { press(statement); }
    if (verb == "release") { actions_.push_back({Action::Kind::Release, {}, buttonOf(statement, 0), ""}); }
    if (verb == "wheel") {
        if (wordCount == 3) {
            actions_.push_back({Action::Kind::Move, {statement.number(1), statement.number(2)}, 0, ""});
        }
        actions_.push_back({Action::Kind::Wheel, {0.0f, statement.number(0)}, 0, ""});
    }
    if (verb == "key") { runKey(statement); }
    if (verb == "drop") { workspace_->takeDroppedFile(statement.words[0].text); }
    if (verb == "text") { actions_.push_back({Action::Kind::Text, {}, 0, statement.words[0].text}); }
    if (verb == "mark") { mark_ = workspace_->render.statusNow().counters; }
    if (verb == "print") { print(statement); }
    if (verb == "quit") { next_ = statements_.size() - 1; }
    return Progress::Done;
}

}  // namespace glint
