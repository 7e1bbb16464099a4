#include "engine/report/convergence_variant.h"

#include <algorithm>
#include <functional>
#include <optional>

#include <fmt/format.h>

#include "engine/base/nearest_name.h"
#include "engine/scene/field_text.h"
#include "engine/scene/text_settings.h"

namespace glint {
namespace {

struct VariantKey {
    std::string_view name;
    std::optional<IntegratorKind> only;  ///< the integrator whose setting it is; nothing: of all
    std::string expected;
    std::function<bool(std::string_view value, VariantSettings* settings)> set;
};

bool setThreads(std::string_view value, VariantSettings* s) {
    int64_t threads = 0;
    if (!parseWhole(value, {.lo = 1, .hi = 1024}, &threads)) { return false; }
    s->threads = static_cast<int>(threads);
    return true;
}
bool setBackend(std::string_view value, VariantSettings* s) {
    s->backend = value;
    return value == "cpu" || value == "cuda";
}
bool setKernel(std::string_view value, VariantSettings* s) {
    s->fullKernel = value == "full";
    return value == "full" || value == "specialised";
}
bool setDenoise(std::string_view value, VariantSettings* s) {
    s->denoise = value == "on";
    return value == "on" || value == "off";
}
/// The fields that are variants, and what a run has beside them.
const std::vector<VariantKey>& variantKeys() {
    static const std::vector<VariantKey> kKeys = [] {
        std::vector<VariantKey> keys;
        for (const TextSetting& setting : textSettings()) {
            if (setting.variant.empty()) { continue; }
            const std::string help = setting.isNumber ? ", " + setting.help : "";
            keys.push_back({setting.variant, setting.only, setting.expected + help,
                            [&setting](std::string_view value, VariantSettings* s) {
                                return setting.set(value, {.options = &s->options, .sppm = &s->sppm});
                            }});
        }
        keys.push_back({"threads", {}, "a whole number from 1 to 1024", setThreads});
        keys.push_back({"backend", {}, "cpu or cuda", setBackend});
        keys.push_back({"denoise", {}, "on or off, the picture with or without its noise", setDenoise});
        keys.push_back({"kernel", {}, "specialised or full", setKernel});
        return keys;
    }();
    return kKeys;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (size_t begin = 0; begin <= text.size();) {
        const size_t end = std::min(text.find(separator, begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

/// "a:b=c:d:e=f" as "a", "b=c:d", "e=f".
std::vector<std::string> pieces(std::string_view text) {
    std::vector<std::string> joined;
    for (const std::string_view part : split(text, ':')) {
        if (joined.size() < 2 || part.find('=') != std::string_view::npos) {
            joined.emplace_back(part);
        } else {
            joined.back() += fmt::format(":{}", part);
        }
    }
    return joined;
}

bool belongs(const VariantKey& key, IntegratorKind integrator) {
    return !key.only || *key.only == integrator;
}

const VariantKey* findKey(std::string_view name) {
    const auto found = std::ranges::find(variantKeys(), name, &VariantKey::name);
    return found == variantKeys().end() ? nullptr : &*found;
}

Error inVariant(std::string_view text, std::string problem) {
    return {fmt::format("--integrators: '{}': {}", text, problem), {}};
}

Error unknownKey(std::string_view text, std::string_view key, IntegratorKind integrator) {
    std::vector<std::string_view> known;
    for (const VariantKey& candidate : variantKeys()) {
        if (belongs(candidate, integrator)) { known.push_back(candidate.name); }
    }
    return inVariant(text, fmt::format("there is no setting '{}'{}; expected one of {}", key,
                                       didYouMean(key, known), fmt::join(known, ", ")));
}

Status addAssignment(std::string_view text, const std::string& piece, ConvergenceVariant* variant) {
    const size_t equals = piece.find('=');
    if (equals == std::string::npos || equals == 0) {
        return inVariant(text, fmt::format("'{}' is not a setting; expected key=value", piece));
    }
    const std::string name = piece.substr(0, equals), value = piece.substr(equals + 1);
    const VariantKey* key = findKey(name);
    if (key == nullptr) { return unknownKey(text, name, variant->integrator); }
    if (!belongs(*key, variant->integrator)) {
        const IntegratorInfo& owner = integratorInfo(*key->only);
        return inVariant(text, fmt::format("'{}' is a setting of {}; expected {}:{}", name, owner.displayName,
                                           owner.key, piece));
    }
    if (std::ranges::find(variant->assignments, name, [](const auto& a) { return a.first; }) !=
        variant->assignments.end()) {
        return inVariant(text, fmt::format("'{}' stands twice", name));
    }
    VariantSettings ignored;
    if (!key->set(value, &ignored)) {
        return inVariant(text, fmt::format("{} is '{}'; expected {}", name, value, key->expected));
    }
    variant->assignments.emplace_back(name, value);
    return {};
}

}  // namespace

VariantSettings ConvergenceVariant::applyTo(VariantSettings settings) const {
    settings.options.integrator = integrator;
    for (const auto& [key, value] : assignments) {
        (void)findKey(key)->set(value, &settings);
    }
    return settings;
}

Result<ConvergenceVariant> parseVariant(std::string_view text) {
    const std::vector<std::string> parts = pieces(text);
    const std::optional<IntegratorKind> integrator = integratorByName(inLowerCase(parts[0]));
    if (!integrator) {
        const std::vector<std::string_view> known = integratorNames();
        return inVariant(text, fmt::format("there is no integrator '{}'{}; expected one of {}", parts[0],
                                           didYouMean(parts[0], known), fmt::join(known, ", ")));
    }
    ConvergenceVariant variant;
    variant.integrator = *integrator;
    variant.name = variant.text = integratorInfo(*integrator).key;
    for (size_t i = 1; i < parts.size(); ++i) {
        if (const Status added = addAssignment(text, parts[i], &variant); !added) { return added.error(); }
        variant.name += " " + parts[i];
        variant.text += ":" + parts[i];
    }
    return variant;
}

Result<std::vector<ConvergenceVariant>> parseVariants(std::string_view list) {
    std::vector<ConvergenceVariant> variants;
    for (const std::string_view text : split(list, ',')) {
        if (text.empty()) {
            return Error{fmt::format("--integrators is '{}'; expected names such as path,sppm", list), {}};
        }
        Result<ConvergenceVariant> variant = parseVariant(text);
        if (!variant) { return variant.error(); }
        if (std::ranges::find(variants, variant->text, &ConvergenceVariant::text) != variants.end()) {
            return inVariant(text, "it is there twice; expected each once");
        }
        variants.push_back(std::move(*variant));
    }
    return variants;
}

std::string variantHelp() {
    std::string help;
    for (const VariantKey& key : variantKeys()) {
        help += fmt::format("  {:<9} {:<5} {}\n", key.name, key.only ? integratorInfo(*key.only).key : "",
                            key.expected);
    }
    return help;
}

}  // namespace glint
