// The list of what mouse and keys do, over the window, where keys can be changed.
#pragma once

#include <optional>
#include <string>

#include "viewer/model/key_map.h"

namespace glint {

class KeyHelp {
  public:
    void toggle() { isShown_ = !isShown_; }
    /// By Esc: first the key that is awaited, then the list.
    void close(KeyMap* keys);
    void draw(KeyMap* keys);

  private:
    void takeKey(KeyMap* keys);
    void drawRows(KeyMap* keys);
    void drawKeyRow(KeyMap* keys, const KeyActionInfo& info);
    void drawButtons(KeyMap* keys);

    bool isShown_ = false;
    std::optional<KeyChord> typed_;  ///< that is still down
    std::string note_;
};

}  // namespace glint
