// Cameras that are kept by name for a scene, in this session and later ones.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/camera.h"

namespace glint {

class CameraBookmarks {
  public:
    struct Bookmark {
        std::string scene;  ///< its file's absolute path
        std::string name;
        Camera camera;
    };

    /// Reads what earlier sessions kept in `file`, and keeps it there from now on. Where it cannot be
    /// written, they last as long as the session.
    void begin(const std::string& file);
    /// Calls it "View N".
    void add(const std::string& scenePath, const Camera& camera);
    void remove(const Bookmark& bookmark);
    /// Of this scene, oldest first.
    std::vector<Bookmark> of(const std::string& scenePath) const;

  private:
    void save() const;

    std::string file_;
    std::vector<Bookmark> all_;
};

}  // namespace glint
