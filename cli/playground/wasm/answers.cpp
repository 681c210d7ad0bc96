// The playground without a server: what its page asks the program, answered by WebAssembly in the
// browser.
#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <set>
#include <stop_token>
#include <string>

#include "cli/lsp/document.h"
#include "cli/lsp/text_map.h"
#include "cli/playground/choices_json.h"
#include "cli/playground/preview.h"
#include "cli/playground/sample_domains.h"
#include "cli/playground/sample_mesh.h"
#include "dsl/load/rule_file.h"
#include "dsl/load/shipped_rules.h"
#include "dsl/proof/match_diagnostics.h"
#include "dsl/text/keywords.h"
#include "geometry/base/free_memory.h"

namespace af2::playground {
namespace {

using lsp::Json;

/// The text of the page lies here, beside the files that AF2 comes with, so that it can import
/// them.
constexpr const char* kFolder = "/rules";

std::optional<std::string> shippedText(const std::filesystem::path& path) {
  const std::string name = path.lexically_normal().lexically_relative(kFolder).generic_string();
  for (const dsl::ShippedFile& file : dsl::shippedFiles())
    if (file.name == name) return std::string(file.text);
  return std::nullopt;
}

dsl::LoadOptions loading() {
  dsl::LoadOptions options;
  options.unsaved = shippedText;
  options.searchPaths = {kFolder};
  return options;
}

/// In the folder of the file that the page began with.
std::string pathOf(const Json& request) {
  const std::string name = request.value("name", "tri/even.af2");
  return std::string(kFolder) + "/" + name.substr(0, name.find('/')) + "/mine.af2";
}

lsp::Analysis analysisOf(const Json& request) {
  return lsp::Analysis(
      dsl::loadRulesFromText(pathOf(request), request.value("text", ""), loading()));
}

Json rangeOf(const dsl::DiagnosticPlace& place, const dsl::SourceText& source) {
  const auto size = static_cast<std::uint32_t>(source.text().size());
  dsl::Span span{0, 0};
  if (place.line > 0)
    span = {source.offsetOf({place.line, place.column}),
            source.offsetOf({place.endLine, place.endColumn})};
  if (span.end <= span.begin) span.end = std::min(span.begin + 1, size);
  return lsp::TextMap(source.text(), lsp::Encoding::Utf16).range(span);
}

/// In the form of the language server protocol, as the page knows it from there.
Json diagnosticsJson(const std::vector<dsl::Diagnostic>& all, const dsl::SourceText& source) {
  Json list = Json::array();
  for (const dsl::Diagnostic& d : all) {
    std::string message = d.message;
    if (!d.label.empty()) message += ": " + d.label;
    if (!d.help.empty()) message += "\nhelp: " + d.help;
    list.push_back({{"range", rangeOf(d.place, source)},
                    {"severity", d.severity == dsl::Severity::Warning ? 2 : 1},
                    {"code", dsl::fullIdOf(d.code)},
                    {"message", message}});
  }
  return list;
}

Json diagnostics(const Json& request) {
  const lsp::Analysis analysis = analysisOf(request);
  return {{"diagnostics", diagnosticsJson(analysis.loaded.diagnostics, analysis.main().source)}};
}

/// Like the answer of the server, and the files that one can begin with.
Json file(const Json& request) {
  const std::string wanted = request.value("name", "tri/even.af2");
  Json files = Json::array();
  std::string text;
  for (const dsl::ShippedFile& shipped : dsl::shippedFiles()) {
    files.push_back(std::string(shipped.name));
    if (shipped.name == wanted) text = shipped.text;
  }
  std::set<std::string_view> words;
  for (const dsl::Keyword& keyword : dsl::keywords()) words.insert(keyword.word);
  return {{"name", wanted},
          {"path", wanted},
          {"text", text},
          {"files", files},
          {"keywords", words},
          {"domains", choicesJson(sampleDomains())},
          {"sizes", choicesJson(sampleSizes())}};
}

template <class Choice>
const Choice& chosen(std::span<const Choice> all, const std::string& name) {
  const auto found = std::ranges::find(all, name, &Choice::name);
  return found == all.end() ? all.front() : *found;
}

Json mesh(const Json& request) {
  SampleRequest sample;
  sample.domain = &chosen(sampleDomains(), request.value("domain", ""));
  sample.size = &chosen(sampleSizes(), request.value("size", ""));
  sample.byRule = request.value("color", "rule") != "quality";
  sample.optimize = request.value("optimize", "1") != "0";
  return sampleMesh(pathOf(request), request.value("text", ""), loading(), sample, {});
}

Json answerTo(const Json& request) {
  const std::string kind = request.value("kind", "");
  if (kind == "file") return file(request);
  if (kind == "diagnostics" || kind == "checks") return diagnostics(request);
  if (kind == "mesh") return mesh(request);
  if (kind == "rules") return rulesPreview(analysisOf(request), {});
  if (kind == "tests") return testsPreview(analysisOf(request), {});
  return nullptr;
}

}  // namespace
}  // namespace af2::playground

/// A page of a browser does not say; its memory ends at 4 GiB.
double af2::geometry::freeMemory() { return 2e9; }
void af2::geometry::returnFreedMemory() {}

namespace {
std::string request, answer;  // both as JSON
}

extern "C" {

/// Where the caller writes a request of so many bytes.
char* af2Reserve(std::size_t bytes) {
  request.assign(bytes, '\0');
  return request.data();
}

/// The answer to that request, which is there until the next one.
const char* af2Answer() {
  try {
    answer = af2::playground::answerTo(af2::lsp::Json::parse(request))
                 .dump(-1, ' ', false, af2::lsp::Json::error_handler_t::replace);
  } catch (const std::exception& error) {
    answer = af2::lsp::Json{{"fault", error.what()}}.dump();
  }
  return answer.data();
}

std::size_t af2AnswerSize() { return answer.size(); }
}
