// The folder that an example scene is written into: its meshes, images and the scene itself.
#pragma once

#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/scene/image.h"
#include "engine/scene/mesh_data.h"

namespace glint::examples {

/// Files are written as they come. After the first error nothing more is.
class ExampleFolder {
  public:
    /// Makes the folder where it is missing. Error: it has files in it, unless `overwrite`.
    ExampleFolder(std::string path, bool overwrite);

    void mesh(std::string_view name, const MeshData& mesh);
    void image(std::string_view name, const Image8& image);
    void text(std::string_view name, std::string_view text);

    uint64_t triangles() const { return triangles_; }
    const Status& status() const { return status_; }

  private:
    std::string pathOf(std::string_view name) const;

    std::string path_;
    uint64_t triangles_ = 0;
    Status status_;
};

}  // namespace glint::examples
