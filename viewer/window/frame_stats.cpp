#include "viewer/window/frame_stats.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace glint {
namespace {

nlohmann::ordered_json percentiles(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
        return values.empty() ? 0.0
                              : values[static_cast<size_t>(share * static_cast<double>(values.size() - 1))];
    };
    return {{"p50", at(0.5)}, {"p95", at(0.95)}, {"p99", at(0.99)}, {"max", at(1.0)}};
}

nlohmann::ordered_json numbers(const Vec3& v) { return nlohmann::ordered_json::array({v.x, v.y, v.z}); }

nlohmann::ordered_json sessionReport(const SessionStatus& session) {
    return {{"state", stateName(session.state)},
            {"integrator", integratorInfo(session.integrator).key},
            {"passes", session.passes},
            {"restarts", session.counters.filmRestarts},
            {"preview_passes", session.counters.previewPasses},
            {"last_edit_ms", session.lastEditToImageSeconds * 1000.0},
            {"last_cancel_ms", session.lastCancelSeconds * 1000.0}};
}

}  // namespace

const char* stateName(SessionState state) {
    switch (state) {
        case SessionState::Empty:
            return "empty";
        case SessionState::Building:
            return "building";
        case SessionState::Rendering:
            return "rendering";
        case SessionState::Paused:
            return "paused";
        case SessionState::Finished:
            return "finished";
        case SessionState::Failed:
            return "failed";
    }
    return "";
}

std::vector<double> FrameStats::uiSeconds() const {
    std::vector<double> seconds;
    for (const FrameTimes& frame : frames_) {
        seconds.push_back(frame.uiMs / 1000.0);
    }
    return seconds;
}

std::string FrameStats::json(const SessionStatus& session, const Camera& camera) const {
    const auto collect = [this](auto&& part) {
        std::vector<double> values;
        for (const FrameTimes& frame : frames_) {
            values.push_back(part(frame));
        }
        return values;
    };
    const std::vector<double> own =
        collect([](const FrameTimes& f) { return f.uiMs + f.uploadMs + f.wakeMs; });
    nlohmann::ordered_json report;
    report["report"] = "view";
    report["frames"] = frames_.size();
    report["ui_ms"] = percentiles(collect([](const FrameTimes& f) { return f.uiMs; }));
    report["upload_ms"] = percentiles(collect([](const FrameTimes& f) { return f.uploadMs; }));
    report["draw_ms"] = percentiles(collect([](const FrameTimes& f) { return f.drawMs; }));
    report["wake_ms"] = percentiles(collect([](const FrameTimes& f) { return f.wakeMs; }));
    report["frame_ms_without_drawing"] = percentiles(own);
    report["over_60hz_without_drawing"] =
        std::count_if(own.begin(), own.end(), [](double ms) { return ms > 1000.0 / 60.0; });
    report["session"] = sessionReport(session);
    report["camera"] = {{"position", numbers(camera.position)}, {"target", numbers(camera.target)}};
    return report.dump(2) + "\n";
}

}  // namespace glint
