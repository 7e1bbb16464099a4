// Other values for fields of scene types, and how many members a type has.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/scene/kind_names.h"
#include "engine/scene/scene_fields.h"

namespace glint::test {

/// Stands for a value of any type where a type's members are counted.
struct Anything {
    template <class T>
    operator T() const;  // NOLINT: implicit, and never defined
};

/// How many values an aggregate takes in braces; a base is one.
template <class T, class... Counted>
consteval size_t bracedCount() {
    if constexpr (requires { T{Counted{}..., Anything{}}; }) {
        return bracedCount<T, Counted..., Anything>();
    } else {
        return sizeof...(Counted);
    }
}

/// How many members an aggregate has, those of a material's base included.
template <class T>
consteval size_t memberCount() {
    using Inputs = MaterialInputs<ColorInput, NumberInput>;
    return bracedCount<T>() + (std::is_base_of_v<Inputs, T> ? bracedCount<Inputs>() - 1 : 0);
}

inline float otherNumber(float x) { return x == 0.0f || x == -1.0f ? 0.25f : 0.75f * x; }

/// Changes a value to another one that the field takes, where the field does not depend on others.
template <class Member>
void changeValue(const FieldTraits& traits, Member* value) {
    if constexpr (std::is_enum_v<Member>) {
        const auto names = kindNames<Member>();
        size_t index = 0;
        while (names[index].kind != *value) {
            ++index;
        }
        *value = names[(index + 1) % names.size()].kind;
    } else if constexpr (std::is_same_v<Member, bool>) {
        *value = !*value;
    } else if constexpr (std::is_integral_v<Member>) {
        *value += traits.range.hi < kAnyNumber.hi ? 2 : 1;
    } else if constexpr (std::is_same_v<Member, float>) {
        *value = otherNumber(*value);
    } else if constexpr (std::is_same_v<Member, std::string>) {
        const auto words = traits.words == nullptr ? std::vector<std::string_view>() : traits.words();
        *value = words.empty() ? *value + "x" : std::string(*value == words[0] ? words[1] : words[0]);
    } else if constexpr (std::is_same_v<Member, Vec2> || std::is_same_v<Member, Vec3>) {
        value->x = otherNumber(value->x);
    } else if constexpr (std::is_same_v<Member, Affine>) {
        value->translation.x += 1.0f;
    } else if constexpr (kIsInput<Member>) {
        changeValue(traits, &value->value);
    } else if constexpr (std::is_same_v<Member, SceneImage>) {
        auto bytes = value->bytes ? std::make_shared<Image8>(*value->bytes) : std::make_shared<Image8>();
        bytes->rgb.push_back(77);
        value->bytes = bytes;
        value->source = FileSource{pathOf(value->source) + "x"};
    } else if constexpr (std::is_same_v<Member, std::shared_ptr<const MeshData>>) {
        auto data = std::make_shared<MeshData>(**value);
        data->positions[0].x += 1.0f;
        *value = data;
    } else if constexpr (std::is_same_v<Member, std::vector<Vec3>>) {
        for (Vec3& corner : *value) {
            corner.x += 1.0f;
        }
    } else if constexpr (requires { value->push_back(value->back()); }) {
        value->push_back(value->back());
    }
}

/// The objects of a type in a scene.
template <class Owner>
std::vector<Owner*> ownersIn(SceneDescription* scene) {
    std::vector<Owner*> owners;
    const auto addAll = [&](auto& items) {
        for (auto& item : items) {
            owners.push_back(&item);
        }
    };
    if constexpr (std::is_same_v<Owner, SceneDescription>) {
        owners.push_back(scene);
    } else if constexpr (std::is_same_v<Owner, Camera>) {
        owners.push_back(&scene->camera);
    } else if constexpr (std::is_same_v<Owner, Resolution>) {
        owners.push_back(&scene->resolution);
    } else if constexpr (std::is_same_v<Owner, RenderOptions>) {
        owners.push_back(&scene->options);
    } else if constexpr (std::is_same_v<Owner, SppmOptions>) {
        owners.push_back(&scene->sppm);
    } else if constexpr (std::is_same_v<Owner, RayCastOptions>) {
        owners.push_back(&scene->rayCast);
    } else if constexpr (std::is_same_v<Owner, Texture>) {
        addAll(scene->textures);
    } else if constexpr (std::is_same_v<Owner, Material>) {
        addAll(scene->materials);
    } else if constexpr (std::is_same_v<Owner, Mesh>) {
        addAll(scene->meshes);
    } else if constexpr (std::is_same_v<Owner, FileSource>) {
        owners.push_back(&std::get<FileSource>(scene->meshes[1].source));
    } else if constexpr (std::is_same_v<Owner, MeshGenerator>) {
        owners.push_back(&std::get<MeshGenerator>(scene->meshes[2].source));
    } else if constexpr (std::is_same_v<Owner, Object>) {
        addAll(scene->objects);
    } else if constexpr (std::is_same_v<Owner, Light>) {
        addAll(scene->lights);
    } else if constexpr (std::is_same_v<Owner, Environment>) {
        owners.push_back(&scene->environment);
    } else if constexpr (std::is_same_v<Owner, Checkerboard>) {
        owners.push_back(&std::get<Checkerboard>(scene->textures[2].image.source));
    } else if constexpr (std::is_same_v<Owner, SkySource>) {
        owners.push_back(&std::get<SkySource>(scene->environmentImages[0].source));
    }
    return owners;
}

/// Calls visit.template operator()<Owner>() for every type that has a list of fields.
template <class Visit>
void forEachOwner(const Visit& visit) {
    visit.template operator()<SceneDescription>();
    visit.template operator()<Camera>();
    visit.template operator()<Resolution>();
    visit.template operator()<RenderOptions>();
    visit.template operator()<SppmOptions>();
    visit.template operator()<RayCastOptions>();
    visit.template operator()<Texture>();
    visit.template operator()<Material>();
    visit.template operator()<Mesh>();
    visit.template operator()<FileSource>();
    visit.template operator()<MeshGenerator>();
    visit.template operator()<Object>();
    visit.template operator()<Light>();
    visit.template operator()<Environment>();
    visit.template operator()<SkySource>();
    visit.template operator()<Checkerboard>();
}

}  // namespace glint::test
