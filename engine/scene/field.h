// What one field of a scene type is: its key in files, its unit and range, what an edit of it invalidates,
// and whether the picture depends on it.
//
// scene_fields.h lists the fields of every type. Equality, fingerprints, scene files, their schema and the
// command line's options follow from those lists by forEachField().
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/base/number_range.h"
#include "engine/scene/scene_edit.h"

namespace glint {

/// What three numbers of a field are.
enum class VectorForm : uint8_t {
    Point,
    Direction,  ///< of any length but zero
    Color,      ///< also a grey level or "#rrggbb"; so are all ColorInputs
};

/// Texts are in lower case without a full stop.
struct FieldTraits {
    NumberRange range = {};
    VectorForm form = VectorForm::Point;
    bool isColor = false;  ///< of inputs: images that stand for it are coded as colours are, by sRGB
    std::string_view unit = {};
    std::string_view help = {};
    std::optional<EditKind> edit = {};  ///< the list's own where it is left out
    bool inFingerprint = true;          ///< the fingerprint has it
    uint32_t kinds = ~0u;               ///< the kinds of the owner that have the key, see only()
    bool required = false;              ///< a file must give it
    bool onlyOwnKinds = false;          ///< fingerprints of other kinds leave it out
    bool onlyIfSet = false;             ///< fingerprints leave it out where it is as in a new object
    bool inFingerprintIfSaved = false;  ///< fingerprints leave it out where FieldHooks::isSaved does not hold
    /// The key names, for other kinds, a member that is in the list already.
    bool alias = false;
    /// Files hold it in a form that has code of its own.
    bool custom = false;
    std::string_view setting = {};  ///< its name in fingerprints of settings, where it is not the key
    std::string_view option = {};   ///< "--depth", where the command line can set it
    std::string_view variant = {};  ///< "sampler", where a variant of `glint converge` can set it
    std::string_view whenTrue = {}, whenFalse = {};      ///< words of a bool; true and false by default
    std::vector<std::string_view> (*words)() = nullptr;  ///< the texts that a string can be
};

/// What a field does with the object it is in; each may be left out.
template <class Owner>
struct FieldHooks {
    /// Sets the default that depends on the fields before it; where an object is read from a file.
    void (*setDefault)(Owner* owner) = nullptr;
    /// Whether the object is as it should be once the field is read, and the message if it is not, in which
    /// {} stands for the value.
    bool (*holds)(const Owner& owner) = nullptr;
    std::string_view message = {};
    /// Whether a file should have the field.
    bool (*isSaved)(const Owner& owner) = nullptr;
};

template <class Owner, class Member>
struct Field {
    std::string_view key;  ///< in scene files; empty where they do not hold it
    Member Owner::*member;
    FieldTraits traits;
    FieldHooks<Owner> hooks;
};

template <class Owner, class Member>
constexpr Field<Owner, Member> field(std::string_view key, Member Owner::*member, FieldTraits traits = {},
                                     std::type_identity_t<FieldHooks<Owner>> hooks = {}) {
    return {key, member, traits, hooks};
}

/// A field that is for people: nothing is rendered anew when it changes.
template <class Owner, class Member>
constexpr Field<Owner, Member> label(std::string_view key, Member Owner::*member,
                                     std::string_view help = {}) {
    return {key, member, {.help = help, .edit = EditKind::None, .inFingerprint = false}, {}};
}

/// FieldTraits::kinds for some kinds of the owner.
template <class... Kind>
constexpr uint32_t only(Kind... kinds) {
    return ((1u << static_cast<uint32_t>(kinds)) | ...);
}

namespace detail {

template <size_t kIndex, class OneField>
struct FieldAt {
    OneField field;
};

template <size_t kIndex, class OneField>
constexpr const OneField& fieldAt(const FieldAt<kIndex, OneField>& at) {
    return at.field;
}

template <class Indices, class... Fields>
struct IndexedFields;

template <size_t... kIndices, class... Fields>
struct IndexedFields<std::index_sequence<kIndices...>, Fields...> : FieldAt<kIndices, Fields>... {
    constexpr explicit IndexedFields(const Fields&... fields) : FieldAt<kIndices, Fields>{fields}... {}

    template <class Visit>
    constexpr void forEach(const Visit& visit) const {
        (visit(this->FieldAt<kIndices, Fields>::field), ...);
    }
};

}  // namespace detail

/// Fields of different types, in order. A std::tuple of so many takes a compiler a second wherever it
/// is seen.
template <class... Fields>
struct FieldList : detail::IndexedFields<std::index_sequence_for<Fields...>, Fields...> {
    constexpr explicit FieldList(const Fields&... fields)
        : detail::IndexedFields<std::index_sequence_for<Fields...>, Fields...>(fields...) {}

    static constexpr size_t kSize = sizeof...(Fields);

    template <size_t kIndex>
    constexpr const auto& get() const {
        return detail::fieldAt<kIndex>(*this);
    }
};

/// The list of a type: kEdit, what an edit of its fields invalidates where they do not say; kList, a
/// FieldList in the order of files and fingerprints.
template <class Owner>
struct FieldsOf;

template <class Owner>
concept HasFields = requires {
    FieldsOf<Owner>::kList;
};

/// Calls visit(field) for each field of the list, in order.
template <class Owner, class Visit>
constexpr void forEachField(const Visit& visit) {
    FieldsOf<Owner>::kList.forEach(visit);
}

/// What an edit of the field invalidates.
template <class Owner, class Member>
constexpr EditKind editOf(const Field<Owner, Member>& field) {
    return field.traits.edit.value_or(FieldsOf<Owner>::kEdit);
}

}  // namespace glint
