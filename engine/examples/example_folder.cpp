#include "engine/examples/example_folder.h"

#include <filesystem>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/image_io.h"
#include "engine/io/ply_writer.h"

namespace glint::examples {

ExampleFolder::ExampleFolder(std::string path, bool overwrite) : path_(std::move(path)) {
    std::error_code error;
    std::filesystem::create_directories(path_, error);
    if (error) {
        status_ = Error{fmt::format("'{}': the folder cannot be made: {}", path_, error.message()), {}};
    } else if (!overwrite && !std::filesystem::is_empty(path_, error)) {
        status_ = Error{
            fmt::format("'{}' has files in it: expected a new or empty folder, or --overwrite", path_), {}};
    }
}

std::string ExampleFolder::pathOf(std::string_view name) const {
    return (std::filesystem::path(path_) / name).string();
}

void ExampleFolder::mesh(std::string_view name, const MeshData& mesh) {
    if (!status_) { return; }
    triangles_ += mesh.triangleCount();
    status_ = savePly(pathOf(name), mesh);
}

void ExampleFolder::image(std::string_view name, const Image8& image) {
    if (status_) { status_ = savePng(pathOf(name), image); }
}

void ExampleFolder::text(std::string_view name, std::string_view text) {
    if (status_) { status_ = writeFileAtomically(pathOf(name), text); }
}

}  // namespace glint::examples
