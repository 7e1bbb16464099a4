// Plays a script: turns statements into input, one step a frame, and checks what they expect.
//
// The viewer behaves as with a person's input: the player only writes ImGuiIO, and sets widgets through
// the registry.
#pragma once

#include <deque>
#include <functional>
#include <vector>

#include "engine/base/result.h"
#include "viewer/model/workspace.h"
#include "viewer/ui/widget_registry.h"
#include "viewer/window/script.h"

struct ImGuiIO;

namespace glint {

class ScriptPlayer {
  public:
    using Screenshot = std::function<Status(const std::string& path)>;

    ScriptPlayer(std::vector<ScriptStatement> statements, WidgetRegistry* registry, Workspace* workspace,
                 Screenshot screenshot);

    /// Before a frame: runs statements until one needs a frame to pass. Error: an expectation failed, or a
    /// widget is missing; the script is over then.
    Status step();
    bool done() const { return next_ == statements_.size() && actions_.empty() && !finishing_; }
    /// The last step() was input, or set a widget.
    bool hasActed() const { return hasActed_; }
    /// Overwrites the frame's input with the script's.
    void feed(ImGuiIO* io);

  private:
    struct Action {
        enum class Kind { Move, Press, PressAt, Release, KeyDown, KeyUp, Wheel, Text } kind;
        Vec2 at{0.0f};
        int code = 0;
        std::string text;
    };
    enum class Progress { Done, Again };

    Result<Progress> run(const ScriptStatement& statement);
    Result<Progress> runPointer(const ScriptStatement& statement);
    bool isThere(const ScriptStatement& statement) const;
    Result<Progress> runWait(const ScriptStatement& statement);
    Status runExpect(const ScriptStatement& statement);
    Status expectWidget(const ScriptStatement& statement);
    Result<Progress> assign(const ScriptStatement& statement, std::vector<std::string> words);
    void runKey(const ScriptStatement& statement);
    void print(const ScriptStatement& statement) const;
    /// The widget when it can be clicked; nothing while it is being scrolled into view.
    Result<std::optional<WidgetRecord>> reachable(const ScriptStatement& statement);
    void press(const ScriptStatement& statement);
    void click(Vec2 at, int button);
    void drag(Vec2 from, Vec2 to, int button);

    std::vector<ScriptStatement> statements_;
    WidgetRegistry* registry_;
    Workspace* workspace_;
    Screenshot screenshot_;
    size_t next_ = 0;
    int attempts_ = 0;     // frames that the current statement has taken
    int shownFrames_ = 0;  // those in a row, up to now, in which what it waits for was there
    double began_ = 0.0;   // when it began, seconds
    bool hasActed_ = false;
    bool finishing_ = false;  // the last action's frame has not been drawn
    std::deque<Action> actions_;
    SessionCounters mark_{};

    Vec2 mouse_{-1.0f, -1.0f};
    bool buttons_[3] = {};
    bool keys_[512] = {};
    float wheel_ = 0.0f;
    std::string typed_;
};

}  // namespace glint
