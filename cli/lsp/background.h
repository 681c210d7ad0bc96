// Work that takes long, beside the conversation with the editor.
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

/// Done with the result, back in the conversation.
using Continuation = std::function<void()>;

struct Task {
  std::string key;  ///< a new task takes the place of an older one with its key
  std::chrono::milliseconds
      delay;  ///< rest before it begins, so that it waits for a pause in typing
  /// Runs beside everything else and must touch nothing that changes. Ends early, with any result,
  /// when it is cancelled.
  std::function<Continuation(const std::atomic<bool>& isCancelled)> work;
};

class Background {
 public:
  virtual ~Background() = default;
  virtual void start(Task task) = 0;
  /// The task will not run, or its result is dropped. Tells whether there was one.
  virtual bool cancel(const std::string& key) = 0;
};

/// One thread that does one task after the other.
class WorkerThread : public Background {
 public:
  /// `deliver` hands continuations over to the conversation; it is called from the thread.
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
