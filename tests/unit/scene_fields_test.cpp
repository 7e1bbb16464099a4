// Every field of every scene type is in its list, and what follows from the lists notices each of them: the
// kind of an edit, the fingerprint, saving and loading.
#include <set>

#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "engine/io/scene_json.h"
#include "engine/scene/generated_sky.h"
#include "engine/scene/scene_diff.h"
#include "engine/scene/scene_hash.h"
#include "engine/scene/shape_forms.h"
#include "tests/support/field_values.h"

namespace glint {
namespace {

using test::changeValue;
using test::forEachOwner;
using test::memberCount;
using test::ownersIn;

std::shared_ptr<const MeshData> triangle() {
    auto mesh = std::make_shared<MeshData>();
    mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh->indices = {0, 1, 2};
    return mesh;
}

Mesh meshFrom(MeshSource source) { return {"mesh", std::move(source), triangle()}; }

Texture textureFrom(const char* path) {
    Texture texture;
    texture.name = path;
    texture.image.source = FileSource{path};
    texture.image.bytes = std::make_shared<Image8>(Image8{1, 1, {10, 20, 30}});
    return texture;
}

Texture checkerboard() {
    Texture texture;
    texture.name = "checks";
    texture.image = {Checkerboard{}, nullptr, generateCheckerboard({})};
    return texture;
}

SceneImage sky(float sunElevationDeg) {
    SceneImage image;
    const SkySource source{.sunElevationDeg = sunElevationDeg, .width = 32};
    image.source = source;
    image.floats = generateSky(source);
    return image;
}

/// Every kind of everything, and all of it in use.
SceneDescription fullScene() {
    SceneDescription scene;
    scene.warnings = scene.notes = scene.filesRead = {"something"};
    scene.camera.kind = ProjectionKind::Orthographic;
    scene.camera.apertureBlades = 5;
    scene.options.integrator = IntegratorKind::Sppm;
    scene.textures = {textureFrom("a.png"), textureFrom("b.png"), checkerboard()};
    scene.environmentImages = {sky(10.0f), sky(20.0f)};
    scene.environment = {.color = Vec3(0.3f), .strength = 0.7f, .image = 0, .rotationDeg = 12.0f};
    scene.environment.portal = {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}};
    for (const KindName<MaterialKind>& kind : kindNames<MaterialKind>()) {
        Material material;
        material.name = kind.name;
        material.kind = kind.kind;
        material.roughness.value = 0.3f;
        material.phongSpecular = Vec3(0.1f);
        scene.materials.push_back(material);
    }
    scene.materials.push_back(scene.materials[static_cast<size_t>(MaterialKind::Conductor)]);
    scene.materials.back().name = "own metal";
    scene.materials.back().metal.clear();
    scene.materials[0].color.texture = 0;
    scene.materials[1].color.texture = 1;
    scene.materials[static_cast<size_t>(MaterialKind::Mixture)].color.texture = 2;
    scene.meshes = {meshFrom({}), meshFrom(FileSource{"m.obj", 1}),
                    meshFrom(MeshGenerator{.name = "water", .triangles = 100})};
    for (const ShapeForm& form : shapeForms()) {
        for (int i = 0; i < static_cast<int>(scene.materials.size()); ++i) {
            Object object;
            object.name = form.name;
            object.shape = form.kind;
            object.mesh = i % 3;
            object.material = i;
            object.profile = {{0, 0}, {1, 0}, {1, 1}, {0.5f, 2}, {0, 2}};
            scene.objects.push_back(object);
        }
    }
    scene.hiddenObjects = {scene.objects[0]};
    for (const KindName<LightKind>& kind : kindNames<LightKind>()) {
        Light light;
        light.name = kind.name;
        light.kind = kind.kind;
        scene.lights.push_back(light);
    }
    return scene;
}

/// What has fields of its own is changed by them.
template <class Member>
constexpr bool kIsWhole = !HasFields<Member>;

template <class Member>
constexpr bool kIsList = requires(Member member) {
    member.push_back(member.back());
}
&&!std::is_same_v<Member, std::string>;

template <class Owner>
std::string titleOf(std::string_view key, size_t index) {
    return std::string(typeid(Owner).name()) + " " + std::to_string(index) + " " + std::string(key);
}

/// Calls check(before, after, field, title, isTexture) for each field of each object of the scene, changed
/// by itself.
template <class Owner, class Check>
void forEachChange(const SceneDescription& scene, const Check& check) {
    SceneDescription counted = scene;
    for (size_t i = 0; i < ownersIn<Owner>(&counted).size(); ++i) {
        forEachField<Owner>([&]<class Member>(const Field<Owner, Member>& field) {
            if constexpr (kIsWhole<Member>) {
                SceneDescription changed = scene;
                changeValue(field.traits, &(ownersIn<Owner>(&changed)[i]->*field.member));
                check(changed, i, field, false);
            }
            if constexpr (kIsInput<Member>) {
                SceneDescription textured = scene;
                int& texture = (ownersIn<Owner>(&textured)[i]->*field.member).texture;
                texture = texture == 0 ? 1 : 0;
                check(textured, i, field, true);
            }
        });
    }
}

TEST(SceneFields, ListsHaveEveryMemberOnce) {
    forEachOwner([]<class Owner>() {
        Owner owner;
        std::set<const void*> members;
        size_t fields = 0;
        forEachField<Owner>([&](const auto& field) {
            const bool isNew = members.insert(&(owner.*field.member)).second;
            EXPECT_EQ(isNew, !field.traits.alias) << titleOf<Owner>(field.key, 0);
            ++fields;
        });
        EXPECT_EQ(members.size(), memberCount<Owner>()) << typeid(Owner).name();
        EXPECT_GE(fields, members.size());
    });
}

TEST(SceneFields, EditsAreSeenAsWhatTheyAre) {
    const SceneDescription scene = fullScene();
    ASSERT_EQ(differences(scene, fullScene()), EditKind::Everything) << "other pixels at other addresses";
    ASSERT_EQ(differences(scene, SceneDescription(scene)), EditKind::None);
    forEachOwner([&]<class Owner>() {
        forEachChange<Owner>(
            scene, [&](const SceneDescription& changed, size_t i, const auto& field, bool texture) {
                EXPECT_EQ(differences(scene, changed), texture ? EditKind::MaterialKind : editOf(field))
                    << titleOf<Owner>(field.key, i);
            });
    });
}

TEST(SceneFields, FingerprintsHaveWhatThePictureDependsOn) {
    SceneDescription scene = fullScene();
    ASSERT_EQ(sceneHash(fullScene()), sceneHash(scene));
    forEachOwner([&]<class Owner>() {
        const bool isOfRayCast = std::is_same_v<Owner, RayCastOptions>;
        scene.options.integrator = isOfRayCast ? IntegratorKind::RayCast : IntegratorKind::Sppm;
        const Hash128 before = sceneHash(scene);
        forEachChange<Owner>(scene, [&](const SceneDescription& changed, size_t i, const auto& field, bool) {
            SceneDescription copy = changed;
            const bool isOwn = (field.traits.kinds & kindBit(*ownersIn<Owner>(&copy)[i])) != 0;
            EXPECT_EQ(!(sceneHash(changed) == before),
                      field.traits.inFingerprint && (isOwn || !field.traits.onlyOwnKinds))
                << titleOf<Owner>(field.key, i);
        });
    });
}

TEST(SceneFields, FingerprintsOfMaterialsWithoutHighlightsAreAsBeforeThereWereAny) {
    SceneDescription scene = fullScene();
    for (Material& material : scene.materials) {
        material.phongSpecular = Vec3(0.0f);
    }
    const Hash128 before = sceneHash(scene);
    scene.materials[0].phongExponent *= 2.0f;
    EXPECT_EQ(sceneHash(scene), before);
}

/// A scene that can be read without its mesh's file; its textures' files are written into the working folder.
SceneDescription savedScene() {
    SceneDescription scene = fullScene();
    scene.environmentImages.resize(1);
    for (const Texture& texture : scene.textures) {
        if (texture.image.isGenerated()) { continue; }
        EXPECT_TRUE(savePng(texture.name, *texture.image.bytes));
    }
    for (size_t i = 0; i < scene.objects.size(); ++i) {
        scene.objects[i].mesh = 0;
        scene.objects[i].material = i % 2 == 0 ? 2 : 3;
    }
    return scene;
}

TEST(SceneFields, SavingAndLoadingKeepsThem) {
    const SceneDescription scene = savedScene();
    forEachOwner([&]<class Owner>() {
        std::set<std::string_view> keys, checked;
        forEachField<Owner>([&](const auto& field) { keys.insert(field.key); });
        forEachChange<Owner>(scene, [&](SceneDescription changed, size_t i, const auto& field, bool) {
            const Owner& owner = *ownersIn<Owner>(&changed)[i];
            const bool isSaved = field.hooks.isSaved == nullptr || field.hooks.isSaved(owner);
            if ((field.traits.kinds & kindBit(owner)) == 0 || field.key.empty() || !isSaved) { return; }
            constexpr bool kIsEnvironment = std::is_same_v<Owner, Environment>;
            // Only the image in use is saved, and is the first one when it is read.
            if constexpr (kIsEnvironment) {
                if (owner.image == 1) { changed.environmentImages.push_back(sky(20.0f)); }
            }
            const auto text = writeSceneJson(changed, "saved.json");
            ASSERT_TRUE(text.ok()) << titleOf<Owner>(field.key, i) << text.error().format();
            auto loaded = readSceneJson({"saved.json", *text}, {});
            ASSERT_TRUE(loaded.ok()) << titleOf<Owner>(field.key, i) << loaded.error().format();
            const Owner& read = *ownersIn<Owner>(&*loaded)[i];
            using Member = std::remove_cvref_t<decltype(read.*field.member)>;
            if (kIsEnvironment && field.key == "image") {
                EXPECT_EQ(loaded->environmentImages[0].source,
                          changed.environmentImages[static_cast<size_t>(changed.environment.image)].source);
            } else if constexpr (std::is_same_v<Member, SceneImage>) {
                EXPECT_EQ((read.*field.member).source, (owner.*field.member).source);
            } else if constexpr (!kIsList<Member> || std::is_same_v<Member, std::vector<Vec3>>) {
                EXPECT_EQ(read.*field.member, owner.*field.member) << titleOf<Owner>(field.key, i);
            }
            checked.insert(field.key);
        });
        if (keys.contains("")) { checked.insert(""); }
        const bool isRoot = std::is_same_v<Owner, SceneDescription>;
        for (const std::string_view key : keys) {
            EXPECT_TRUE(isRoot || checked.contains(key)) << typeid(Owner).name() << ' ' << key;
        }
    });
}

}  // namespace
}  // namespace glint
