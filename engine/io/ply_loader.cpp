#include "engine/io/ply_loader.h"

#include <algorithm>

#include "engine/io/named_files.h"
#include "engine/io/plain_text.h"
#include "engine/io/ply_body.h"
#include "engine/io/ply_source.h"
#include "engine/io/vertex_colors.h"

namespace glint {
namespace {

Error noFaces(const PlyHeader& header, size_t vertices, const std::string& path) {
    std::string others;
    for (const PlyElement& element : header.elements) {
        const bool joinsVertices =
            element.is({"edge", "edges"}) || std::ranges::any_of(element.properties, &PlyProperty::isList);
        if (joinsVertices && element.count > 0 && !element.is({"vertex", "vertices", "face", "faces"})) {
            others +=
                fmt::format("{} {} \"{}\"", others.empty() ? "; it has" : ",", element.count, element.name);
        }
    }
    const std::string_view cloud = vertices > 0 && others.empty() ? ": a point cloud" : "";
    return Error{fmt::format("the file has no faces ({} vertices){}{}; expected a mesh (an element face with "
                             "vertex_indices)",
                             vertices, cloud, others),
                 {.file = path}};
}

template <class Source>
Result<MeshFile> readBody(const PlyHeader& header, Source source, const std::string& path) {
    PlyBody<Source> body(header, std::move(source));
    if (Status read = body.run(); !read) { return read.error(); }
    if (body.mesh.empty()) { return noFaces(header, body.mesh.vertices.positions.size(), path); }
    MeshFile file = body.mesh.finish(header.textures);
    file.warnings = body.remarks().lines();
    const bool hasUvs =
        std::ranges::any_of(file.parts, [](const MeshPart& part) { return !part.mesh->uvs.empty(); });
    if (!header.textures.empty() && !hasUvs) {
        file.warnings.push_back(fmt::format("{}: an image without texture coordinates is left out: \"{}\"",
                                            path, header.textures[0].substr(0, 80)));
    }
    decodeVertexColors(path, &file, body.hasWholeColors);
    return file;
}

}  // namespace

PlySlots plySlotsOf(const PlyElement& vertex) {
    return {vertex.find({"x"}),
            vertex.find({"y"}),
            vertex.find({"z"}),
            vertex.find({"nx", "normal_x", "normalx"}),
            vertex.find({"ny", "normal_y", "normaly"}),
            vertex.find({"nz", "normal_z", "normalz"}),
            vertex.find({"u", "s", "texture_u", "texture_s", "tu", "texcoord_u"}),
            vertex.find({"v", "t", "texture_v", "texture_t", "tv", "texcoord_v"}),
            vertex.find({"red", "r", "diffuse_red"}),
            vertex.find({"green", "g", "diffuse_green"}),
            vertex.find({"blue", "b", "diffuse_blue"})};
}

const char* nameOf(PlySlot slot) {
    static constexpr std::array<const char*, kPlySlots> kNames{"x", "y", "z",   "nx",    "ny",  "nz",
                                                               "u", "v", "red", "green", "blue"};
    return kNames[slot];
}

PlyFaceProperties plyFacePropertiesOf(const PlyElement& face) {
    const auto find = [&face](bool isList, std::initializer_list<std::string_view> names) {
        const int index = face.find(names);
        return index >= 0 && face.properties[static_cast<size_t>(index)].isList == isList ? index : -1;
    };
    PlyFaceProperties which{
        find(true, {"vertex_indices", "vertex_index", "vertex_indexes", "vertexindices", "vertexindex",
                    "vertices", "indices"}),
        find(true, {"texcoord", "texcoords", "texture_coordinates"}),
        find(false, {"texnumber", "texture_index"}),
        find(true, {"color", "colors", "colour"}),
        {find(false, {"red", "r", "diffuse_red"}), find(false, {"green", "g", "diffuse_green"}),
         find(false, {"blue", "b", "diffuse_blue"})}};
    if (which.cornerColors >= 0) { which.rgb[0] = -1; }
    return which;
}

Result<MeshFile> parsePly(const std::string& bytes, const std::string& path) {
    // A binary body is no text, and the header before it may have any line ends.
    const size_t head = sizeOfPlyHeader(bytes);
    std::optional<PlainText> plain = asPlainText(bytes.substr(0, head));
    const Result<PlyHeader> header = parsePlyHeader(plain ? plain->text : bytes, path);
    if (!header) { return header.error(); }
    Result<MeshFile> file = Error{};
    if (header->format == PlyFormat::Ascii) {
        if (head < bytes.size()) { plain = asPlainText(bytes); }
        const std::string& text = plain ? plain->text : bytes;
        file = readBody(*header, PlyTextSource(text, path, *header), path);
    } else {
        const bool isBigEndian = header->format == PlyFormat::BinaryBigEndian;
        file = readBody(*header, PlyBinarySource(bytes, path, header->bodyOffset, isBigEndian), path);
    }
    if (!file) { return file; }
    file->warnings.insert(file->warnings.begin(), header->warnings.begin(), header->warnings.end());
    if (plain) { file->warnings.push_back(fmt::format("{}: {}", path, plain->repaired)); }
    return file;
}

Status readPlyMaterials(const std::string& path, MeshFile* file) {
    NamedFiles files;
    Remarks remarks;
    const auto place = [&] { return path; };
    for (MeshPart& part : file->parts) {
        Material material = unknownMaterial(part);
        if (!part.materialName.empty()) {
            if (const auto found = files.find(part.materialName, path); found) {
                if (found->isGuess) {
                    remarks.add("images are taken for others of a like name", place, part.materialName);
                }
                material.color.texture = static_cast<int>(file->textures.size());
                Texture& texture = file->textures.emplace_back();
                texture.name = part.materialName;
                texture.image.source = FileSource{found->path};
            } else {
                remarks.add(part.mesh->colors.empty()
                                ? "images are missing; a grey takes their place"
                                : "images are missing; the vertices' colours take their place",
                            place, part.materialName);
            }
        }
        part.material = static_cast<int>(file->materials.size());
        file->materials.push_back(std::move(material));
    }
    const std::vector<std::string> lines = remarks.lines();
    file->warnings.insert(file->warnings.end(), lines.begin(), lines.end());
    return {};
}

}  // namespace glint
