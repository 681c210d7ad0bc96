// Long-running work in a thread beside the conversation with the editor.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace af2::lsp {

/// Called with the result in the thread of the conversation.
using Continuation = std::function<void()>;

struct Task {
  std::string key;  ///< a new task replaces an older one with the same key
  std::chrono::milliseconds
      delay;  ///< rest before it begins, so that it waits for a pause in typing
  /// Runs in parallel with everything else, so it must not touch mutable data. If it is cancelled,
  /// it returns early with any result.
  std::function<Continuation(const std::atomic<bool>& isCancelled)> work;
};

class Background {
 public:
  virtual ~Background() = default;
  virtual void start(Task task) = 0;
  /// Removes the task or drops its result. Returns whether there was one.
  virtual bool cancel(const std::string& key) = 0;
};

/// One thread that runs one task after the other.
class WorkerThread : public Background {
 public:
  /// `deliver` passes continuations to the conversation; it is called from the worker thread.
  explicit WorkerThread(std::function<void(Continuation)> deliver);
  ~WorkerThread() override;
  WorkerThread(const WorkerThread&) = delete;
  WorkerThread& operator=(const WorkerThread&) = delete;

  void start(Task task) override;
  bool cancel(const std::string& key) override;

 private:
  using Clock = std::chrono::steady_clock;
  struct Waiting {
    Task task;
    Clock::time_point due;
  };

  void run();
  std::vector<Waiting>::iterator next();

  std::function<void(Continuation)> deliver_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Waiting> waiting_;
  std::string running_;
  std::shared_ptr<std::atomic<bool>> isCancelled_;
  bool isStopping_ = false;
  std::thread thread_;
};

}  // namespace af2::lsp
