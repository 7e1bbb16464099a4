#include "viewer/model/frame_series.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "engine/render/denoised_snapshot.h"
#include "viewer/model/film_files.h"

namespace glint {
namespace {

constexpr double kPollSeconds = 0.1;

std::string pathIn(const std::string& folder) {
    return (std::filesystem::path(folder) / "frame.png").string();
}

std::vector<Camera> viewsOf(const CameraBookmarks& bookmarks, const std::string& scene) {
    std::vector<Camera> views;
    for (const CameraBookmarks::Bookmark& each : bookmarks.of(scene)) {
        views.push_back(each.camera);
    }
    return views;
}

}  // namespace

struct FrameSeries::Job {
    std::shared_ptr<Work> work;
    CameraWay way;
    std::shared_ptr<const SceneDescription> scene;
    StopLimits limits;
    std::string path;
    DisplaySettings display;
    BackendMaker makeBackend;
    std::shared_ptr<const BuiltScene> built;  ///< null: none yet
    EditKind since = EditKind::Everything;    ///< what it may lack of `scene`
};

Status FrameSeries::render(const Job& job) {
    auto backend = job.makeBackend();
    if (!backend) { return backend.error(); }
    SessionOptions options{.previews = false, .snapshots = false};
    options.build = [&job](SceneEdit edit, const BuiltScene* previous, auto... rest) {
        if (previous == nullptr && job.built) {
            previous = job.built.get();
            edit.kinds = job.since;
        }
        return buildScene(edit, previous, rest...);
    };
    RenderSession session(std::move(*backend), options);
    session.request({.limits = job.limits,
                     .aovs = job.display.denoises ? kDenoisingAovs : 0,
                     .aovsEndWithFilm = true,
                     .standardError = job.display.denoises});
    for (uint32_t frame = 0; frame < job.way.images(); ++frame) {
        auto moved = std::make_shared<SceneDescription>(*job.scene);
        moved->camera = job.way.at(static_cast<float>(frame));
        const EditTicket ticket = session.post({moved, frame == 0 ? EditKind::Everything : EditKind::Camera});
        for (bool isDone = false; !isDone;) {
            (void)session.wait(kPollSeconds);
            const SessionStatus status = session.status();
            job.work->passes = status.ticket >= ticket ? status.passes : 0;
            if (job.work->isCancelled) { return {}; }
            if (status.state == SessionState::Failed) { return Error{status.error, {}}; }
            isDone = status.ticket >= ticket && status.state == SessionState::Finished;
        }
        const auto capture = session.capture();
        if (!capture) { return Error{"nothing was rendered", {}}; }
        if (Status saved = saveShownImage(numberedPath(job.path, frame + 1), *capture, job.display); !saved) {
            return saved;
        }
        ++job.work->done;
    }
    return {};
}

/// An exception would leave the live picture waiting.
Status FrameSeries::renderWithMemory(const Job& job) {
    try {
        return render(job);
    } catch (const std::exception&) {
        return Error{"not enough memory for pictures beside the live one", {}};
    }
}

CameraWay FrameSeries::way() const {
    const auto count = static_cast<uint32_t>(images);
    const SceneDescription& scene = *document_->posted();
    return isFlight ? CameraWay::flight(viewsOf(*bookmarks_, scene.path), count)
                    : CameraWay::turntable(scene.camera, count);
}

std::string FrameSeries::missing() const {
    if (isFlight && bookmarks_->of(document_->posted()->path).size() < 2) {
        return "A flight needs two bookmarks: Camera, Bookmark this view.";
    }
    return passes == 0 && seconds == 0.0f ? "Each picture needs a limit: passes or seconds." : "";
}

NumberedFiles FrameSeries::files() const {
    return {.path = pathIn(folder), .last = static_cast<uint32_t>(images)};
}

Status FrameSeries::checkFiles() const {
    std::error_code problem;
    std::filesystem::create_directories(folder, problem);
    if (problem) { return Error{fmt::format("cannot be made: {}", problem.message()), {folder, 0, 0, ""}}; }
    if (Status s = inputs_->checkCanWrite(numberedPath(pathIn(folder), 1)); !s) { return s; }
    return inputs_->checkCanWrite(files());
}

void FrameSeries::start(const DisplaySettings& display) {
    if (isRunning() || !document_->isOpen() || !missing().empty()) { return; }
    if (const Status free = checkFiles(); !free) { return notice_->tell(free, ""); }
    guard_->save(files().existing(), [this, display] { launch(display); });
}

void FrameSeries::launch(const DisplaySettings& display) {
    work_ = std::make_shared<Work>();
    work_->images = static_cast<uint32_t>(images);
    const auto job = std::make_shared<const Job>(Job{
        work_, way(), document_->posted(),
        StopLimits{.passes = static_cast<uint32_t>(passes), .renderSeconds = static_cast<double>(seconds)},
        pathIn(folder), display, makeBackend, render_->builtScene(),
        render_->awaitsImage() ? EditKind::Everything : EditKind::Camera});
    jobs_->start(
        [this, job]() -> JobQueue::Completion {
            const Status result = renderWithMemory(*job);
            return [this, job, result] {
                const uint32_t done = job->work->done;
                for (uint32_t i = 1; i <= done; ++i) {
                    guard_->mayReplace(numberedPath(job->path, i));
                }
                work_.reset();
                notice_->tell(result, fmt::format("{} pictures in {}{}", done,
                                                  std::filesystem::path(job->path).parent_path().string(),
                                                  job->work->isCancelled ? ", then cancelled" : ""));
            };
        },
        true);
}

void FrameSeries::cancel() {
    if (work_) { work_->isCancelled = true; }
}

std::string FrameSeries::progressText() const {
    return fmt::format("{} of {}, {} passes", std::min(work_->done + 1, work_->images), work_->images,
                       work_->passes.load());
}

float FrameSeries::progress() const {
    return static_cast<float>(work_->done) / static_cast<float>(work_->images);
}

const std::string& FrameSeries::obstacles() {
    const size_t views = isFlight ? bookmarks_->of(document_->posted()->path).size() : 0;
    const WayOf now{render_->builtScene(), images, views};
    if (now == obstaclesOf_ || render_->request.interacting) { return obstacles_; }
    obstaclesOf_ = now;
    const bool isKnown = now.built && missing().empty();
    obstacles_ = isKnown ? obstaclesOn(way(), *document_->posted(), *now.built) : "";
    return obstacles_;
}

}  // namespace glint
