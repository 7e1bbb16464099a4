#include "engine/scene/scene_diff.h"

#include "engine/scene/scene_use.h"

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

/// Which of the scene's materials, textures or meshes make a picture.
std::vector<bool> usedOf(const SceneDescription& scene, const std::vector<Material>&) {
    return usedMaterials(scene);
}
std::vector<bool> usedOf(const SceneDescription& scene, const std::vector<Texture>&) {
    return usedTextures(scene);
}
std::vector<bool> usedOf(const SceneDescription& scene, const std::vector<Mesh>&) {
    return usedMeshes(scene);
}

template <class Value>
concept MayBeUnused = requires(const SceneDescription& scene, const Value& value) {
    usedOf(scene, value);
};

template <class Value>
EditKind compare(const Value& a, const Value& b, EditKind edit);

/// Items that neither scene uses are passed over.
template <class Items>
EditKind compareUsed(const Items& a, const std::vector<bool>& usedA, const Items& b,
                     const std::vector<bool>& usedB, EditKind edit) {
    if (a.size() != b.size()) { return edit; }
    EditKind kinds = EditKind::None;
    for (size_t i = 0; i < a.size(); ++i) {
        if (usedA[i] || usedB[i]) { kinds |= compare(a[i], b[i], edit); }
    }
    return kinds;
}

EditKind compareScenes(const SceneDescription& a, const SceneDescription& b) {
    EditKind kinds = EditKind::None;
    forEachField<SceneDescription>([&](const auto& field) {
        const auto &itemsA = a.*field.member, &itemsB = b.*field.member;
        const EditKind own = editOf(field);
        if constexpr (MayBeUnused<std::remove_cvref_t<decltype(itemsA)>>) {
            kinds |= compareUsed(itemsA, usedOf(a, itemsA), itemsB, usedOf(b, itemsB), own);
        } else if (own != EditKind::None) {
            kinds |= compare(itemsA, itemsB, own);
        }
    });
    return kinds;
}

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

/// Of fields that are no edit, at any depth.
template <class Value>
bool sameLabels(const Value& a, const Value& b) {
    bool isSame = true;
    if constexpr (HasFields<Value>) {
        forEachField<Value>([&](const auto& field) {
            const auto &partA = a.*field.member, &partB = b.*field.member;
            const bool isLabel = editOf(field) == EditKind::None;
            isSame = isSame && sameLabels(partA, partB) &&
                     (!isLabel || compare(partA, partB, EditKind::Everything) == EditKind::None);
        });
    } else if constexpr (kIsVector<Value>) {
        isSame = a.size() == b.size();
        for (size_t i = 0; isSame && i < a.size(); ++i) {
            isSame = sameLabels(a[i], b[i]);
        }
    }
    return isSame;
}

using Differences = std::vector<SceneDifference>;

template <class Value>
void listFields(SceneDifference at, const Value& a, const Value& b, EditKind edit, Differences* out) {
    if constexpr (HasFields<Value>) {
        const uint32_t kinds = kindBit(b);
        forEachField<Value>([&](const auto& field) {
            const EditKind own = editOf(field);
            const bool isOfKind = (field.traits.kinds & kinds) != 0;
            if (own == EditKind::None || !isOfKind ||
                compare(a.*field.member, b.*field.member, own) == EditKind::None) {
                return;
            }
            at.key = field.key;
            out->push_back(at);
        });
    } else if (compare(a, b, edit) != EditKind::None) {
        out->push_back(at);
    }
}

template <class Value>
void listPart(std::string_view part, const Value& a, const Value& b, EditKind edit, Differences* out) {
    if constexpr (!kIsVector<Value>) {
        listFields({.part = part}, a, b, edit, out);
    } else if (a.size() != b.size()) {
        out->push_back({.part = part, .added = static_cast<int>(b.size()) - static_cast<int>(a.size())});
    } else {
        for (size_t i = 0; i < a.size(); ++i) {
            listFields({.part = part, .item = static_cast<int>(i)}, a[i], b[i], edit, out);
        }
    }
}

}  // namespace

std::vector<SceneDifference> listDifferences(const SceneDescription& before, const SceneDescription& after) {
    Differences out;
    forEachField<SceneDescription>([&](const auto& field) {
        const EditKind own = editOf(field);
        std::string_view part = field.key;
        forEachIntegratorOptions([&](IntegratorKind kind, auto member) {
            if constexpr (std::is_same_v<decltype(member), decltype(field.member)>) {
                if (member == field.member) { part = integratorInfo(kind).key; }
            }
        });
        if (own != EditKind::None) { listPart(part, before.*field.member, after.*field.member, own, &out); }
    });
    return out;
}

bool sameUnseen(const SceneDescription& before, const SceneDescription& after) {
    return sameLabels(before, after);
}

EditKind differences(const SceneDescription& before, const SceneDescription& after) {
    const EditKind kinds = compareScenes(before, after);
    return has(kinds, EditKind::Everything) ? EditKind::Everything : kinds;
}

}  // namespace glint
