#include "viewer/panels/compare_view.h"

#include "viewer/ui/widgets.h"

namespace glint {

void drawCompareView(DisplaySettings* display) {
    static constexpr ui::KindLabel<CompareView> kViews[]{{CompareView::Wipe, "Wipe"},
                                                         {CompareView::Flip, "Flip"},
                                                         {CompareView::SideBySide, "Side by side"},
                                                         {CompareView::SignedDifference, "Signed difference"},
                                                         {CompareView::FlipMap, "FLIP map"}};
    ui::kindChoice("Compared by", &display->compareView, kViews,
                   "Wipe: a divider. Flip: one after the other (X). Signed difference: orange where the left "
                   "one is brighter, blue where the right one is. FLIP: what the eye sees of it (N: next)");
}

}  // namespace glint
