// How far the image is from the truth, of each integrator: by its own estimate, and against a
// loaded reference.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "viewer/model/notice.h"
#include "viewer/model/reference_errors.h"
#include "viewer/model/reference_fit.h"
#include "viewer/model/render_control.h"
#include "viewer/model/scene_document.h"

namespace glint {

class ConvergenceWatch {
  public:
    ConvergenceWatch(const SceneDocument* document, RenderControl* render, Notice* notice);

    /// Once a frame, after the render's refresh().
    void refresh();
    /// Another file was opened: its curves are not to be compared with those of the one before.
    void forget();

    /// The estimate of the error so far, whether this integrator is shown or not. Never null.
    const std::shared_ptr<const ConvergenceCurve>& curve(IntegratorKind kind) const {
        return films_[static_cast<size_t>(kind)].curve;
    }
    /// That of the film before the last restart, if it had more than a few points. Never null.
    const std::shared_ptr<const ConvergenceCurve>& curveBefore(IntegratorKind kind) const {
        return films_[static_cast<size_t>(kind)].before;
    }
    /// Those whose error is of interest, in the table's order: the scene's own, what it is compared with by
    /// default, and all that have rendered since the scene was opened.
    std::vector<IntegratorKind> integrators() const;

    /// The reference where errors may be measured against it: it has the image's size, and shows the scene as
    /// it is now (or the user vouches for it). Null otherwise, and without one.
    std::shared_ptr<const LoadedReference> usableReference() const;

    ReferenceErrors reference;
    ReferenceFit fit;
    std::string referencePath;
    ReferenceMetric metric = ReferenceMetric::PictureError;
    double targetError = 0.01;  ///< relative; the stop limit takes its place while there is one

  private:
    void takeCurve(IntegratorKind kind);
    void tellOfReference();

    struct IntegratorFilms {
        std::shared_ptr<const ConvergenceCurve> curve;
        std::shared_ptr<const ConvergenceCurve> before;
    };

    const SceneDocument* document_;
    RenderControl* render_;
    Notice* notice_;
    std::array<IntegratorFilms, kIntegratorTable.size()> films_;
    bool isAnotherScene_ = false;  ///< the curves may still be of the one before
};

}  // namespace glint
