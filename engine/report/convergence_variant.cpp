// A key is a line of kKeys: its name, whose it is, what it expects, and how it is set.
#include "engine/report/convergence_variant.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "engine/base/nearest_name.h"

namespace glint {
namespace {

struct VariantKey {
    std::string_view name;
    std::optional<IntegratorKind> only;  ///< the integrator whose setting it is; nothing: of all
    std::string_view expected;
    bool (*set)(std::string_view value, VariantSettings* settings);
};

template <class T>
std::optional<T> numberIn(std::string_view text, T least, T most) {
    T value{};
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = problem == std::errc() && end == text.data() + text.size();
    if (!whole || !(value >= least && value <= most)) { return std::nullopt; }
    return value;
}

template <class T, class U>
bool store(const std::optional<T>& value, U* target) {
    if (value) { *target = *value; }
    return value.has_value();
}

template <class T>
bool choose(std::string_view value, std::string_view first, T firstMeans, std::string_view second,
            T secondMeans, T* target) {
    if (value != first && value != second) { return false; }
    *target = value == first ? firstMeans : secondMeans;
    return true;
}

bool setSampler(std::string_view value, VariantSettings* s) {
    return choose(value, "sobol", SamplerKind::Sobol, "independent", SamplerKind::Independent,
                  &s->options.sampler);
}
bool setRoulette(std::string_view value, VariantSettings* s) {
    return store(numberIn(value, 0, 1 << 20), &s->options.rouletteStartDepth);
}
bool setClamp(std::string_view value, VariantSettings* s) {
    return store(numberIn(value, 0.0f, 1e30f), &s->options.fireflyClamp);
}
bool setThreads(std::string_view value, VariantSettings* s) {
    return store(numberIn(value, 1, 1024), &s->threads);
}
bool setBackend(std::string_view value, VariantSettings* s) {
    s->backend = value;
    return value == "cpu" || value == "cuda";
}
bool setKernel(std::string_view value, VariantSettings* s) {
    return choose(value, "full", true, "specialised", false, &s->fullKernel);
}
bool setRadius(std::string_view value, VariantSettings* s) {
    if (value == "auto" || value.starts_with("auto:")) {
        s->sppm.radiusWorld = 0.0f;
        return value == "auto" || store(numberIn(value.substr(5), 1e-6f, 1e6f), &s->sppm.radiusFootprints);
    }
    return store(numberIn(value, 1e-30f, 1e30f), &s->sppm.radiusWorld);
}
bool setAlpha(std::string_view value, VariantSettings* s) {
    return store(numberIn(value, 1e-4f, 0.9999f), &s->sppm.alpha);
}
bool setPhotons(std::string_view value, VariantSettings* s) {
    return store(numberIn(value, 1u, 1u << 30), &s->sppm.photonsPerPass);
}
bool setLookup(std::string_view value, VariantSettings* s) {
    return choose(value, "grid", PhotonLookupKind::Grid, "tree", PhotonLookupKind::Tree, &s->sppm.lookup);
}
bool setDirect(std::string_view value, VariantSettings* s) {
    return choose(value, "sampled", true, "photons", false, &s->sppm.sampleDirectLight);
}

constexpr std::array kKeys = {
    VariantKey{"sampler", {}, "sobol or independent", setSampler},
    VariantKey{"roulette", {}, "the scattering event Russian roulette starts at, such as 4", setRoulette},
    VariantKey{"clamp", {}, "the most radiance a sample may bring, such as 10; 0: off", setClamp},
    VariantKey{"threads", {}, "a whole number from 1 to 1024", setThreads},
    VariantKey{"backend", {}, "cpu or cuda", setBackend},
    VariantKey{"kernel", {}, "specialised or full", setKernel},
    VariantKey{"radius", IntegratorKind::Sppm,
               "metres such as 0.05, auto, or auto:K such as auto:2 pixel footprints", setRadius},
    VariantKey{"alpha", IntegratorKind::Sppm, "a number between 0 and 1, such as 0.67", setAlpha},
    VariantKey{"photons", IntegratorKind::Sppm, "photons in a pass, such as 100000", setPhotons},
    VariantKey{"lookup", IntegratorKind::Sppm, "grid or tree", setLookup},
    VariantKey{"direct", IntegratorKind::Sppm, "sampled or photons", setDirect},
};

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
    const auto* found = std::ranges::find(kKeys, name, &VariantKey::name);
    return found == kKeys.end() ? nullptr : found;
}

Error inVariant(std::string_view text, std::string problem) {
    return {fmt::format("--integrators: '{}': {}", text, problem), {}};
}

Error unknownKey(std::string_view text, std::string_view key, IntegratorKind integrator) {
    std::vector<std::string_view> known;
    for (const VariantKey& candidate : kKeys) {
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
                                           owner.shortName, piece));
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
    const std::optional<IntegratorKind> integrator = integratorByName(parts[0]);
    if (!integrator) {
        const std::vector<std::string_view> known = integratorNames();
        return inVariant(text, fmt::format("there is no integrator '{}'{}; expected one of {}", parts[0],
                                           didYouMean(parts[0], known), fmt::join(known, ", ")));
    }
    ConvergenceVariant variant;
    variant.integrator = *integrator;
    variant.name = variant.text = integratorInfo(*integrator).shortName;
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
            return Error{fmt::format("--integrators is '{}'; expected names such as pt,sppm", list), {}};
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
    for (const VariantKey& key : kKeys) {
        help += fmt::format("  {:<9} {:<5} {}\n", key.name,
                            key.only ? integratorInfo(*key.only).shortName : "", key.expected);
    }
    return help;
}

}  // namespace glint
