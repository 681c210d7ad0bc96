// workspace/executeCommand: draw a rule, run its tests.
#include <algorithm>
#include <array>

#include "cli/lsp/pictures.h"
#include "cli/lsp/server.h"
#include "cli/lsp/uri.h"
#include "cli/program/text_files.h"
#include "cli/program/usage_error.h"
#include "dsl/run/rule_tests.h"
#include "engine/base/error.h"

namespace af2::lsp {
namespace {

const Json& argumentOf(const Json& params) {
  static const Json kNone = Json::object();
  if (!params.contains("arguments") || params["arguments"].empty()) return kNone;
  return params["arguments"].at(0);
}

[[noreturn]] void refuse(const std::string& why) {
  throw RequestError(ErrorCode::RequestFailed, why);
}

std::string firstError(const Analysis& analysis) {
  for (const dsl::Diagnostic& d : analysis.loaded.diagnostics)
    if (d.severity == dsl::Severity::Error)
      return "line " + std::to_string(d.place.line) + ": " + d.message;
  return "the file has no rules";
}

/// Titles of the compiled rules that belong to the rule or family with this title.
std::vector<std::string> titlesOf(const Analysis& analysis, const std::string& title) {
  std::vector<std::string> titles;
  for (const dsl::CompiledRule& rule : analysis.loaded.file->rules)
    if (rule.definition.name == title || dsl::isTitleOf(title, rule.definition.name))
      titles.push_back(rule.definition.name);
  return titles;
}

std::string drawn(const Analysis& analysis, const std::string& title) {
  const auto rules = analysis.soundRules();
  if (!rules || rules->rules().empty()) refuse("nothing can be drawn yet: " + firstError(analysis));
  if (title.empty()) return drawingOf(*rules);
  std::vector<std::string> sound;
  for (const std::string& t : titlesOf(analysis, title))
    if (std::ranges::find(rules->rules(), t, &AF2Rule::name) != rules->rules().end())
      sound.push_back(t);
  if (sound.empty())
    refuse("the rule \"" + title + "\" cannot be drawn yet: " + firstError(analysis));
  return drawingOf(*rules, sound);
}

std::string fileNameFor(const Document& document, const std::string& title) {
  std::string name = std::filesystem::path(document.path).stem().string() + "-" + title;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '-';
  return name + ".svg";
}

/// The editor opens the picture if it can; otherwise a message names the file.
void showFile(Session& session, const std::string& path) {
  if (session.client.showsFiles)
    session.ask("window/showDocument", {{"uri", uriOf(path)}, {"external", true}});
  else
    session.show(3, "drawn: " + path);
}

/// af2.draw {uri, rule?, path?}: returns {title, svg, path?}. Without `rule` all rules are drawn.
/// The picture is written to `path`, or otherwise to a file that the editor is asked to show,
/// unless the editor has said that it uses the returned picture.
Json draw(Session& session, const Json& argument) {
  const auto document = session.document(argument.at("uri").get<std::string>());
  const auto analysis = session.analysis(*document);
  const auto title = argument.value("rule", std::string());
  Json result{{"title", title.empty() ? "all rules" : title}, {"svg", drawn(*analysis, title)}};
  const bool isShown = !argument.contains("path") && !session.client.takesPictures;
  std::string path = argument.value("path", std::string());
  if (isShown) {
    std::error_code ignored;
    std::filesystem::create_directories(session.surroundings().drawings, ignored);
    path = (session.surroundings().drawings / fileNameFor(*document, title)).string();
  }
  if (path.empty()) return result;
  try {
    // Absolute, so that the name "-" cannot mean standard output, which carries the protocol.
    cli::writeText(std::filesystem::absolute(path).string(), result["svg"].get<std::string>());
  } catch (const cli::UsageError& error) {
    refuse(error.what());
  }
  result["path"] = path;
  if (isShown) showFile(session, path);
  return result;
}

// ---- tests --------------------------------------------------------------------------------------

struct TestRun {
  std::vector<dsl::TestResult> results;
  std::string fault;  ///< not empty: why they could not be run
};

TestRun runTests(const Analysis& analysis, const std::vector<std::string>& titles,
                 const std::atomic<bool>& isCancelled) {
  TestRun run;
  const auto isWanted = [&](const std::string& title) {
    return titles.empty() || std::ranges::find(titles, title) != titles.end();
  };
  run.fault = dsl::missingText(*analysis.loaded.file);
  if (!run.fault.empty()) return run;
  try {
    SingleStepper stepper(*analysis.loaded.rules);
    for (const dsl::CompiledTest& test : analysis.loaded.file->tests)
      if (isWanted(test.title) && !isCancelled)
        run.results.push_back(dsl::runTest(analysis.loaded, stepper, test));
    for (const dsl::CompiledProperty& property : analysis.loaded.file->properties)
      if (isWanted(property.title) && !isCancelled)
        run.results.push_back(dsl::runProperty(analysis.loaded, property));
  } catch (const std::exception& error) {
    run.fault = error.what();
  }
  return run;
}

Json jsonOf(const dsl::TestResult& result) {
  Json failures = Json::array();
  for (const dsl::TestFailure& f : result.failures)
    failures.push_back({{"line", f.place.line}, {"expected", f.expected}, {"got", f.got}});
  Json json{{"title", result.title},
            {"line", result.place.line},
            {"passed", result.passed()},
            {"rule", result.appliedRule},
            {"failures", std::move(failures)}};
  if (!result.explanation.empty()) json["explanation"] = result.explanation;
  return json;
}

Json failureDiagnostic(const TextMap& map, const dsl::SourceText& source,
                       const dsl::TestResult& result, const dsl::TestFailure& failure) {
  const dsl::Span span{source.offsetOf({failure.place.line, failure.place.column}),
                       source.offsetOf({failure.place.endLine, failure.place.endColumn})};
  return {{"range", map.range(span)},
          {"severity", 1},
          {"source", "af2 test"},
          {"message",
           "test \"" + result.title + "\": expected " + failure.expected + ", got " + failure.got}};
}

/// Failures are shown as diagnostics at the `expect` clauses until the text changes.
void keepFailures(const Session& session, Document& document, const Analysis& analysis,
                  const TestRun& run) {
  if (document.analysis.get() != &analysis) return;  // the text has changed
  const TextMap map = session.map(document.text);
  document.testFailures.clear();
  for (const dsl::TestResult& result : run.results)
    for (const dsl::TestFailure& failure : result.failures)
      document.testFailures.push_back(
          failureDiagnostic(map, analysis.main().source, result, failure));
  document.isChanged = true;
}

void report(Session& session, const Json& id, const std::shared_ptr<Document>& document,
            const Analysis& analysis, const TestRun& run) {
  if (!run.fault.empty()) return session.fail(id, ErrorCode::RequestFailed, run.fault);
  keepFailures(session, *document, analysis, run);
  Json results = Json::array();
  for (const dsl::TestResult& result : run.results) results.push_back(jsonOf(result));
  const auto passed = std::ranges::count_if(run.results, &dsl::TestResult::passed);
  const auto failed = static_cast<std::ptrdiff_t>(run.results.size()) - passed;
  std::string text = std::to_string(passed) + " passed, " + std::to_string(failed) + " failed";
  for (const dsl::TestResult& result : run.results)
    if (!result.passed()) text += "\n" + toText(result);
  session.show(failed > 0 ? 1 : 3, text);
  session.respond(id, {{"passed", passed}, {"failed", failed}, {"results", std::move(results)}});
}

/// af2.test {uri, titles?}: returns {passed, failed, results}. Runs in the background, so the
/// answer comes later.
void startTests(Session& session, const Json& id, const Json& argument) {
  const auto document = session.document(argument.at("uri").get<std::string>());
  const auto analysis = session.analysis(*document);
  if (!analysis->loaded.rules) refuse("the tests cannot be run yet: " + firstError(*analysis));
  const auto titles = argument.value("titles", std::vector<std::string>());
  session.commands().start({id.dump(), std::chrono::milliseconds(0),
                            [&session, id, document, analysis,
                             titles](const std::atomic<bool>& isCancelled) -> Continuation {
                              TestRun run = runTests(*analysis, titles, isCancelled);
                              return [&session, id, document, analysis, run = std::move(run)] {
                                report(session, id, document, *analysis, run);
                              };
                            }});
}

std::optional<Json> execute(Session& session, const Json& id, const Json& params) {
  const auto command = params.at("command").get<std::string>();
  if (command == "af2.draw") return draw(session, argumentOf(params));
  if (command == "af2.test") {
    startTests(session, id, argumentOf(params));
    return std::nullopt;
  }
  throw RequestError(ErrorCode::InvalidParams, "there is no command '" + command +
                                                   "'; the commands are af2.draw and af2.test");
}

constexpr std::array kCommandMethods{Method{"workspace/executeCommand", execute}};

}  // namespace

std::span<const Method> commandMethods() { return kCommandMethods; }

}  // namespace af2::lsp
