#include "cli/lsp/serve.h"

#include <deque>
#include <functional>
#include <thread>

#include "cli/lsp/server.h"

namespace af2::lsp {
namespace {

/// The next event: a message, a finished background task, or the end.
struct Event {
  std::optional<Incoming> incoming;
  Continuation done;
  bool isCancelled = false;  ///< to be answered with an error
};

bool isMethod(const Json& message, const char* method) {
  return message.is_object() && message.contains("method") && message["method"] == method;
}

class EventQueue {
 public:
  void push(Event event) {
    {
      const std::lock_guard lock(mutex_);
      events_.push_back(std::move(event));
    }
    changed_.notify_one();
  }

  bool isEmpty() {
    const std::lock_guard lock(mutex_);
    return events_.empty();
  }

  Event pop() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !events_.empty(); });
    Event event = std::move(events_.front());
    events_.pop_front();
    return event;
  }

  /// Marks a request that has not been processed yet.
  void cancel(const Json& id) {
    const std::lock_guard lock(mutex_);
    for (Event& event : events_) {
      const bool isIt = event.incoming && event.incoming->message.is_object() &&
                        event.incoming->message.contains("method") &&
                        event.incoming->message.contains("id") &&
                        event.incoming->message["id"] == id;
      event.isCancelled = event.isCancelled || isIt;
    }
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Event> events_;
};

/// Reads ahead, so that a cancellation overtakes earlier requests.
void readAll(std::istream& in, EventQueue& queue) {
  while (auto incoming = readMessage(in)) {
    const Json& message = incoming->message;
    if (isMethod(message, "$/cancelRequest") && message.contains("params") &&
        message["params"].is_object() && message["params"].contains("id"))
      queue.cancel(message["params"]["id"]);
    const bool isLast = isMethod(message, "exit");
    queue.push({std::move(incoming), nullptr, false});
    if (isLast) return;
  }
  queue.push({});
}

void handle(Event event, Session& session, Server& server) {
  if (event.done) return event.done();
  if (!event.incoming) return server.hangUp();
  if (event.isCancelled)
    return session.fail(event.incoming->message["id"], ErrorCode::RequestCancelled,
                        "the request was cancelled");
  server.take(*event.incoming);
}

}  // namespace

int serve(std::istream& in, std::ostream& out, const Surroundings& surroundings) {
  EventQueue queue;
  const auto deliver = [&queue](Continuation done) { queue.push({{}, std::move(done), false}); };
  WorkerThread checks(deliver), commands(deliver);
  Session session(
      surroundings, [&out](const Json& m) { writeMessage(out, m); }, checks, commands);
  Server server(session);
  std::thread reader([&] { readAll(in, queue); });
  while (!server.exitCode()) {
    if (queue.isEmpty()) server.rest();
    handle(queue.pop(), session, server);
  }
  reader.join();
  return *server.exitCode();
}

}  // namespace af2::lsp
