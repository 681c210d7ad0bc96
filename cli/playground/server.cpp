#include "cli/playground/server.h"

#include <fmt/core.h>
#include <httplib.h>
#include <sys/socket.h>

#include <thread>

#include "cli/playground/answers.h"
#include "cli/playground/assets.h"
#include "cli/playground/guard.h"
#include "engine/base/error.h"

namespace af2::playground {
namespace {

/// A page has at most six requests under way.
constexpr std::size_t kThreads = 16;

/// The page needs nothing but its own files; CodeMirror makes style sheets.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src blob: data:; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'";

class QueryParameters : public Parameters {
 public:
  explicit QueryParameters(const httplib::Request& request) : request_(request) {}
  std::string operator[](const char* name) const override { return request_.get_param_value(name); }

 private:
  const httplib::Request& request_;
};

RequestHead headOf(const httplib::Request& request) {
  return {request.method,
          request.path,
          request.get_header_value("Host"),
          request.get_header_value("Origin"),
          request.get_header_value("Content-Type"),
          request.has_header("Transfer-Encoding") || request.has_header("Content-Encoding")};
}

/// The type has a parameter, so that httplib does not compress what goes no way.
void reply(httplib::Response& response, const Json& json) {
  response.set_content(json.dump(-1, ' ', false, Json::error_handler_t::replace),
                       "application/json; charset=utf-8");
}

void complain(httplib::Response& response, int status, const std::string& reason) {
  response.status = status;
  response.set_content(reason + "\n", "text/plain; charset=utf-8");
}

void complainOfException(httplib::Response& response, const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const BadRequest& error) {
    complain(response, 400, error.what());
  } catch (const InputError& error) {
    complain(response, 409, error.what());
  } catch (const std::exception& error) {
    complain(response, 500, error.what());
  }
}

/// What httplib refuses by itself.
void complainOfStatus(httplib::Response& response) {
  if (!response.body.empty()) return;
  const char* reason = "The request cannot be read.";
  if (response.status == 404) reason = "There is no such page.";
  if (response.status == 413) reason = "The text is longer than 8 MiB, which no rule file may be.";
  complain(response, response.status, reason);
}

}  // namespace

class Server::Connections {
 public:
  explicit Connections(ServerOptions options)
      : answers_(std::move(options.surroundings), RuleFile(options.file), options.watches) {
    const std::string token = newToken();
    configure();
    const int port = bind(options.port);
    guard_ = std::make_unique<Guard>(token, port);
    address_ = fmt::format("http://127.0.0.1:{}/{}/", port, token);
    addRoutes("/" + token + "/");
  }

  const std::string& address() const { return address_; }

  void serve() {
    if (!isOver_) http_.listen_after_bind();
    isOver_ = true;
  }

  void end() {
    const bool wasOver = isOver_.exchange(true);
    answers_.end();
    // httplib cannot be stopped before it listens.
    for (int i = 0; !wasOver && !http_.is_running() && i < 200; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    http_.stop();
  }

 private:
  using Answer = Json (Answers::*)(const std::string&, const Parameters&);

  void configure() {
    http_.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    http_.set_keep_alive_max_count(1);  // else idle connections would hold threads
    http_.set_payload_max_length(maxTextBytes());
    http_.set_default_headers({{"Cache-Control", "no-store"},
                               {"X-Content-Type-Options", "nosniff"},
                               {"Referrer-Policy", "no-referrer"},
                               {"Content-Security-Policy", kPolicy}});
    // By default httplib shares a port with other programs of the same user.
    http_.set_socket_options([](int socket) {
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    http_.set_pre_routing_handler([this](const auto& request, auto& response) {
      const auto refusal = guard_->refuse(headOf(request));
      if (!refusal) return httplib::Server::HandlerResponse::Unhandled;
      complain(response, refusal->status, refusal->reason);
      return httplib::Server::HandlerResponse::Handled;
    });
    http_.set_exception_handler([](const auto&, auto& response, std::exception_ptr thrown) {
      complainOfException(response, thrown);
    });
    http_.set_error_handler(
        [](const httplib::Request&, httplib::Response& response) { complainOfStatus(response); });
  }

  int bind(int port) {
    constexpr const char* kLoopback = "127.0.0.1";
    if (port == 0) {
      port = http_.bind_to_any_port(kLoopback);
      if (port <= 0) throw InputError("no port of 127.0.0.1 is free");
    } else if (!http_.bind_to_port(kLoopback, port)) {
      throw InputError(fmt::format(
          "port {} of 127.0.0.1 cannot be used; without --port, a free one is taken", port));
    }
    return port;
  }

  void addRoutes(const std::string& base) {
    http_.Get(base + "file",
              [this](const auto&, auto& response) { reply(response, answers_.file()); });
    http_.Get(base + "state",
              [this](const auto&, auto& response) { reply(response, answers_.state()); });
    http_.Get(base + R"(([a-z./]*))", [](const httplib::Request& request, auto& response) {
      const std::string name = request.matches[1];
      const Asset asset = findAsset(name.empty() ? "page.html" : name);
      if (!asset.text.data()) return complain(response, 404, "There is no such page.");
      response.set_content(asset.text.data(), asset.text.size(), asset.type);
    });
    post(base + "diagnostics", &Answers::diagnostics);
    post(base + "checks", &Answers::checks);
    post(base + "rules", &Answers::rules);
    post(base + "tests", &Answers::tests);
    post(base + "mesh", &Answers::mesh);
    post(base + "completion", &Answers::completion);
    post(base + "hover", &Answers::hover);
    post(base + "save", &Answers::save);
  }

  void post(const std::string& path, Answer answer) {
    http_.Post(path, [this, answer](const httplib::Request& request, httplib::Response& response) {
      reply(response, (answers_.*answer)(request.body, QueryParameters(request)));
    });
  }

  Answers answers_;
  httplib::Server http_;
  std::unique_ptr<Guard> guard_;
  std::string address_;
  std::atomic<bool> isOver_ = false;
};

Server::Server(ServerOptions options)
    : connections_(std::make_unique<Connections>(std::move(options))) {}
Server::~Server() = default;
const std::string& Server::address() const { return connections_->address(); }
void Server::serve() { connections_->serve(); }
void Server::end() { connections_->end(); }

}  // namespace af2::playground
