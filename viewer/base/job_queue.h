// Work that must not hold up the window: loading scenes, saving pictures. Each job has a thread of its own;
// what it found out is handed to the UI thread at the next frame.
//
// A job captures values only, nothing by reference.
#pragma once

#include <functional>
#include <memory>

namespace glint {

class JobQueue {
  public:
    using Completion = std::function<void()>;
    using Work = std::function<Completion()>;

    JobQueue();
    /// Waits for jobs that must be finished (saves), not for the others (loads).
    ~JobQueue();
    JobQueue(const JobQueue&) = delete;
    JobQueue& operator=(const JobQueue&) = delete;

    /// `mustFinish`: half of it would be worse than waiting when the program ends.
    void start(Work work, bool mustFinish);
    /// Runs the completions of the jobs that ended. UI thread. True: there were some.
    bool runCompletions();
    int running() const;
    /// A job that need not finish is still running: the process has to end without waiting for its thread.
    static bool anyAbandoned();

  private:
    struct Shared;
    std::shared_ptr<Shared> shared_;
};

}  // namespace glint
