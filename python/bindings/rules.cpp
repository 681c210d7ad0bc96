#include "python/bindings/rules.h"

#include <af2/dsl/diagnostic.h>
#include <af2/dsl/evaluate.h>
#include <af2/dsl/proven_errors.h>
#include <af2/dsl/rule_tests.h>
#include <af2/dsl/shipped_rules.h>
#include <af2/engine/error.h>

#include <map>
#include <string>

namespace af2::python {

Rules::Rules(dsl::LoadedRules loaded) : loaded_(std::move(loaded)) {
  if (!loaded_.rules) return;
  algorithm_ = std::make_unique<const AF2Algorithm>(loaded_.rules);
  for (dsl::RuleSource& source : dsl::sourcesOf(loaded_))
    texts_.push_back({std::move(source.file), source.line, std::move(source.text)});
}

const RuleSet& Rules::ruleSet() const {
  if (!loaded_.rules) throw InputError("the rule file has no rule set");
  return *loaded_.rules;
}

namespace {

/// Errors that a rule file may allow: the rules can be run all the same.
std::vector<dsl::Code> allowableErrors() {
  std::vector<dsl::Code> codes;
  for (const dsl::CodeInfo& info : dsl::diagnosticCodes())
    if (info.allowance == dsl::Allowance::AsError) codes.push_back(info.code);
  return codes;
}

dsl::LoadOptions loadOptions(bool isChecked) {
  dsl::LoadOptions options = dsl::withShippedImports({});
  options.needsRuleSet = false;
  if (!isChecked) options.allowed = allowableErrors();
  return options;
}

std::vector<dsl::Diagnostic> provenErrors(const Rules& rules) {
  if (!rules.loaded().rules || dsl::isShipped(rules.loaded())) return {};
  return dsl::findProvenErrors(rules.loaded()).diagnostics;
}

py::object placeOf(const std::optional<Point2>& place) {
  if (!place) return py::none();
  return py::make_tuple(place->x, place->y);
}

py::dict dictOf(const dsl::EvalResult& result) {
  py::dict values;
  values["refused"] = std::string(toString(result.refused));
  values["because"] = result.because;
  values["matches"] = result.matches;
  values["require"] = result.requireHolds;
  py::dict created;
  for (const auto& [name, place] : result.newVertices) created[name.c_str()] = placeOf(place);
  values["new"] = created;
  py::list zones;
  for (const std::vector<Point2>& zone : result.zones) {
    py::list corners;
    for (const Point2 corner : zone) corners.append(placeOf(corner));
    zones.append(corners);
  }
  values["zones"] = zones;
  values["points_in_zone"] = result.pointsInZone;
  values["segments_meet_zone"] = result.segmentsMeetZone;
  values["score"] = result.score;
  values["text"] = dsl::toText(result);
  return values;
}

using Place = std::pair<double, double>;

py::dict evaluateAt(const Rules& rules, std::string title, int level,
                    const std::map<std::string, Place>& match, const std::vector<Place>& points,
                    const std::vector<std::pair<Place, Place>>& segments,
                    std::map<std::string, double> environment) {
  const auto placed = [](const Place& p) { return Point2{p.first, p.second}; };
  dsl::EvalRequest request;
  request.rule = std::move(title);
  request.level = level;
  for (const auto& [vertex, place] : match) request.match[vertex] = placed(place);
  for (const Place& p : points) request.points.push_back(placed(p));
  for (const auto& [from, to] : segments) request.segments.emplace_back(placed(from), placed(to));
  request.environment = std::move(environment);
  return dictOf(dsl::evaluateRule(rules.ruleSet(), request));
}

std::vector<std::string> titlesOf(const Rules& rules) {
  std::vector<std::string> titles;
  for (const auto& rule : rules.ruleSet().rules()) titles.push_back(rule.name());
  return titles;
}

const char* severityOf(const dsl::Diagnostic& diagnostic) {
  return diagnostic.severity == dsl::Severity::Error ? "error" : "warning";
}

void bindDiagnostics(py::module_& module) {
  py::class_<dsl::SuggestedEdit>(module, "SuggestedEdit")
      .def_readonly("what", &dsl::SuggestedEdit::what)
      .def_readonly("replacement", &dsl::SuggestedEdit::replacement)
      .def_property_readonly("line", [](const dsl::SuggestedEdit& e) { return e.place.line; })
      .def_property_readonly("column", [](const dsl::SuggestedEdit& e) { return e.place.column; })
      .def_property_readonly("end_line",
                             [](const dsl::SuggestedEdit& e) { return e.place.endLine; })
      .def_property_readonly("end_column",
                             [](const dsl::SuggestedEdit& e) { return e.place.endColumn; });
  using dsl::Diagnostic;
  py::class_<Diagnostic>(module, "Diagnostic")
      .def_property_readonly("code", [](const Diagnostic& d) { return dsl::fullIdOf(d.code); })
      .def_property_readonly("severity", &severityOf)
      .def_readonly("message", &Diagnostic::message)
      .def_readonly("help", &Diagnostic::help)
      .def_readonly("rule", &Diagnostic::rule)
      .def_readonly("edits", &Diagnostic::edits)
      .def_property_readonly("file", [](const Diagnostic& d) { return d.place.file; })
      .def_property_readonly("line", [](const Diagnostic& d) { return d.place.line; })
      .def_property_readonly("column", [](const Diagnostic& d) { return d.place.column; })
      .def_property_readonly("notes",
                             [](const Diagnostic& d) {
                               std::vector<std::string> notes;
                               for (const dsl::DiagnosticNote& note : d.notes)
                                 notes.push_back(note.message);
                               return notes;
                             })
      .def("__str__", [](const Diagnostic& d) { return dsl::toPretty(d); })
      .def("__repr__", [](const Diagnostic& d) {
        return "<Diagnostic " + dsl::fullIdOf(d.code) + ": " + d.message + ">";
      });
  module.def("pretty",
             [](const std::vector<Diagnostic>& diagnostics) { return dsl::toPretty(diagnostics); });
}

void bindTests(py::module_& module) {
  py::class_<dsl::TestFailure>(module, "TestFailure")
      .def_readonly("expected", &dsl::TestFailure::expected)
      .def_readonly("got", &dsl::TestFailure::got)
      .def_property_readonly("line", [](const dsl::TestFailure& f) { return f.place.line; });
  using dsl::TestResult;
  py::class_<TestResult>(module, "TestResult")
      .def_readonly("title", &TestResult::title)
      .def_property_readonly("passed", &TestResult::passed)
      .def_readonly("failures", &TestResult::failures)
      .def_readonly("rule", &TestResult::appliedRule)
      .def_readonly("score", &TestResult::score)
      .def_readonly("is_property", &TestResult::isProperty)
      .def_readonly("samples", &TestResult::samples)
      .def_readonly("explanation", &TestResult::explanation)
      .def_property_readonly("file", [](const TestResult& r) { return r.place.file; })
      .def_property_readonly("line", [](const TestResult& r) { return r.place.line; })
      .def("__str__", [](const TestResult& r) { return dsl::toText(r); });
}

}  // namespace

void bindRules(py::module_& module) {
  bindDiagnostics(module);
  bindTests(module);
  const py::call_guard<py::gil_scoped_release> withoutGil;
  py::class_<Rules, std::shared_ptr<Rules>>(module, "RuleFile")
      .def_property_readonly("name", [](const Rules& r) { return r.ruleSet().name(); })
      .def_property_readonly("titles", &titlesOf)
      .def_property_readonly("makes_quads", [](const Rules& r) { return r.ruleSet().makesQuads(); })
      .def_property_readonly("is_usable", [](const Rules& r) { return r.algorithm() != nullptr; })
      .def_property_readonly("diagnostics", [](const Rules& r) { return r.loaded().diagnostics; })
      .def("proven_errors", &provenErrors, withoutGil)
      .def(
          "test",
          [](const Rules& r, const std::string& filter) {
            r.ruleSet();
            return dsl::runRuleTests(r.loaded(), filter);
          },
          withoutGil)
      .def("evaluate", &evaluateAt);
  module.def(
      "load_rules",
      [](const std::filesystem::path& path, bool isChecked) {
        return std::make_shared<Rules>(dsl::loadRules(path, loadOptions(isChecked)));
      },
      withoutGil);
  module.def(
      "rules_from_text",
      [](std::string name, std::string text, bool isChecked) {
        return std::make_shared<Rules>(
            dsl::loadRulesFromText(std::move(name), std::move(text), loadOptions(isChecked)));
      },
      withoutGil);
  module.def(
      "shipped_rules",
      [](const std::string& name) { return std::make_shared<Rules>(dsl::loadShippedRules(name)); },
      withoutGil);
  module.def("shipped_files", [] {
    std::vector<std::string> names;
    for (const dsl::ShippedFile& file : dsl::shippedFiles()) names.emplace_back(file.name);
    return names;
  });
}

}  // namespace af2::python
