// How the window is arranged, as the next one begins: the column's width, and which panels are open.
#pragma once

#include <map>
#include <string>

namespace glint {

struct WindowLayout {
    float columnUnits = 372.0f;        ///< at 96 dpi
    std::map<std::string, bool> open;  ///< panels, by their titles; those that are missing are as they begin
    std::string goTo;                  ///< the panel that is to be opened and scrolled to; "": none
    bool walks = false;                ///< the keyboard is to go to the panels

    /// Reads what an earlier window left in `file`, and writes there from then on. Where it cannot, the
    /// arrangement lasts as long as the window.
    void begin(const std::string& file);
    /// At the end.
    void save() const;

  private:
    std::string file_;
};

}  // namespace glint
