#include "viewer/model/window_layout.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"

namespace glint {

void WindowLayout::begin(const std::string& file) {
    file_ = file;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string verb;
        std::string rest;
        words >> verb >> std::ws;
        std::getline(words, rest);
        if (verb == "column") {
            const float units = std::strtof(rest.c_str(), nullptr);
            if (std::isfinite(units) && units > 0.0f) { columnUnits = units; }
        } else if (verb == "open" || verb == "closed") {
            open[rest] = verb == "open";
        }
    }
}

void WindowLayout::save() const {
    if (file_.empty()) { return; }
    std::string text = fmt::format("column {:.1f}\n", columnUnits);
    for (const auto& [title, isOpen] : open) {
        text += fmt::format("{} {}\n", isOpen ? "open" : "closed", title);
    }
    std::error_code problem;
    std::filesystem::create_directories(std::filesystem::path(file_).parent_path(), problem);
    (void)writeFileAtomically(file_, text);  // a comfort, and no reason for a message
}

}  // namespace glint
