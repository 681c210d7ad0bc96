#include "cli/playground/server.h"

#include <fmt/core.h>

#include <atomic>
#include <map>
#include <thread>

#include "cli/playground/answers.h"
#include "cli/playground/assets.h"
#include "cli/playground/guard.h"
#include "cli/playground/http_server.h"
#include "engine/base/error.h"

namespace af2::playground {
namespace {

constexpr const char* kNoPage = "There is no such page.";

/// The page needs nothing but its own files; CodeMirror makes style sheets.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src blob: data:; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'";

HttpReply replyWith(const Json& json) {
  return {200, json.dump(-1, ' ', false, Json::error_handler_t::replace),
          "application/json; charset=utf-8"};  // with a parameter httplib does not compress it
}

HttpReply complaint(int status, const std::string& reason) {
  return {status, reason + "\n", "text/plain; charset=utf-8"};
}

}  // namespace

class Server::Connections : public HttpHandler {
 public:
  explicit Connections(ServerOptions options)
      : answers_(std::move(options.surroundings), RuleFile(options.file), options.watches) {
    const std::string token = newToken();
    http_ = makeHttpServer(*this, {{{"Cache-Control", "no-store"},
                                    {"X-Content-Type-Options", "nosniff"},
                                    {"Referrer-Policy", "no-referrer"},
                                    {"Content-Security-Policy", kPolicy}},
                                   maxTextBytes()});
    const int port = bind(options.port);
    guard_ = std::make_unique<Guard>(token, port);
    base_ = "/" + token + "/";
    address_ = fmt::format("http://127.0.0.1:{}{}", port, base_);
  }

  const std::string& address() const { return address_; }

  void serve() {
    if (!isOver_) http_->listen();
    isOver_ = true;
  }

  void end() {
    const bool wasOver = isOver_.exchange(true);
    answers_.end();
    // The server cannot be stopped before it listens.
    for (int i = 0; !wasOver && !http_->isRunning() && i < 200; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    http_->end();
  }

  std::optional<HttpReply> refuse(const RequestHead& request) const override {
    const auto refusal = guard_->refuse(request);
    if (!refusal) return std::nullopt;
    return complaint(refusal->status, refusal->reason);
  }

  HttpReply answer(const RequestHead& request, const Parameters& parameters,
                   const std::string& body) override {
    try {
      const std::string name = request.path.substr(base_.size());
      return request.method == "POST" ? answerPost(name, parameters, body) : answerGet(name);
    } catch (const BadRequest& error) {
      return complaint(400, error.what());
    } catch (const InputError& error) {
      return complaint(409, error.what());
    } catch (const std::exception& error) {
      return complaint(500, error.what());
    }
  }

  HttpReply complain(int status) const override {
    const char* reason = "The request cannot be read.";
    if (status == 404) reason = kNoPage;
    if (status == 413) reason = "The text is longer than 8 MiB, which no rule file may be.";
    return complaint(status, reason);
  }

 private:
  using Answer = Json (Answers::*)(const std::string&, const Parameters&);

  int bind(int port) {
    if (const auto bound = http_->bind(port)) return *bound;
    if (port == 0) throw InputError("no port of 127.0.0.1 is free");
    throw InputError(fmt::format(
        "port {} of 127.0.0.1 cannot be used; without --port, a free one is taken", port));
  }

  HttpReply answerGet(const std::string& name) {
    if (name == "file") return replyWith(answers_.file());
    if (name == "state") return replyWith(answers_.state());
    const Asset asset = findAsset(name.empty() ? "page.html" : name);
    if (!asset.text.data()) return complaint(404, kNoPage);
    return {200, std::string(asset.text), asset.type};
  }

  HttpReply answerPost(const std::string& name, const Parameters& parameters,
                       const std::string& body) {
    static const std::map<std::string, Answer> kAnswers{{"diagnostics", &Answers::diagnostics},
                                                        {"checks", &Answers::checks},
                                                        {"rules", &Answers::rules},
                                                        {"tests", &Answers::tests},
                                                        {"mesh", &Answers::mesh},
                                                        {"completion", &Answers::completion},
                                                        {"hover", &Answers::hover},
                                                        {"save", &Answers::save}};
    const auto found = kAnswers.find(name);
    if (found == kAnswers.end()) return complaint(404, kNoPage);
    return replyWith((answers_.*found->second)(body, parameters));
  }

  Answers answers_;
  std::unique_ptr<HttpServer> http_;
  std::unique_ptr<Guard> guard_;
  std::string base_, address_;
  std::atomic<bool> isOver_ = false;
};

Server::Server(ServerOptions options)
    : connections_(std::make_unique<Connections>(std::move(options))) {}
Server::~Server() = default;
const std::string& Server::address() const { return connections_->address(); }
void Server::serve() { connections_->serve(); }
void Server::end() { connections_->end(); }

}  // namespace af2::playground
