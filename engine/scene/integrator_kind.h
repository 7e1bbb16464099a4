// The integrators that there are: one line each, and everything that names, lists or makes them follows.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace glint {

/// X(enumerator, key, alias, display name, help). The key is the name in scene files, reports and on the
/// command line; the alias is understood wherever a key is, and in capitals labels what has little room. The
/// display name is for people, the help for those who read the key. render/integrator.h says what else an
/// integrator is made of.
// clang-format off
#define GLINT_INTEGRATORS(X) \
    X(PathTracing, "path", "pt", "Path tracing", "path tracing") \
    X(Sppm, "sppm", "sppm", "SPPM", "progressive photon mapping") \
    X(AmbientOcclusion, "ao", "ao", "Ambient occlusion", "ambient occlusion") \
    X(RayCast, "raycast", "rc", "Ray casting", "Phong's model without bounces")
// clang-format on

enum class IntegratorKind : uint8_t {
#define GLINT_ENUMERATOR(kind, key, alias, displayName, help) kind,
    GLINT_INTEGRATORS(GLINT_ENUMERATOR)
#undef GLINT_ENUMERATOR
};

struct IntegratorInfo {
    IntegratorKind kind;
    const char* key;
    const char* alias;
    const char* displayName;
};

/// In the order of IntegratorKind.
inline constexpr auto kIntegratorTable = std::to_array<IntegratorInfo>({
#define GLINT_INTEGRATOR_INFO(kind, key, alias, displayName, help) \
    {IntegratorKind::kind, key, alias, displayName},
    GLINT_INTEGRATORS(GLINT_INTEGRATOR_INFO)
#undef GLINT_INTEGRATOR_INFO
});

constexpr const IntegratorInfo& integratorInfo(IntegratorKind kind) {
    return kIntegratorTable[static_cast<size_t>(kind)];
}

/// Every key and alias, each once.
inline std::vector<std::string_view> integratorNames() {
    std::vector<std::string_view> names;
    for (const IntegratorInfo& info : kIntegratorTable) {
        names.emplace_back(info.alias);
        if (names.back() != info.key) { names.emplace_back(info.key); }
    }
    return names;
}

/// By key or alias; nothing for any other text.
constexpr std::optional<IntegratorKind> integratorByName(std::string_view name) {
    for (const IntegratorInfo& info : kIntegratorTable) {
        if (name == info.key || name == info.alias) { return info.kind; }
    }
    return std::nullopt;
}

}  // namespace glint
