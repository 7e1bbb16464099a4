#include "viewer/panels/compare_view.h"

#include "viewer/ui/widgets.h"

namespace glint {

void drawCompareView(DisplaySettings* display, const KeyMap& keys) {
    static constexpr ui::KindLabel<CompareView> kViews[]{{CompareView::Wipe, "Wipe"},
                                                         {CompareView::Flip, "Flip"},
                                                         {CompareView::SideBySide, "Side by side"},
                                                         {CompareView::SignedDifference, "Signed difference"},
                                                         {CompareView::FlipMap, "FLIP map"}};
    const std::string tip =
        keys.tip("Wipe: a divider. Flip: one after the other", KeyAction::Flip) +
        keys.tip(
            ". Signed difference: orange where the left one is brighter, blue where the right one is. "
            "FLIP: what the eye sees of it. The next one",
            KeyAction::NextCompareView);
    ui::kindChoice("Compared by", &display->compareView, kViews, tip.c_str());
}

}  // namespace glint
