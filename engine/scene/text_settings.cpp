#include "engine/scene/text_settings.h"

#include "engine/scene/field_text.h"
#include "engine/scene/scene_fields.h"

namespace glint {
namespace {

Camera* targetOf(const SettingTargets& targets, const Camera*) { return targets.camera; }
RenderOptions* targetOf(const SettingTargets& targets, const RenderOptions*) { return targets.options; }
SppmOptions* targetOf(const SettingTargets& targets, const SppmOptions*) { return targets.sppm; }
RayCastOptions* targetOf(const SettingTargets& targets, const RayCastOptions*) { return targets.rayCast; }

/// Metres, "auto", or "auto:K".
bool setRadius(std::string_view text, const SettingTargets& targets) {
    constexpr std::string_view kAuto = "auto", kAutoOf = "auto:";
    SppmOptions radii = *targets.sppm;
    const bool isAuto = text == kAuto || text.starts_with(kAutoOf);
    if (isAuto) { radii.radiusWorld = 0.0f; }
    const std::string_view number = isAuto ? text.substr(std::min(kAutoOf.size(), text.size())) : text;
    const NumberRange range{.lo = 0.0, .hi = isAuto ? kFootprintRange.hi : kRadiusRange.hi, .openLo = true};
    float* radius = isAuto ? &radii.radiusFootprints : &radii.radiusWorld;
    if (text != kAuto && !parseNumber(number, range, radius)) { return false; }
    *targets.sppm = radii;
    return true;
}

template <class Member>
std::vector<std::string_view> wordsOf() {
    if constexpr (std::is_enum_v<Member>) { return namesOf<Member>(); }
    return {};
}

template <class Owner>
void addSettings(std::optional<IntegratorKind> only, std::vector<TextSetting>* settings) {
    forEachField<Owner>([&]<class Member>(const Field<Owner, Member>& field) {
        const FieldTraits& traits = field.traits;
        if (traits.option.empty() && traits.variant.empty()) { return; }
        settings->push_back({.option = traits.option,
                             .variant = traits.variant,
                             .help = describeField(traits, false),
                             .expected = expectedText(field),
                             .words = wordsOf<Member>(),
                             .isNumber = std::is_arithmetic_v<Member> && !std::is_same_v<Member, bool>,
                             .isVector = std::is_same_v<Member, Vec3>,
                             .only = only,
                             .set = [field](std::string_view text, const SettingTargets& targets) {
                                 Owner* target = targetOf(targets, static_cast<Owner*>(nullptr));
                                 return target != nullptr && setFromText(field, text, target);
                             }});
    });
}

}  // namespace

std::span<const TextSetting> textSettings() {
    static const std::vector<TextSetting> kSettings = [] {
        std::vector<TextSetting> settings;
        addSettings<Camera>({}, &settings);
        addSettings<RenderOptions>({}, &settings);
        forEachIntegratorOptions([&](IntegratorKind kind, auto member) {
            using Options = std::remove_cvref_t<decltype(std::declval<SceneDescription>().*member)>;
            addSettings<Options>(kind, &settings);
        });
        settings.push_back(
            {.option = "--radius",
             .variant = "radius",
             .help = "first radius",
             .expected = "metres such as 0.05, auto, or auto:K such as auto:4 for pixel footprints",
             .only = IntegratorKind::Sppm,
             .set = setRadius});
        return settings;
    }();
    return kSettings;
}

}  // namespace glint
