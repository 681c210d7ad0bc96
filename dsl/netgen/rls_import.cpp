#include "dsl/netgen/rls_import.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

#include "dsl/format/printer.h"
#include "dsl/load/rule_file.h"
#include "dsl/netgen/rls_file.h"
#include "dsl/netgen/rls_rule.h"
#include "dsl/netgen/rls_rule_text.h"
#include "dsl/netgen/rls_twins.h"

namespace af2::dsl {
namespace {

class Importer {
 public:
  Importer(const SourceText& source, DiagnosticList& diagnostics)
      : source_(source), diagnostics_(diagnostics) {}

  std::string write() {
    for (const RlsRule& rule : readRls(source_, diagnostics_)) {
      if (!branches(rule)) rules_.push_back(toClassicRule(rule, source_, diagnostics_));
    }
    if (rules_.empty() && !diagnostics_.hasErrors())
      tell(Code::NetgenSyntax, {}, "there is no rule in this file",
           "rules begin with: rule \"name\"");
    if (diagnostics_.hasErrors()) return {};
    for (const ClassicRule& rule : rules_) titles_.push_back(titleOf(rule));
    const std::string text = header() + writeRules(texts());
    const Formatted formatted = format("imported.af2", text);
    const std::string& written = formatted.text.empty() ? text : formatted.text;
    tellWhatCannotBeUsed(written);
    return written;
  }

 private:
  void tell(Code code, Span span, std::string message, std::string help) {
    diagnostics_.add(rlsFinding(code, placeOf(source_, span), std::move(message), std::move(help)));
  }

  void tellWhatCannotBeUsed(const std::string& text) {
    std::set<std::string> told;
    for (const Diagnostic& d : loadRulesFromText("imported.af2", text).diagnostics) {
      if (d.severity != Severity::Error || !told.insert(d.rule).second) continue;
      const auto i = static_cast<std::size_t>(std::ranges::find(titles_, d.rule) - titles_.begin());
      tell(Code::NetgenRefused, i < rules_.size() ? rules_[i].span : Span{},
           "the imported rule will be refused: " + d.message,
           "correct it here or in the imported file; `af2 check` gives the details");
    }
  }

  /// The front is made of chains: no vertex begins or ends two of its edges.
  bool branches(const RlsRule& rule) {
    std::set<int> from, to;
    for (const RlsLine& line : rule.mapLines) {
      if (line.from != line.to && from.insert(line.from).second && to.insert(line.to).second)
        continue;
      tell(Code::NetgenContradiction, line.span, "maplines that branch or join a point to itself",
           "at most one line leaves a point, and one arrives");
      return true;
    }
    return false;
  }

  /// A unique title, without characters that have a meaning in titles.
  std::string titleOf(const ClassicRule& rule) {
    std::string title;
    for (char c : rule.title) {
      const auto byte = static_cast<unsigned char>(c);
      if (c == '{' || c == '}' || c == '\\')
        title += c == '{' ? '(' : c == '}' ? ')' : '/';
      else
        title += byte < 0x20 || byte >= 0x7f ? '?' : c;
    }
    if (title.empty()) title = "rule";
    std::string unique = title;
    for (int i = 2; !used_.insert(unique).second; ++i) unique = title + ", " + std::to_string(i);
    if (unique != rule.title)
      tell(Code::NetgenRenamed, rule.span, "this rule is called \"" + unique + "\" now",
           "titles are unique and plain");
    return unique;
  }

  std::vector<RuleText> texts() {
    isPartner_.assign(rules_.size(), false);
    std::vector<bool> isWritten(rules_.size());
    std::vector<RuleText> texts;
    for (std::size_t i = 0; i < rules_.size(); ++i) {
      if (isWritten[i]) continue;
      RuleText text = ruleText(rules_[i], titles_[i]);
      if (const auto j = writeTwin(i, isWritten, text)) isWritten[*j] = true;
      texts.push_back(std::move(text));
    }
    return texts;
  }

  std::optional<std::size_t> writeTwin(std::size_t i, const std::vector<bool>& isWritten,
                                       RuleText& text) {
    std::string difference;
    if (findTwin(rules_[i], rules_[i], difference) || isPartner_[i]) return std::nullopt;
    std::string nearest;
    if (!difference.empty())
      nearest = "this rule would be its own mirror image, but for " + difference;
    for (std::size_t j = i + 1; j < rules_.size(); ++j) {
      if (isWritten[j]) continue;
      const auto twin = findTwin(rules_[i], rules_[j], difference);
      if (twin) {
        if (!twin->ownForms.empty())
          tell(Code::NetgenMismatch, rules_[j].span,
               "this is the mirror image of \"" + titles_[i] + "\" but for its tolerances",
               "the mirror keeps tolerances of its own");
        text.clauses.push_back(mirrorClause(rules_[i], rules_[j], *twin, titles_[j]));
        text.remarks.insert(text.remarks.end(), rules_[j].remarks.begin(), rules_[j].remarks.end());
        text.hasMirror = true;
        return j;
      }
      if (!nearest.empty() || difference.empty() || rules_[i].quality != rules_[j].quality)
        continue;
      nearest = "this would be the mirror image of \"" + titles_[j] + "\", but for " + difference;
      isPartner_[j] = true;
    }
    if (nearest.empty()) nearest = "this rule has no mirror image in the file";
    text.remarks.push_back(nearest);
    tell(Code::NetgenMismatch, rules_[i].span, nearest,
         "if its mirror image is wanted, add: mirror \"a title\";");
    return std::nullopt;
  }

  bool makes(std::size_t corners) const {
    return std::ranges::any_of(rules_, [&](const ClassicRule& rule) {
      return std::ranges::any_of(rule.elements,
                                 [&](const auto& element) { return element.size() == corners; });
    });
  }

  std::string header() const {
    const bool hasQuads = makes(4);
    const std::string kinds = !hasQuads ? "tri" : makes(3) ? "quad, tri" : "quad";
    const std::string file = std::filesystem::path(source_.name()).filename().string();
    std::string name;
    for (char c : std::filesystem::path(file).stem().string())
      name += c == '"' || c == '\\' || static_cast<unsigned char>(c) < 0x20 ? '_' : c;
    std::string comment;
    for (char c : file) comment += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
    return "af2 1;\n# Imported from " + comment +
           ". What such files leave to the program is said in the rule set.\n\nruleset \"" +
           (name.empty() ? "imported" : name) + "\" {\n  elements " + kinds +
           ";\n  match    0.5 + 0.3*q;\n  fade     1/q;\n" +
           (hasQuads ? "  score    max of 5*jacobian_badness;    # 0 for the square\n"
                     : "  score    max of shape_size(10);\n") +
           "  accept   score < 2 + 0.5*q^2;\n  front    by q + layer(a) + layer(b);\n" +
           "  classes  1.." + std::to_string(kLastClassicLevel) + ";\n}\n";
  }

  const SourceText& source_;
  DiagnosticList& diagnostics_;
  std::vector<ClassicRule> rules_;
  std::vector<std::string> titles_;
  std::set<std::string> used_;
  std::vector<bool> isPartner_;  // rules that the remark of an earlier rule mentions
};

}  // namespace

ImportedRules importRls(std::string name, std::string text) {
  const SourceText source(std::move(name), std::move(text));
  DiagnosticList diagnostics;
  ImportedRules result;
  result.text = Importer(source, diagnostics).write();
  result.diagnostics = diagnostics.take();
  return result;
}

}  // namespace af2::dsl
