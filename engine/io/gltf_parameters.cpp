#include "engine/io/gltf_parameters.h"

#include <algorithm>

#include <fmt/format.h>

#include "engine/base/nearest_name.h"

namespace glint {
namespace {

constexpr const char* kVariants = "KHR_materials_variants";

std::vector<std::string> variantNames(const tinygltf::Model& model) {
    std::vector<std::string> names;
    const auto* extension = extensionOf(model, kVariants);
    const tinygltf::Value none;
    const tinygltf::Value& variants = extension != nullptr ? extension->Get("variants") : none;
    for (size_t i = 0; variants.IsArray() && i < variants.ArrayLen(); ++i) {
        const tinygltf::Value& variant = variants.Get(static_cast<int>(i));
        const bool isNamed = variant.IsObject() && variant.Get("name").IsString();
        names.push_back(isNamed ? variant.Get("name").Get<std::string>() : std::string());
    }
    return names;
}

std::string listed(const std::vector<std::string>& names) {
    constexpr size_t kMost = 12;
    const std::vector<std::string_view> first(
        names.begin(), names.begin() + static_cast<std::ptrdiff_t>(std::min(names.size(), kMost)));
    return names.size() > kMost ? fmt::format("{} and {} more", fmt::join(first, ", "), names.size() - kMost)
           : names.empty()      ? "none"
                                : joinNames(first);
}

/// -1: the mapping is not for that variant.
int materialFor(const tinygltf::Value& mapping, size_t variant) {
    if (!mapping.IsObject() || !mapping.Get("variants").IsArray()) { return -1; }
    const tinygltf::Value& variants = mapping.Get("variants");
    for (size_t i = 0; i < variants.ArrayLen(); ++i) {
        const tinygltf::Value& index = variants.Get(static_cast<int>(i));
        if (index.IsNumber() && index.GetNumberAsDouble() == static_cast<double>(variant)) {
            return indexOf(&mapping, "material");
        }
    }
    return -1;
}

}  // namespace

Result<std::optional<size_t>> chosenBy(const SceneParameters& parameters, std::string_view kind,
                                       const std::vector<std::string>& names, const GltfFile& file) {
    const std::string* wanted = findParameter(parameters, kind);
    if (wanted == nullptr) { return std::optional<size_t>(); }
    if (const auto found = indexIn(names, *wanted)) { return found; }
    const std::vector<std::string_view> known(names.begin(), names.end());
    return file.error(fmt::format("there is no {} \"{}\"{}; the file has {}", kind, *wanted,
                                  didYouMean(*wanted, known), listed(names)));
}

Status chooseVariant(GltfFile* file, const SceneParameters& parameters, std::string* note) {
    const std::vector<std::string> names = variantNames(file->model);
    const auto chosen = chosenBy(parameters, "variant", names, *file);
    if (!chosen) { return chosen.error(); }
    if (names.empty()) { return {}; }
    *note = fmt::format("materials have the variants {}; shown is {} (-D variant=)", listed(names),
                        *chosen ? names[**chosen] : "none of them");
    if (!*chosen) { return {}; }
    for (tinygltf::Mesh& mesh : file->model.meshes) {
        for (tinygltf::Primitive& primitive : mesh.primitives) {
            const auto* extension = extensionOf(primitive, kVariants);
            if (extension == nullptr || !extension->Get("mappings").IsArray()) { continue; }
            const tinygltf::Value& mappings = extension->Get("mappings");
            for (size_t i = 0; i < mappings.ArrayLen(); ++i) {
                const int material = materialFor(mappings.Get(static_cast<int>(i)), **chosen);
                if (material >= 0) { primitive.material = material; }
            }
        }
    }
    return {};
}

}  // namespace glint
