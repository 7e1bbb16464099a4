// The newest picture without its noise, made by a job: quickly while the render moves on, carefully once
// it rests.
//
// The denoised picture before stays until the next is there, so that neither the window nor the render waits.
#pragma once

#include <atomic>
#include <memory>

#include "engine/render/denoised_snapshot.h"
#include "viewer/base/job_queue.h"

namespace glint {

class DenoisedView {
  public:
    ~DenoisedView() { stop(); }

    /// Once a frame: of this picture (null: of none), which stays as it is when `rests`.
    void refresh(const std::shared_ptr<const FilmSnapshot>& wanted, bool rests);

    /// Null: there is none.
    const std::shared_ptr<const FilmSnapshot>& image() const { return image_; }
    /// The picture is of another edit than what was wanted last, or that rests and is not denoised yet.
    bool isBehind() const { return isBehind_; }

  private:
    struct Of {
        std::shared_ptr<const FilmSnapshot> snapshot;
        DenoiseQuality quality = DenoiseQuality::Quick;

        bool operator==(const Of&) const = default;
    };
    void start(const Of& of);
    void stop() {
        if (stopsWork_) { *stopsWork_ = true; }
    }

    JobQueue jobs_;
    std::shared_ptr<std::atomic<bool>> stopsWork_;  ///< of the job that is running; null: none is
    Of working_;                                    ///< what that is of
    Of made_;                                       ///< what the picture is of
    std::shared_ptr<const FilmSnapshot> image_;
    bool isBehind_ = false;
};

}  // namespace glint
