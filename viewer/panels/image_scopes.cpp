#include "viewer/panels/image_scopes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/base/units.h"
#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

constexpr float kHistogramUnits = 72.0f;
constexpr float kWaveformUnits = 120.0f;

struct ScopeArea {
    ImVec2 corner, size;
};
ScopeArea beginScope(float heightUnits) {
    const ScopeArea area{ImGui::GetCursorScreenPos(),
                         {ImGui::GetContentRegionAvail().x, heightUnits * ui::scale()}};
    ImGui::Dummy(area.size);
    ImGui::GetWindowDrawList()->AddRectFilled(area.corner,
                                              {area.corner.x + area.size.x, area.corner.y + area.size.y},
                                              ImGui::GetColorU32(theme::kImageBackground), 4.0f);
    return area;
}

/// Roots, so that little is seen too.
void drawHistogram(const Histogram& histogram) {
    const auto [corner, size] = beginScope(kHistogramUnits);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    constexpr std::array<ImU32, 3> kColors{IM_COL32(240, 90, 80, 110), IM_COL32(90, 210, 90, 110),
                                           IM_COL32(90, 130, 255, 110)};
    float most = 0.0f;
    for (const auto& channel : histogram.bins) {
        most = std::max(most, *std::ranges::max_element(channel));
    }
    const float step = size.x / static_cast<float>(Histogram::kBins);
    for (size_t c = 0; c < histogram.bins.size(); ++c) {
        for (size_t i = 0; i < Histogram::kBins; ++i) {
            const float share = most > 0.0f ? std::sqrt(histogram.bins[c][i] / most) : 0.0f;
            const float x = corner.x + step * static_cast<float>(i);
            draw->AddRectFilled({x, corner.y + size.y * (1.0f - share)}, {x + step, corner.y + size.y},
                                kColors[c]);
        }
    }
    const std::string clipped =
        fmt::format("{} black, {} white", percent(static_cast<double>(histogram.black)),
                    percent(static_cast<double>(histogram.white)));
    ui::itemArea("Histogram", clipped);
    ui::value("Clipped", clipped, "Black in all channels, white in any");
}

/// What a pane reaches, in percent of white: "5–80 %".
std::string rangeOf(const Waveform& waveform, size_t pane) {
    size_t low = Waveform::kLevels;
    size_t high = 0;
    for (size_t column = 0; column < waveform.columnsPerPane; ++column) {
        for (size_t level = 0; level < Waveform::kLevels; ++level) {
            if (waveform.share(pane, column, level) == 0.0f) { continue; }
            low = std::min(low, level);
            high = std::max(high, level);
        }
    }
    const auto percentOf = [](size_t level) { return 100 * level / (Waveform::kLevels - 1); };
    return fmt::format("{}–{} %", percentOf(std::min(low, high)), percentOf(high));
}

/// Brighter where more pixels are; roots, so that few are seen too.
void drawWaveform(const Waveform& waveform) {
    constexpr std::array<std::array<int, 3>, 4> kColors{
        {{215, 215, 215}, {255, 90, 80}, {90, 230, 90}, {100, 140, 255}}};
    const auto [corner, size] = beginScope(kWaveformUnits);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    for (int quarter = 1; quarter < 4; ++quarter) {
        const float y = corner.y + size.y * static_cast<float>(quarter) * 0.25f;
        draw->AddLine({corner.x, y}, {corner.x + size.x, y}, IM_COL32(255, 255, 255, 28));
    }
    const size_t columns = waveform.panes * waveform.columnsPerPane;
    const float width = size.x / static_cast<float>(std::max(columns, size_t{1}));
    const float height = size.y / static_cast<float>(Waveform::kLevels);
    std::string ranges;
    for (size_t pane = 0; pane < waveform.panes; ++pane) {
        const auto& color = kColors[waveform.panes == 1 ? 0 : pane + 1];
        for (size_t column = 0; column < waveform.columnsPerPane; ++column) {
            const float x = corner.x + width * static_cast<float>(pane * waveform.columnsPerPane + column);
            for (size_t level = 0; level < Waveform::kLevels; ++level) {
                const float share = waveform.share(pane, column, level);
                if (share == 0.0f) { continue; }
                const int alpha = std::min(255, 40 + static_cast<int>(430.0f * std::sqrt(share)));
                const float y = corner.y + size.y - height * static_cast<float>(level + 1);
                draw->AddRectFilled({x, y}, {x + width, y + height},
                                    IM_COL32(color[0], color[1], color[2], alpha));
            }
        }
        ranges += (pane > 0 ? ", " : "") + rangeOf(waveform, pane);
    }
    ui::itemArea("Waveform", ranges);
    ui::value("Reaches", ranges, "The darkest and the lightest of each pane, of white");
}

}  // namespace

void drawScopes(const std::shared_ptr<const FilmSnapshot>& snapshot, const DisplayLook& look,
                Inspector* inspector) {
    static constexpr ui::KindLabel<ScopeKind> kScopes[]{{ScopeKind::Histogram, "Histogram"},
                                                        {ScopeKind::Luminance, "Waveform"},
                                                        {ScopeKind::Parade, "Parade"}};
    ui::kindChoice("Scope", &inspector->scope, kScopes,
                   "How often each value is there; or the values from the picture's left to its right, as "
                   "luminance, or as red, green and blue beside each other");
    const Inspector::ScopeOf now{snapshot, look, inspector->scope};
    const bool isNew = !(now == inspector->scopeOf);
    inspector->scopeOf = now;
    if (inspector->scope == ScopeKind::Histogram) {
        if (isNew) { inspector->histogram = histogramOf(*snapshot, look); }
        return drawHistogram(inspector->histogram);
    }
    const auto kind = inspector->scope == ScopeKind::Parade ? WaveformKind::Parade : WaveformKind::Luminance;
    if (isNew) { inspector->waveform = waveformOf(*snapshot, look, kind); }
    drawWaveform(inspector->waveform);
}

}  // namespace glint
