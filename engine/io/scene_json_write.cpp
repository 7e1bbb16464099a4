// Writes a scene as Glint JSON. Whatever the reader knows and affects the picture is written out, so that a
// saved scene does not depend on defaults.
#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/embedded_files.h"
#include "engine/io/file_path.h"
#include "engine/io/json_writer.h"
#include "engine/io/scene_json.h"
#include "engine/io/scene_json_keys.h"
#include "engine/io/scene_names.h"
#include "engine/scene/kind_names.h"
#include "engine/scene/scene_fields.h"
#include "engine/scene/shape_forms.h"

namespace glint {
namespace {

class SceneJsonWriter {
  public:
    SceneJsonWriter(const SceneDescription& scene, std::string path)
        : scene_(scene),
          path_(std::move(path)),
          textureNames_(uniqueNames(scene.textures, "texture")),
          materialNames_(uniqueNames(scene.materials, "material")),
          meshNames_(uniqueNames(scene.meshes, "mesh")) {}

    Result<std::string> write() {
        json_.beginObject();
        json_.field("glint", 1);
        writeFields(scene_);
        json_.endObject();
        if (!json_.allFinite()) {
            fail("the scene holds a number that is not finite, which cannot be saved");
        }
        return error_ ? Result<std::string>(*error_) : Result<std::string>(json_.text() + "\n");
    }

  private:
    void fail(std::string message) {
        if (!error_) { error_ = Error{std::move(message), {path_, 0, 0, ""}}; }
    }

    std::string rebased(const std::string& path) const { return rebasePath(path, scene_.path, path_); }

    template <class WriteMembers>
    void writeObject(std::string_view key, const WriteMembers& writeMembers) {
        json_.key(key);
        json_.beginObject();
        writeMembers();
        json_.endObject();
    }

    template <class Owner>
    void writeFields(const Owner& owner) {
        const uint32_t kinds = kindBit(owner);
        forEachField<Owner>([&](const auto& field) {
            const bool isSaved = field.hooks.isSaved == nullptr || field.hooks.isSaved(owner);
            if (field.key.empty() || (field.traits.kinds & kinds) == 0 || !isSaved) { return; }
            if constexpr (requires { writeCustom(field.key, owner); }) {
                if (field.traits.custom) { return writeCustom(field.key, owner); }
            }
            write(field.key, field.traits, owner.*field.member);
        });
    }

    template <class Value>
    void write(std::string_view key, const FieldTraits& traits, const Value& value) {
        if constexpr (HasFields<Value>) {
            writeObject(key, [&] { writeFields(value); });
        } else if constexpr (std::is_enum_v<Value>) {
            json_.field(key, nameOf(value));
        } else if constexpr (std::is_same_v<Value, bool>) {
            if (traits.whenTrue.empty()) {
                json_.field(key, value);
            } else {
                json_.field(key, value ? traits.whenTrue : traits.whenFalse);
            }
        } else if constexpr (std::is_integral_v<Value>) {
            json_.field(key, static_cast<int64_t>(value));
        } else if constexpr (requires { value.front().x; }) {
            writeVectors(key, value);
        } else if constexpr (kIsInput<Value>) {
            writeInput(key, traits, value);
        } else if constexpr (std::is_same_v<Value, SceneImage>) {
            json_.field(key, rebased(pathOf(value.source)));
        } else if constexpr (requires { json_.value(value); }) {
            json_.field(key, value);
        }
    }

    template <class Input>
    void writeInput(std::string_view key, const FieldTraits& traits, const Input& input) {
        if (input.texture < 0) { return json_.field(key, input.value); }
        writeObject(key, [&] {
            json_.field("texture", textureNames_[static_cast<size_t>(input.texture)]);
            if constexpr (std::is_same_v<Input, NumberInput>) {
                if (static_cast<double>(input.value) < traits.range.lo) { return; }  // it has none
            }
            json_.field("fallback", input.value);
        });
    }

    void write(std::string_view key, const FieldTraits&, const Resolution& resolution) {
        const float size[2] = {static_cast<float>(resolution.width), static_cast<float>(resolution.height)};
        json_.key(key);
        json_.numbers(size, 2);
    }
    void write(std::string_view key, const FieldTraits&, const RenderOptions& options) {
        writeObject(key, [&] {
            writeFields(options);
            forEachIntegratorOptions([&](IntegratorKind kind, auto member) {
                writeObject(integratorInfo(kind).key, [&] { writeFields(scene_.*member); });
            });
        });
    }
    void write(std::string_view key, const FieldTraits&, const std::vector<Texture>& textures) {
        writeNamed(key, textures, textureNames_);
    }
    void write(std::string_view key, const FieldTraits&, const std::vector<Material>& materials) {
        writeNamed(key, materials, materialNames_);
    }
    void write(std::string_view key, const FieldTraits&, const std::vector<Mesh>& meshes) {
        writeNamed(key, meshes, meshNames_);
    }
    void write(std::string_view key, const FieldTraits&, const std::vector<Object>& objects) {
        json_.key(key);
        json_.beginArray();
        for (const Object& object : objects) {
            writeElement(object, [] {});
        }
        for (const Object& object : scene_.hiddenObjects) {
            writeElement(object, [&] { json_.field(kHiddenKey, true); });
        }
        json_.endArray();
    }
    void write(std::string_view key, const FieldTraits&, const std::vector<Light>& lights) {
        writeArray(key, lights);
    }

