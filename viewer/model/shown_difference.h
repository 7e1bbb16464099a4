// What two pictures of one size differ by, as colours: made by a job, since FLIP takes its time.
//
// Lives on the UI thread; nothing here draws.
#pragma once

#include <memory>
#include <string>

#include "viewer/base/job_queue.h"
#include "viewer/model/display_settings.h"
#include "viewer/model/false_colors.h"

namespace glint {

class ShownDifference {
  public:
    struct Wanted {
        CompareView view = CompareView::Wipe;  ///< of those that are no difference, nothing is made
        std::shared_ptr<const FilmSnapshot> left;
        std::shared_ptr<const FilmSnapshot> right;
        float exposureStops = 0.0f;  ///< for FLIP
        bool operator==(const Wanted&) const = default;
    };
    struct Made {
        Wanted of;
        std::vector<uint8_t> rgba;  ///< 4 bytes a pixel; empty: the pictures cannot be compared
        MapScale scale;
        double mean = 0.0;  ///< of FLIP, or of left - right in luminance
    };

    /// Once a frame. While a job runs, what was made before stays.
    void refresh(const Wanted& wanted);
    /// Null before the first.
    const std::shared_ptr<const Made>& made() const { return made_; }
    bool isBehind() const { return isMaking_ || isWaiting_; }

  private:
    JobQueue jobs_;
    Wanted wanted_;
    bool isMaking_ = false;
    bool isWaiting_ = false;  ///< for the job of an older wish
    std::shared_ptr<const Made> made_;
};

/// Both views' colours. `wanted` has two pictures; of different sizes, nothing is made.
ShownDifference::Made makeDifference(const ShownDifference::Wanted& wanted);

}  // namespace glint
