#include "viewer/ui/eyedropper.h"

#include <utility>

namespace glint::ui {
namespace {

struct Waiting {
    ImGuiID field = 0;  ///< 0: none
    std::optional<Vec3> given{};
};
Waiting waiting;

}  // namespace

void waitForColor(ImGuiID field) { waiting = {.field = field}; }

bool waitsForColor() { return waiting.field != 0 && !waiting.given; }

void stopWaitingForColor() { waiting = {}; }

void giveColor(const Vec3& linear) { waiting.given = linear; }

std::optional<Vec3> takeGivenColor(ImGuiID field) {
    if (waiting.field != field || !waiting.given) { return std::nullopt; }
    return std::exchange(waiting, {}).given;
}

}  // namespace glint::ui
