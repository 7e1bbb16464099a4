#include "viewer/base/job_queue.h"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <thread>
#include <utility>
#include <vector>

#include "engine/base/log.h"

namespace glint {
namespace {

std::atomic<int> abandonableJobs{0};

}  // namespace

struct JobQueue::Shared {
    std::mutex mutex;
    std::condition_variable changed;
    std::vector<Completion> completions;
    int running = 0;
    int mustFinish = 0;
};

JobQueue::JobQueue() : shared_(std::make_shared<Shared>()) {}

JobQueue::~JobQueue() {
    std::unique_lock lock(shared_->mutex);
    shared_->changed.wait(lock, [this] { return shared_->mustFinish == 0; });
}

void JobQueue::start(Work work, bool mustFinish) {
    {
        const std::lock_guard lock(shared_->mutex);
        ++shared_->running;
        shared_->mustFinish += mustFinish;
    }
    abandonableJobs += !mustFinish;
    auto run = [shared = shared_, work = std::move(work), mustFinish] {
        Completion completion;
        try {
            completion = work();
        } catch (const std::bad_alloc&) {
            logError("not enough memory for a background job");
        } catch (const std::exception& problem) { logError("a background job stopped: {}", problem.what()); }
        {
            const std::lock_guard lock(shared->mutex);
            if (completion) { shared->completions.push_back(std::move(completion)); }
            --shared->running;
            shared->mustFinish -= mustFinish;
        }
        shared->changed.notify_all();
        abandonableJobs -= !mustFinish;
    };
    try {
        std::thread(run).detach();
    } catch (const std::exception&) {
        run();  // without memory for a thread, the window waits
    }
}

bool JobQueue::runCompletions() {
    std::vector<Completion> ready;
    {
        const std::lock_guard lock(shared_->mutex);
        ready.swap(shared_->completions);
    }
    for (const Completion& completion : ready) {
        completion();
    }
    return !ready.empty();
}

int JobQueue::running() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->running + static_cast<int>(shared_->completions.size());
}

bool JobQueue::anyAbandoned() { return abandonableJobs > 0; }

}  // namespace glint
