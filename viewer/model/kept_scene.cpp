#include "viewer/model/kept_scene.h"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "engine/base/check.h"
#include "engine/scene/scene_fields.h"

namespace glint {
namespace {

template <class Value>
constexpr bool kIsList = false;
template <class Item>
constexpr bool kIsList<std::vector<Item>> = true;

/// In every field, be it an edit or not; heavy parts by identity.
template <class Value>
bool isSame(const Value& a, const Value& b) {
    if constexpr (HasFields<Value>) {
        bool same = true;
        forEachField<Value>(
            [&](const auto& field) { same = same && isSame(a.*field.member, b.*field.member); });
        return same;
    } else if constexpr (kIsList<Value>) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                          [](const auto& x, const auto& y) { return isSame(x, y); });
    } else if constexpr (std::is_same_v<Value, SceneImage>) {
        return a.source == b.source && a.bytes == b.bytes && a.floats == b.floats;
    } else {
        return a == b;
    }
}

/// Calls visit(member, place) for each member of a scene, with its place among the lists if it is one.
/// Returns the number of lists.
template <size_t kField = 0, size_t kLists = 0, class Visit>
constexpr size_t forEachMember(const Visit& visit) {
    constexpr const auto& kFields = FieldsOf<SceneDescription>::kList;
    if constexpr (kField == kFields.kSize) {
        return kLists;
    } else {
        constexpr auto kMember = kFields.template get<kField>().member;
        using Value = std::remove_cvref_t<decltype(std::declval<SceneDescription>().*kMember)>;
        visit(kMember, std::integral_constant<size_t, kLists>());
        return forEachMember<kField + 1, kLists + (kIsList<Value> ? 1 : 0)>(visit);
    }
}

}  // namespace

template <class Item>
size_t KeptList<Item>::keep(const std::vector<Item>& items, const KeptList* like) {
    const std::vector<Piece> none;
    const std::vector<Piece>& known = like != nullptr ? like->pieces_ : none;
    const auto isAt = [&](const Piece& piece, size_t at) {
        return std::equal(piece->begin(), piece->end(), items.begin() + static_cast<std::ptrdiff_t>(at),
                          [](const Item& a, const Item& b) { return isSame(a, b); });
    };
    size_t first = 0, last = items.size();  // of what is copied
    size_t head = 0, tail = known.size();   // of the pieces in between, which are not shared
    while (head < tail && known[head]->size() <= last - first && isAt(known[head], first)) {
        first += known[head++]->size();
    }
    while (head < tail && known[tail - 1]->size() <= last - first &&
           isAt(known[tail - 1], last - known[tail - 1]->size())) {
        last -= known[--tail]->size();
    }
    // Small neighbours join it: else a list that grew item by item would be as many pieces.
    const auto joins = [&](const Piece& piece) {
        return last > first && piece->size() + (last - first) <= kMostInPiece;
    };
    while (head > 0 && joins(known[head - 1])) {
        first -= known[--head]->size();
    }
    while (tail < known.size() && joins(known[tail])) {
        last += known[tail++]->size();
    }
    pieces_.assign(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(head));
    for (size_t at = first; at < last; at += kMostInPiece) {
        const auto from = items.begin() + static_cast<std::ptrdiff_t>(at);
        const size_t count = std::min(kMostInPiece, last - at);
        pieces_.push_back(
            std::make_shared<const std::vector<Item>>(from, from + static_cast<std::ptrdiff_t>(count)));
    }
    pieces_.insert(pieces_.end(), known.begin() + static_cast<std::ptrdiff_t>(tail), known.end());
    return last - first;
}

template <class Item>
std::vector<Item> KeptList<Item>::items() const {
    std::vector<Item> all;
    for (const Piece& piece : pieces_) {
        all.insert(all.end(), piece->begin(), piece->end());
    }
    return all;
}

KeptScene::KeptScene(const std::shared_ptr<const SceneDescription>& scene, const KeptScene* like)
    : itself_(scene) {
    const size_t lists = forEachMember([&](auto member, auto place) {
        if constexpr (kIsList<std::remove_cvref_t<decltype(rest_.*member)>>) {
            constexpr size_t kPlace = decltype(place)::value;
            const auto* known = like != nullptr ? &std::get<kPlace>(like->lists_) : nullptr;
            itemsCopied_ += std::get<kPlace>(lists_).keep((*scene).*member, known);
        } else {
            rest_.*member = (*scene).*member;
        }
    });
    GLINT_CHECK(lists == std::tuple_size_v<Lists>);
}

std::shared_ptr<const SceneDescription> KeptScene::scene() const {
    if (auto itself = itself_.lock()) { return itself; }
    auto scene = std::make_shared<SceneDescription>(rest_);
    forEachMember([&](auto member, auto place) {
        if constexpr (kIsList<std::remove_cvref_t<decltype(rest_.*member)>>) {
            (*scene).*member = std::get<decltype(place)::value>(lists_).items();
        }
    });
    return scene;
}

}  // namespace glint
