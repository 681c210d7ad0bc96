// Takes messages, finds who answers them, and keeps the order of the protocol.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "cli/lsp/session.h"

namespace af2::lsp {

/// Answers a request. `id` is for those that answer later, by session.respond: they return nothing.
using Answer = std::optional<Json> (*)(Session& session, const Json& id, const Json& params);

struct Method {
  std::string_view name;
  Answer answer;
};

struct Notification {
  std::string_view name;
  void (*take)(Session& session, const Json& params);
};

// One table for each family of requests, in a file of its own.
std::span<const Notification> documentNotifications();
std::span<const Method> navigationMethods();
std::span<const Method> hoverMethods();
std::span<const Method> signatureMethods();
std::span<const Method> completionMethods();
std::span<const Method> renameMethods();
std::span<const Method> formattingMethods();
std::span<const Method> outlineMethods();
std::span<const Method> lensMethods();
std::span<const Method> commandMethods();
std::span<const Method> actionMethods();

/// Sends what is wrong with the documents that have changed since it was last called, and starts
/// the slow checks of them in the background.
void sendDiagnostics(Session& session);

/// Fills `session.client` from the parameters of `initialize`, and says what the server can do.
Json initialize(Session& session, const Json& params);
/// What can only be asked for once the editor is ready.
void afterInitialized(Session& session);
/// The user's settings, as they come with `initialize` or when they change.
void applySettings(Client& client, const Json& settings);

class Server {
 public:
  explicit Server(Session& session) : session_(session) {}

  /// Answers one message; what could not be read is answered with an error.
  void take(const Incoming& incoming);
  /// Call it when no message waits.
  void rest();
  /// Set once the conversation is over.
  std::optional<int> exitCode() const { return exitCode_; }
  /// The editor went away.
  void hangUp();

 private:
  enum class State { Fresh, Ready, ShutDown };

  void takeMessage(const Json& message);
  void takeRequest(const std::string& method, const Json& id, const Json& params);
  void takeNotification(const std::string& method, const Json& params);
  std::optional<Json> answer(const std::string& method, const Json& id, const Json& params);

  Session& session_;
  State state_ = State::Fresh;
  std::optional<int> exitCode_;
};

}  // namespace af2::lsp
