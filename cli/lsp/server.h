// Receives messages, calls the functions that answer them, and enforces the order of the protocol.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "cli/lsp/session.h"

namespace af2::lsp {

/// Answers a request. Handlers that answer later return nothing and use `id` in session.respond.
using Answer = std::optional<Json> (*)(Session& session, const Json& id, const Json& params);

struct Method {
  std::string_view name;
  Answer answer;
};

struct Notification {
  std::string_view name;
  void (*take)(Session& session, const Json& params);
};

// One table for each family of requests, each in its own file.
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

/// Sends the diagnostics of all documents that changed since the last call, and starts their slow
/// checks in the background.
void sendDiagnostics(Session& session);

/// Fills `session.client` from the parameters of `initialize`; returns the server's capabilities.
Json initialize(Session& session, const Json& params);
/// Sends the requests that are allowed only after the editor is initialized.
void afterInitialized(Session& session);
/// Applies the user's settings, which come with `initialize` and when they change.
void applySettings(Client& client, const Json& settings);

class Server {
 public:
  explicit Server(Session& session) : session_(session) {}

  /// Answers one message; an unreadable message is answered with an error.
  void take(const Incoming& incoming);
  /// Call this when no message is waiting.
  void rest();
  /// Set once the conversation is over.
  std::optional<int> exitCode() const { return exitCode_; }
  /// The editor closed the connection.
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
