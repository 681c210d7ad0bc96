#include "cli/lsp/background.h"

#include <algorithm>

namespace af2::lsp {

WorkerThread::WorkerThread(std::function<void(Continuation)> deliver)
    : deliver_(std::move(deliver)), thread_([this] { run(); }) {}

WorkerThread::~WorkerThread() {
  {
    const std::lock_guard lock(mutex_);
    isStopping_ = true;
    waiting_.clear();
    if (isCancelled_) *isCancelled_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

bool WorkerThread::cancel(const std::string& key) {
  const std::lock_guard lock(mutex_);
  bool wasThere = std::erase_if(waiting_, [&](const Waiting& w) { return w.task.key == key; }) > 0;
  if (isCancelled_ && running_ == key) wasThere = !isCancelled_->exchange(true) || wasThere;
  return wasThere;
}

void WorkerThread::start(Task task) {
  cancel(task.key);
  {
    const std::lock_guard lock(mutex_);
    const auto due = Clock::now() + task.delay;
    waiting_.push_back({std::move(task), due});
  }
  changed_.notify_all();
}

std::vector<WorkerThread::Waiting>::iterator WorkerThread::next() {
  return std::ranges::min_element(waiting_, {}, &Waiting::due);
}

void WorkerThread::run() {
  std::unique_lock lock(mutex_);
  while (!isStopping_) {
    if (waiting_.empty()) {
      changed_.wait(lock);
      continue;
    }
    if (const auto due = next()->due; Clock::now() < due) {
      changed_.wait_until(lock, due);
      continue;
    }
    const Task task = std::move(next()->task);
    waiting_.erase(next());
    running_ = task.key;
    const auto isCancelled = std::make_shared<std::atomic<bool>>(false);
    isCancelled_ = isCancelled;
    lock.unlock();
    Continuation done = task.work(*isCancelled);
    // The receiver decides whether the result is still wanted: a cancellation may be on its way.
    deliver_([isCancelled, done = std::move(done)] {
      if (!*isCancelled && done) done();
    });
    lock.lock();
    if (isCancelled_ == isCancelled) isCancelled_.reset();
  }
}

}  // namespace af2::lsp
