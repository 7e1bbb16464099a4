#include "viewer/model/display_settings.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace glint {

std::string editName(const DisplayChoices& before, const DisplayChoices& after) {
    const struct {
        const char* name;
        bool differs;
    } all[] = {{"exposure", before.exposureStops != after.exposureStops},
               {"tone map", before.toneMap != after.toneMap},
               {"OpenColorIO view", before.view != after.view},
               {"white", before.white.kelvin != after.white.kelvin},
               {"tint", before.white.tint != after.white.tint},
               {"dither", before.dithers != after.dithers},
               {"denoise", before.denoises != after.denoises},
               {infoOf(after.shown).name, before.shown != after.shown}};
    const auto differs = [](const auto& each) { return each.differs; };
    const auto more = std::ranges::count_if(all, differs) - 1;
    const auto first = std::ranges::find_if(all, differs);
    if (first == std::end(all)) { return "Display"; }
    return fmt::format("Display: {}{}", first->name, more > 0 ? fmt::format(" and {} more", more) : "");
}

void DisplaySettings::take(const DisplayLook& look) {
    exposureStops = look.exposureStops;
    toneMap = look.toneMap;
    white = look.white;
    dithers = look.dithers;
    view = look.view;
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

bool DisplaySettings::shows(IntegratorKind kind, IntegratorKind own) const {
    return kind == own || (split && kind == otherOf(own));
}

}  // namespace glint
