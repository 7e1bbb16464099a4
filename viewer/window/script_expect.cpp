// What a script can ask and expect: counters since the mark, states, widgets' values, messages.
#include <array>
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>

#include "engine/base/console.h"
#include "viewer/window/frame_stats.h"
#include "viewer/window/script_player.h"

namespace glint {
namespace {

struct NamedCounter {
    std::string_view name;
    uint64_t SessionCounters::*member;
};

constexpr std::array<NamedCounter, 8> kCounters{{
    {"restarts", &SessionCounters::filmRestarts},
    {"allocations", &SessionCounters::filmAllocations},
    {"material-tables", &SessionCounters::materialTables},
    {"texture-tables", &SessionCounters::textureTables},
    {"light-tables", &SessionCounters::lightTables},
    {"feature-scans", &SessionCounters::featureScans},
    {"mesh-builds", &SessionCounters::meshBuilds},
    {"top-level-builds", &SessionCounters::topLevelBuilds},
}};

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Numbers are equal when they round alike in float; anything else word by word.
bool sameValue(const std::string& have, const std::string& want) {
    char* haveEnd = nullptr;
    char* wantEnd = nullptr;
    const float a = std::strtof(have.c_str(), &haveEnd);
    const float b = std::strtof(want.c_str(), &wantEnd);
    const bool numbers = !have.empty() && !want.empty() && *haveEnd == '\0' && *wantEnd == '\0';
    return numbers ? std::abs(a - b) <= 1e-5f * std::abs(b) : have == want;
}

}  // namespace

Status ScriptPlayer::expectWidget(const ScriptStatement& statement) {
    const auto widget = registry_->find(statement.words[0].text);
    if (!widget) { return statement.errorAt(0, widget.error().message); }
    std::string want;
    for (size_t i = 1; i < statement.words.size(); ++i) {
        want += (i > 1 ? " " : "") + statement.words[i].text;
    }
    if (sameValue(widget->value, want)) { return {}; }
    return statement.errorAt(
        1, fmt::format("\"{}\" is \"{}\"; expected \"{}\"", statement.words[0].text, widget->value, want));
}

Status ScriptPlayer::runExpect(const ScriptStatement& statement) {
    if (statement.words[0].quoted) { return expectWidget(statement); }
    const std::string& what = statement.words[0].text;
    const SessionStatus status = workspace_->render.statusNow();
    const std::string argument = statement.words.size() > 1 ? statement.words[1].text : "";
    const auto unless = [&](bool met, const std::string& message) {
        return met ? Status() : Status(statement.errorAt(statement.words.size() > 1 ? 1 : 0, message));
    };
    for (const NamedCounter& counter : kCounters) {
        if (counter.name != what) { continue; }
        const uint64_t since = status.counters.*counter.member - mark_.*counter.member;
        return unless(static_cast<float>(since) == statement.number(1),
                      fmt::format("{} since the mark: {}; expected {}", what, since, argument));
    }
    if (what == "state") {
        return unless(argument == stateName(status.state),
                      fmt::format("the state is {}; expected {}", stateName(status.state), argument));
    }
    if (what == "passes-at-least") {
        return unless(static_cast<float>(status.passes) >= statement.number(1),
                      fmt::format("{} passes so far", status.passes));
    }
    if (what == "widget") { return unless(registry_->find(argument).ok(), "it is not on screen"); }
    if (what == "no-widget") { return unless(!registry_->find(argument).ok(), "it is on screen"); }
    if (what == "message") {
        return unless(contains(workspace_->notice.text(), argument),
                      fmt::format("the message is \"{}\"", workspace_->notice.text()));
    }
    const std::string error = workspace_->sceneFiles.error() ? workspace_->sceneFiles.error()->format() : "";
    if (what == "no-error") { return unless(error.empty(), error); }
    if (what == "error") {
        return unless(!error.empty() && contains(error, argument), fmt::format("the error is \"{}\"", error));
    }
    return expectWidget(statement);
}

void ScriptPlayer::print(const ScriptStatement& statement) const {
    const std::string& what = statement.words[0].text;
    if (!statement.words[0].quoted && what == "status") {
        const SessionStatus status = workspace_->render.statusNow();
        put("state={} integrator={} passes={} seconds={:.3f}", stateName(status.state),
            integratorInfo(status.integrator).key, status.passes, status.renderSeconds);
        for (const NamedCounter& counter : kCounters) {
            put(" {}={}", counter.name, status.counters.*counter.member - mark_.*counter.member);
        }
        put("\n");
    } else if (!statement.words[0].quoted && what == "widgets") {
        for (const WidgetRecord& widget : registry_->widgets()) {
            const Vec2 size = widget.max - widget.min;
            put("\"{}\" {:.0f} {:.0f} {:.0f} {:.0f} {}\n", widget.fullName(), widget.min.x, widget.min.y,
                size.x, size.y, widget.value);
        }
    } else if (const auto widget = registry_->find(what)) {
        put("\"{}\" {}\n", widget->fullName(), widget->value);
    } else {
        put("{}\n", widget.error().message);
    }
    std::fflush(stdout);
}

}  // namespace glint
