// The library with the server: the only file that uses httplib.
#include <httplib.h>
#include <sys/socket.h>

#include "cli/playground/http_server.h"

namespace af2::playground {
namespace {

/// A page has at most six requests under way.
constexpr std::size_t kThreads = 16;

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

void send(httplib::Response& response, const HttpReply& reply) {
  response.status = reply.status;
  response.set_content(reply.body, reply.type);
}

class LoopbackServer : public HttpServer {
 public:
  LoopbackServer(HttpHandler& handler, const HttpOptions& options) : handler_(handler) {
    http_.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    http_.set_keep_alive_max_count(1);  // else idle connections would hold threads
    http_.set_payload_max_length(options.mostBytes);
    http_.set_default_headers({options.headers.begin(), options.headers.end()});
    // By default httplib shares a port with other programs of the same user.
    http_.set_socket_options([](int socket) {
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    http_.set_pre_routing_handler([this](const auto& request, auto& response) {
      const auto refusal = handler_.refuse(headOf(request));
      if (!refusal) return httplib::Server::HandlerResponse::Unhandled;
      send(response, *refusal);
      return httplib::Server::HandlerResponse::Handled;
    });
    http_.set_error_handler([this](const httplib::Request&, httplib::Response& response) {
      if (response.body.empty()) send(response, handler_.complain(response.status));
    });
    const auto answer = [this](const httplib::Request& request, httplib::Response& response) {
      send(response, handler_.answer(headOf(request), QueryParameters(request), request.body));
    };
    http_.Get(".*", answer);
    http_.Post(".*", answer);
  }

  std::optional<int> bind(int port) override {
    constexpr const char* kLoopback = "127.0.0.1";
    if (port == 0)
      port = http_.bind_to_any_port(kLoopback);
    else if (!http_.bind_to_port(kLoopback, port))
      return std::nullopt;
    return port > 0 ? std::optional(port) : std::nullopt;
  }

  void listen() override { http_.listen_after_bind(); }
  void end() override { http_.stop(); }
  bool isRunning() const override { return http_.is_running(); }

 private:
  HttpHandler& handler_;
  httplib::Server http_;
};

}  // namespace
}  // namespace af2::playground

extern "C" __attribute__((visibility("default"))) const af2::playground::HttpModule*
af2HttpModule() {
  using namespace af2::playground;
  static const HttpModule module{
      AF2_VERSION,
      [](HttpHandler& handler, const HttpOptions& options) -> std::unique_ptr<HttpServer> {
        return std::make_unique<LoopbackServer>(handler, options);
      }};
  return &module;
}
