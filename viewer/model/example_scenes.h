// The scenes that come with the program, for an empty window.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viewer/base/job_queue.h"
#include "viewer/model/thumbnail.h"

namespace glint {

struct ExampleScene {
    std::string path;
    std::string title;      ///< the scene's own, or its file's name
    Thumbnail thumbnail{};  ///< no pixels: there is none
};

/// The folder of the examples: beside the program as it is installed, or as it is built; nothing where there
/// is none.
std::optional<std::string> examplesFolder();

/// Those of the folder in the order of their names, with `../assets/scenes/NAME.jpg` where it can be read.
std::vector<ExampleScene> listExamples(const std::string& folder);

class Examples {
  public:
    /// Begins to list them, once, in the background.
    void list(JobQueue* jobs);
    std::vector<ExampleScene> scenes;

  private:
    bool isAsked_ = false;
};

}  // namespace glint
