// What stands around the image: the column of panels with its splitter, the status line, the help,
// the keys.
#pragma once

#include <string>

#include "viewer/window/dialogs.h"
#include "viewer/window/image_view.h"

namespace glint {

class Shell {
  public:
    /// Draws the whole window. Returns true while the user holds the camera or a control.
    bool draw(Workspace* workspace, const ImagePanes& panes);
    Dialogs dialogs;

  private:
    void handleKeys(Workspace* workspace);
    void drawSplitter(float x, float height, float* columnUnits) const;
    void drawColumn(Workspace* workspace, float x, float height);
    bool showsNotice(const Notice& notice);
    std::string imageText(const Workspace& workspace) const;
    void drawStatusLine(const Workspace& workspace, float y);
    void drawHelp();

    ImageView view_;
    bool panelsShown_ = true;
    bool helpShown_ = false;
    std::string lastNotice_;
    double noticeSince_ = 0.0;
};

}  // namespace glint