    template <class Item>
    void writeNamed(std::string_view key, const std::vector<Item>& items,
                    const std::vector<std::string>& names) {
        writeObject(key, [&] {
            for (size_t i = 0; i < items.size(); ++i) {
                writeObject(names[i], [&] { writeItem(items[i]); });
            }
        });
    }

    template <class Item>
    void writeArray(std::string_view key, const std::vector<Item>& items) {
        json_.key(key);
        json_.beginArray();
        for (const Item& item : items) {
            writeElement(item, [] {});
        }
        json_.endArray();
    }

    template <class Item, class WriteMore>
    void writeElement(const Item& item, const WriteMore& writeMore) {
        json_.beginObject();
        writeItem(item);
        writeMore();
        json_.endObject();
    }

    template <class Item>
    void writeItem(const Item& item) {
        writeFields(item);
    }
    void writeItem(const Texture& texture) {
        if (const auto* board = std::get_if<Checkerboard>(&texture.image.source)) {
            json_.field("generator", "checkerboard");
            writeFields(*board);
        } else if (pathOf(texture.image.source).empty()) {
            fail(fmt::format("the texture \"{}\" is not from a file, so it cannot be saved", texture.name));
        }
        writeFields(texture);
    }
    void writeItem(const Mesh& mesh) {
        if (const auto* file = std::get_if<FileSource>(&mesh.source)) {
            FileSource saved = *file;
            saved.path = rebased(file->path);
            writeFields(saved);
        } else if (const auto* generator = std::get_if<MeshGenerator>(&mesh.source)) {
            writeFields(*generator);
        } else if (!mesh.data) {
            fail(fmt::format("the mesh \"{}\" is not from a file, so it cannot be saved", mesh.name));
        } else {
            writeInlineMesh(*mesh.data);
        }
    }

    template <class Vector>
    void writeVectors(std::string_view key, const std::vector<Vector>& vectors) {
        if (vectors.empty()) { return; }
        json_.key(key);
        json_.beginArray();
        for (const Vector& v : vectors) {
            json_.value(v);
        }
        json_.endArray();
    }

    void writeInlineMesh(const MeshData& mesh) {
        writeVectors("positions", mesh.positions);
        writeVectors("normals", mesh.normals);
        writeVectors("uvs", mesh.uvs);
        writeVectors("colors", mesh.colors);
        writeVectors("tangents", mesh.tangents);
        json_.key("triangles");
        json_.beginArray();
        for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            json_.indices(&mesh.indices[i], 3);
        }
        json_.endArray();
    }

    void writeCustom(std::string_view key, const Object& object) {
        if (key == "material") {
            json_.field(key, materialNames_[static_cast<size_t>(object.material)]);
            return;
        }
        if (object.shape == ShapeKind::Mesh) {
            json_.field("mesh", meshNames_[static_cast<size_t>(object.mesh)]);
        }
        const ShapeForm& form = shapeForm(object.shape);
        Placement values;
        if (form.valuesOf != nullptr && form.valuesOf(object.objectToWorld, &values)) {
            writePlacement(form, values);
        } else if (!object.objectToWorld.isExactIdentity()) {
            writeObject(key, [&] { writeMatrix(object.objectToWorld); });
        }
    }

    void writePlacement(const ShapeForm& form, const Placement& values) {
        for (size_t i = 0; i < form.keys().size(); ++i) {
            const PlacementKey& key = form.keys()[i];
            if (key.form == PlacementForm::Length) {
                json_.field(key.key, values[i].x);
            } else {
                json_.field(key.key, values[i]);
            }
        }
    }

    void writeMatrix(const Affine& transform) {
        const Mat3& m = transform.linear;
        const Vec3& t = transform.translation;
        const float rows[12] = {m[0].x, m[1].x, m[2].x, t.x,    m[0].y, m[1].y,
                                m[2].y, t.y,    m[0].z, m[1].z, m[2].z, t.z};
        json_.key("matrix");
        json_.numbers(rows, 12);
    }

    void writeCustom(std::string_view key, const Environment& environment) {
        if (environment.image < 0) { return; }
        const SceneImage& image = scene_.environmentImages[static_cast<size_t>(environment.image)];
        writeObject(key, [&] {
            if (const auto* sky = std::get_if<SkySource>(&image.source)) {
                json_.field("generator", "sky");
                writeFields(*sky);
            } else if (const std::string path = pathOf(image.source); !path.empty()) {
                json_.field("file", rebased(path));
            } else {
                fail("the environment's image is not from a file, so it cannot be saved");
            }
        });
    }

    const SceneDescription& scene_;
    std::string path_;
    std::vector<std::string> textureNames_;
    std::vector<std::string> materialNames_;
    std::vector<std::string> meshNames_;
    JsonWriter json_;
    std::optional<Error> error_;
};

}  // namespace

Result<std::string> writeSceneJson(const SceneDescription& scene, const std::string& path) {
    return SceneJsonWriter(scene, path).write();
}

Status saveSceneJson(const SceneDescription& scene, const std::string& path) {
    SceneDescription named = scene;
    if (Status written = writeEmbeddedFiles(&named, path); !written) { return written; }
    const auto text = writeSceneJson(named, path);
    return text ? writeFileAtomically(path, *text) : Status(text.error());
}

}  // namespace glint
