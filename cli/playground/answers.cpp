#include "cli/playground/answers.h"

#include <algorithm>
#include <charconv>
#include <set>

#include "cli/playground/choices_json.h"
#include "cli/playground/preview.h"
#include "cli/playground/sample_mesh.h"
#include "dsl/text/keywords.h"

namespace af2::playground {
namespace {

/// How long a run may take before it is stopped.
constexpr std::chrono::seconds kTimeLimit(15);

std::uint64_t numberIn(const Parameters& parameters, const char* name) {
  const std::string text = parameters[name];
  std::uint64_t number = 0;
  const auto end = text.data() + text.size();
  const auto [rest, fault] = std::from_chars(text.data(), end, number);
  if (fault != std::errc() || rest != end)
    throw BadRequest(std::string("The parameter '") + name + "' must be a whole number.");
  return number;
}

template <class Choice>
const Choice* chosen(std::span<const Choice> all, const Parameters& parameters, const char* name) {
  const auto found = std::ranges::find(all, parameters[name], &Choice::name);
  if (found == all.end())
    throw BadRequest(std::string("The parameter '") + name + "' has no such value.");
  return &*found;
}

/// The words that begin clauses, once each.
Json keywordsJson() {
  std::set<std::string_view> words;
  for (const dsl::Keyword& keyword : dsl::keywords()) words.insert(keyword.word);
  return words;
}

/// A run of one kind for one page.
class PageTurn : public Turn {
 public:
  PageTurn(Turns& turns, const Parameters& parameters, const char* kind)
      : Turn(turns, parameters["page"] + " " + kind, numberIn(parameters, "run"), kTimeLimit) {}

  Json answer(Json result) const {
    return isOvertaken() || result.is_null() ? Json{{"overtaken", true}} : result;
  }
};

}  // namespace

Answers::Answers(lsp::Surroundings surroundings, RuleFile file, bool watches)
    : surroundings_(surroundings),
      file_(std::move(file)),
      watches_(watches),
      language_(std::move(surroundings), file_.path().string()) {}

Json Answers::file() const {
  const FileContent content = file_.read();
  return {{"name", file_.path().filename().string()},
          {"path", file_.path().string()},
          {"text", content.text},
          {"version", content.version},
          {"fault", content.fault},
          {"watches", watches_},
          {"keywords", keywordsJson()},
          {"domains", choicesJson(sampleDomains())},
          {"sizes", choicesJson(sampleSizes())},
          {"seconds", kTimeLimit.count()}};
}

Json Answers::state() {
  return {{"version", file_.read().version}, {"imports", language_.stampOfImports()}};
}

Json Answers::diagnostics(const std::string& text, const Parameters&) {
  return {{"diagnostics", language_.diagnostics(text)}};
}

Json Answers::checks(const std::string& text, const Parameters& parameters) {
  const PageTurn turn(turns_, parameters, "checks");
  const Json found = language_.allDiagnostics(text, turn.token());
  return turn.answer(found.is_null() ? found
                                     : Json{{"diagnostics", found}, {"late", turn.isLate()}});
}

Json Answers::rules(const std::string& text, const Parameters& parameters) {
  const PageTurn turn(turns_, parameters, "rules");
  return turn.answer(rulesPreview(*language_.analysis(text), turn.token()));
}

Json Answers::tests(const std::string& text, const Parameters& parameters) {
  const PageTurn turn(turns_, parameters, "tests");
  return turn.answer(testsPreview(*language_.analysis(text), turn.token()));
}

Json Answers::mesh(const std::string& text, const Parameters& parameters) {
  SampleRequest request;
  request.domain = chosen(sampleDomains(), parameters, "domain");
  request.size = chosen(sampleSizes(), parameters, "size");
  request.byRule = parameters["color"] != "quality";
  request.optimize = parameters["optimize"] != "0";
  dsl::LoadOptions loading;
  loading.searchPaths = surroundings_.rules;
  loading.registry = &surroundings_.registry;
  const PageTurn turn(turns_, parameters, "mesh");
  return turn.answer(sampleMesh(file_.path().string(), text, loading, request, turn.token()));
}

Json Answers::askAt(const std::string& text, const Parameters& parameters, const char* method) {
  const Json position{{"line", numberIn(parameters, "line")},
                      {"character", numberIn(parameters, "character")}};
  return language_.ask(text, method, position);
}

Json Answers::completion(const std::string& text, const Parameters& parameters) {
  return askAt(text, parameters, "textDocument/completion");
}

Json Answers::hover(const std::string& text, const Parameters& parameters) {
  return askAt(text, parameters, "textDocument/hover");
}

Json Answers::save(const std::string& text, const Parameters& parameters) {
  if (watches_) throw BadRequest("With --watch, the file is not written.");
  const auto overwrite =
      parameters["overwrite"] == "1" ? RuleFile::Overwrite::Yes : RuleFile::Overwrite::No;
  const std::lock_guard lock(saving_);
  const RuleFile::Saved saved = file_.save(text, parameters["basis"], overwrite);
  return {{"changed", saved.isChanged}, {"version", saved.version}};
}

}  // namespace af2::playground
