#include "viewer/model/fault_finder.h"

#include <future>
#include <memory>

#include <fmt/format.h>

namespace glint {

void FaultFinder::find() {
    auto future = std::make_shared<std::future<std::optional<SessionCapture>>>(render_->captureLater());
    jobs_->start(
        [this, future]() -> JobQueue::Completion {
            const std::optional<SessionCapture> capture = future->get();
            std::string line;
            if (capture && !capture->film.faults().empty()) {
                const FaultRecord& first = capture->film.faults().front();
                line = fmt::format("glint render \"{}\" --pixel {},{} --pass {}", capture->scene->path,
                                   first.x, first.y, first.pass);
            }
            return [this, line] { replayCommand_ = line; };
        },
        false);
}

}  // namespace glint
