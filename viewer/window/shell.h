// What stands around the picture: the column of panels with its splitter, the status line, the help,
// the keys.
#pragma once

#include "viewer/window/image_view.h"

namespace glint {

class Shell {
  public:
    /// Draws the whole window. Returns true while the user holds the camera or a control.
    bool draw(ViewerModel* model, const ImageFiles& images);
    /// The keys asked for the end.
    bool quitWanted() const { return quitWanted_; }

  private:
    void handleKeys(ViewerModel* model);
    void drawSplitter(float x, float height);
    void drawColumn(ViewerModel* model, float x, float height);
    bool showsFileMessage(const ViewerModel& model);
    void drawStatusLine(const ViewerModel& model, float y);
    void drawHelp();

    ImageView view_;
    float columnUnits_ = 372.0f;  // 96-dpi units
    bool panelsShown_ = true;
    bool helpShown_ = false;
    bool quitWanted_ = false;
    std::string lastMessage_;
    double messageSince_ = 0.0;
};

}  // namespace glint
