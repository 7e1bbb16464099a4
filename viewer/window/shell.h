// What stands around the image: the column of panels with its splitter, the status line, and what keys do.
#pragma once

#include <string>

#include "viewer/window/dialogs.h"
#include "viewer/window/image_view.h"
#include "viewer/window/key_help.h"

namespace glint {

class Shell {
  public:
    /// Draws the whole window. Returns true while the user holds the camera or a control.
    bool draw(Workspace* workspace, const ImagePanes& panes);
    Dialogs dialogs;

  private:
    void handleKeys(Workspace* workspace);
    void handleSceneKeys(Workspace* workspace) const;
    void drawSplitter(float x, float height, float* columnUnits) const;
    void drawColumn(Workspace* workspace, float x, float height);
    bool showsNotice(const Notice& notice);
    std::string imageText(const Workspace& workspace) const;
    static std::string progressText(const Workspace& workspace);
    void drawStatusLine(const Workspace& workspace, float y);

    ImageView view_;
    bool panelsShown_ = true;
    KeyHelp help_;
    std::string lastNotice_;
    double noticeSince_ = 0.0;
};

}  // namespace glint
