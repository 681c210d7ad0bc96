#include "cli/lsp/server.h"

#include <algorithm>
#include <array>
#include <exception>

namespace af2::lsp {
namespace {

const Method* findMethod(std::string_view name) {
  for (const auto table : {navigationMethods(), hoverMethods(), signatureMethods(),
                           completionMethods(), renameMethods(), formattingMethods(),
                           outlineMethods(), lensMethods(), commandMethods(), actionMethods()}) {
    const auto found = std::ranges::find(table, name, &Method::name);
    if (found != table.end()) return &*found;
  }
  return nullptr;
}

const Json kNull = nullptr;

bool isId(const Json& id) { return id.is_string() || id.is_number_integer(); }

}  // namespace

void Server::take(const Incoming& incoming) {
  if (!incoming.fault.empty()) return session_.fail(nullptr, ErrorCode::ParseError, incoming.fault);
  takeMessage(incoming.message);
}

void Server::takeMessage(const Json& message) {
  if (!message.is_object())
    return session_.fail(nullptr, ErrorCode::InvalidRequest, "a message must be a JSON object");
  const Json& id = message.contains("id") ? message["id"] : kNull;
  if (!message.contains("method")) {
    // An answer to one of our requests.
    if (message.contains("result") || message.contains("error")) return;
    return session_.fail(isId(id) ? id : kNull, ErrorCode::InvalidRequest,
                         "the message has no method");
  }
  if (!message["method"].is_string())
    return session_.fail(isId(id) ? id : kNull, ErrorCode::InvalidRequest,
                         "the method is not a string");
  const auto method = message["method"].get<std::string>();
  const Json& params = message.contains("params") ? message["params"] : kNull;
  if (!message.contains("id")) return takeNotification(method, params);
  if (!isId(id))
    return session_.fail(nullptr, ErrorCode::InvalidRequest,
                         "the id is neither a number nor a string");
  takeRequest(method, id, params);
}

void Server::takeRequest(const std::string& method, const Json& id, const Json& params) {
  try {
    if (auto result = answer(method, id, params)) session_.respond(id, std::move(*result));
  } catch (const RequestError& error) {
    session_.fail(id, error.code(), error.what());
  } catch (const Json::exception& error) {
    session_.fail(id, ErrorCode::InvalidParams,
                  "the parameters of " + method + " are invalid: " + error.what());
  } catch (const std::exception& error) {
    session_.fail(id, ErrorCode::InternalError, error.what());
  }
}

std::optional<Json> Server::answer(const std::string& method, const Json& id, const Json& params) {
  if (state_ == State::ShutDown)
    throw RequestError(ErrorCode::InvalidRequest, "the server has been shut down");
  if (method == "initialize") {
    if (state_ == State::Ready)
      throw RequestError(ErrorCode::InvalidRequest, "the server is already initialized");
    Json result = initialize(session_, params);
    state_ = State::Ready;
    return result;
  }
  if (state_ == State::Fresh)
    throw RequestError(ErrorCode::ServerNotInitialized, "send initialize first");
  if (method == "shutdown") {
    state_ = State::ShutDown;
    return Json(nullptr);
  }
  const Method* known = findMethod(method);
  if (!known) throw RequestError(ErrorCode::MethodNotFound, "there is no method '" + method + "'");
  return known->answer(session_, id, params);
}

void Server::takeNotification(const std::string& method, const Json& params) {
  if (method == "exit") {
    exitCode_ = state_ == State::ShutDown ? 0 : 1;
    return;
  }
  if (state_ != State::Ready) return;
  try {
    if (method == "initialized") return afterInitialized(session_);
    const auto table = documentNotifications();
    const auto known = std::ranges::find(table, method, &Notification::name);
    if (known != table.end()) return known->take(session_, params);
    // The protocol requires that unknown notifications are ignored.
  } catch (const std::exception& error) {
    session_.notify("window/logMessage", {{"type", 1}, {"message", method + ": " + error.what()}});
  }
}

void Server::rest() {
  if (state_ == State::Ready) sendDiagnostics(session_);
}

void Server::hangUp() {
  if (!exitCode_) exitCode_ = state_ == State::ShutDown ? 0 : 1;
}

}  // namespace af2::lsp
