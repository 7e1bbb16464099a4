#include "viewer/model/display_settings.h"

#include <algorithm>

namespace glint {

void DisplaySettings::take(const DisplayLook& look) {
    exposureStops = look.exposureStops;
    toneMap = look.toneMap;
    white = look.white;
    dithers = look.dithers;
}

IntegratorKind DisplaySettings::otherOf(IntegratorKind own) const {
    if (comparedWith && *comparedWith != own) { return *comparedWith; }
    const auto isOther = [own](const IntegratorInfo& info) { return info.kind != own; };
    return std::ranges::find_if(kIntegratorTable, isOther)->kind;
}

ComparedPair DisplaySettings::pairOf(IntegratorKind own) const {
    const IntegratorKind other = otherOf(own);
    return {std::min(own, other), std::max(own, other)};
}

}  // namespace glint
