// Questions over the picture: before a file is replaced, before unsaved edits are lost, and what becomes of a
// session that did not come to its end. The render goes on meanwhile.
#pragma once

#include "viewer/model/workspace.h"

namespace glint {

class Dialogs {
  public:
    void draw(Workspace* workspace);

    /// The window is to be closed: the user is asked where there are unsaved edits, or pictures are rendered.
    void askToClose(const Workspace& workspace);
    /// Nothing speaks against it any more.
    bool mustClose(const SceneDocument& document) const;

  private:
    void drawOverwrite(OverwriteGuard* guard) const;
    void drawClose(Workspace* workspace);
    void drawEndOfSeries(const FrameSeries& frames);
    void drawRecovery(Workspace* workspace) const;
    void drawBrowser(FileDialog* dialog) const;

    bool asksToClose_ = false;
    bool isDecided_ = false;
    bool isSaving_ = false;  ///< closes when it is done
};

}  // namespace glint
