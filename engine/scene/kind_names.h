// The words for kinds of things in scene files, on the command line and in fingerprints: one table for
// each enumeration.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/base/kinds.h"
#include "engine/scene/render_options.h"

namespace glint {

template <class Kind>
struct KindName {
    std::string_view name;
    Kind kind;
    std::string_view help = {};  ///< for the schema: a sentence, or nothing
};

/// The table of an enumeration, in the order in which messages list it. Tables exist for those below.
template <class Kind>
std::span<const KindName<Kind>> kindNames();

template <>
std::span<const KindName<ShapeKind>> kindNames<ShapeKind>();
template <>
std::span<const KindName<ProjectionKind>> kindNames<ProjectionKind>();
template <>
std::span<const KindName<CurveKind>> kindNames<CurveKind>();
template <>
std::span<const KindName<MaterialKind>> kindNames<MaterialKind>();
template <>
std::span<const KindName<FacetDistribution>> kindNames<FacetDistribution>();
template <>
std::span<const KindName<WardForm>> kindNames<WardForm>();
template <>
std::span<const KindName<LightKind>> kindNames<LightKind>();
template <>
std::span<const KindName<ColorEncoding>> kindNames<ColorEncoding>();
template <>
std::span<const KindName<WrapMode>> kindNames<WrapMode>();
template <>
std::span<const KindName<TexelFilter>> kindNames<TexelFilter>();
template <>
std::span<const KindName<TextureChannel>> kindNames<TextureChannel>();
template <>
std::span<const KindName<IntegratorKind>> kindNames<IntegratorKind>();
template <>
std::span<const KindName<FilterKind>> kindNames<FilterKind>();
template <>
std::span<const KindName<SamplerKind>> kindNames<SamplerKind>();
template <>
std::span<const KindName<AcceleratorKind>> kindNames<AcceleratorKind>();
template <>
std::span<const KindName<PhotonLookupKind>> kindNames<PhotonLookupKind>();

template <class Kind>
std::string_view nameOf(Kind kind) {
    for (const KindName<Kind>& entry : kindNames<Kind>()) {
        if (entry.kind == kind) { return entry.name; }
    }
    return {};
}

template <class Kind>
std::optional<Kind> kindNamed(std::string_view name) {
    for (const KindName<Kind>& entry : kindNames<Kind>()) {
        if (entry.name == name) { return entry.kind; }
    }
    return std::nullopt;
}

template <class Kind>
std::vector<std::string_view> namesOf() {
    std::vector<std::string_view> names;
    for (const KindName<Kind>& entry : kindNames<Kind>()) {
        names.push_back(entry.name);
    }
    return names;
}

}  // namespace glint
