#include "engine/scene/scene_diff.h"

#include "engine/scene/scene_fields.h"

namespace glint {
namespace {

/// Reading what was left out is no edit.
bool sameImage(const SceneImage& a, const SceneImage& b) {
    return a.source == b.source &&
           (!a.isRead() || !b.isRead() || (a.bytes == b.bytes && a.floats == b.floats));
}

template <class Value>
constexpr bool kIsVector = false;
template <class Item>
constexpr bool kIsVector<std::vector<Item>> = true;

template <class Value>
EditKind compare(const Value& a, const Value& b, EditKind edit) {
    EditKind kinds = EditKind::None;
    if constexpr (HasFields<Value>) {
        forEachField<Value>([&](const auto& field) {
            const EditKind own = editOf(field);
            if (own != EditKind::None) { kinds |= compare(a.*field.member, b.*field.member, own); }
        });
    } else if constexpr (kIsVector<Value>) {
        if (a.size() != b.size()) { return edit; }
        for (size_t i = 0; i < a.size(); ++i) {
            kinds |= compare(a[i], b[i], edit);
        }
    } else if constexpr (kIsInput<Value>) {
        kinds |= a.value == b.value ? EditKind::None : edit;
        kinds |= a.texture == b.texture ? EditKind::None : EditKind::MaterialKind;
    } else if constexpr (std::is_same_v<Value, SceneImage>) {
        return sameImage(a, b) ? EditKind::None : edit;
    } else {
        return a == b ? EditKind::None : edit;
    }
    return kinds;
}

}  // namespace

EditKind differences(const SceneDescription& before, const SceneDescription& after) {
    const EditKind kinds = compare(before, after, EditKind::Everything);
    return has(kinds, EditKind::Everything) ? EditKind::Everything : kinds;
}

}  // namespace glint
