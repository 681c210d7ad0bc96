#include "dsl/fixes.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>
#include <utility>

#include "dsl/checks/fitting_element.h"

namespace af2::dsl {
namespace {

bool isNameLetter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The byte at which a character of a line begins.
std::uint32_t offsetOf(const SourceText& source, int line, int column) {
  std::uint32_t low = 0, high = static_cast<std::uint32_t>(source.text().size());
  while (low < high) {  // places grow with offsets
    const std::uint32_t middle = low + (high - low) / 2;
    const LinePlace place = source.place(middle);
    if (std::pair(place.line, place.column) < std::pair(line, column))
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

Span spanOf(const SourceText& source, const DiagnosticPlace& place) {
  return {offsetOf(source, place.line, place.column),
          offsetOf(source, place.endLine, place.endColumn)};
}

/// What stands between the first pair of quotes behind `lead`.
std::optional<std::string> quotedAfter(const std::string& text, const std::string& lead) {
  const std::size_t at = text.find(lead);
  if (at == std::string::npos) return std::nullopt;
  const std::size_t begin = at + lead.size(), end = text.find('\'', begin);
  if (end == std::string::npos || end == begin) return std::nullopt;
  return text.substr(begin, end - begin);
}

class EditFinder {
 public:
  explicit EditFinder(const LoadedRules& loaded)
      : loaded_(loaded), source_(loaded.file->main().source) {}

  std::vector<TextEdit> find() {
    for (const Diagnostic& diagnostic : loaded_.diagnostics) {
      if (diagnostic.place.file != source_.name() || diagnostic.place.line == 0) continue;
      const Span span = spanOf(source_, diagnostic.place);
      renameWord(diagnostic, span);
      addMissingSign(diagnostic, span);
      if (const CompiledRule* rule = ruleOf(diagnostic)) {
        replaceElement(diagnostic, *rule);
        addMirror(diagnostic, *rule);
        removeMirror(diagnostic, *rule);
      }
    }
    return std::move(edits_);
  }

 private:
  std::string textOf(Span span) const {
    return std::string(source_.text().substr(span.begin, span.end - span.begin));
  }

  const CompiledRule* ruleOf(const Diagnostic& diagnostic) const {
    for (const CompiledRule& rule : loaded_.file->rules)
      if (rule.definition.name == diagnostic.rule && rule.home == &loaded_.file->main())
        return &rule;
    return nullptr;
  }

  /// "did you mean 'x'?" about a name, the name of a call, or a title in quotes.
  void renameWord(const Diagnostic& diagnostic, Span span) {
    const auto meant = quotedAfter(diagnostic.help, "did you mean '");
    if (!meant) return;
    const std::string text = textOf(span);
    std::size_t begin = 0, end = 0;
    if (text.starts_with('"')) {
      begin = 1;
      end = text.find('"', begin);
      if (end == std::string::npos) return;
    } else {
      const std::size_t dot = text.find('.');  // lib.name: the name is meant
      const bool isImported = dot != std::string::npos && text.find('(') > dot;
      begin = end = isImported ? dot + 1 : 0;
      while (end < text.size() && isNameLetter(text[end])) ++end;
    }
    const std::string written = text.substr(begin, end - begin);
    if (written.empty() || written == *meant) return;
    const auto at = [&](std::size_t i) { return span.begin + static_cast<std::uint32_t>(i); };
    add({at(begin), at(end)}, *meant, "'" + written + "' becomes '" + *meant + "'");
  }

  /// ';' where a clause ends without it; '}' before what cannot stand in the block.
  void addMissingSign(const Diagnostic& diagnostic, Span span) {
    if (diagnostic.code == "S2" && diagnostic.message.starts_with("';' is missing after"))
      add({span.end, span.end}, ";", "';' added");
    if (diagnostic.code == "S5" && diagnostic.help == "add '}'")
      add({span.begin, span.begin}, "}\n\n", "'}' added");
  }

  /// Other corners for one element, where there is one choice with which all elements fit together
  /// and to the pattern: mostly the same ones the other way round.
  void replaceElement(const Diagnostic& diagnostic, const CompiledRule& rule) {
    if ((diagnostic.code != "G1" && diagnostic.code != "T1") || rule.isMirror) return;
    for (std::size_t i = 0; i < rule.elementSpans.size(); ++i) {
      const std::string names = fittingElement(rule, i);
      const Span span = rule.elementSpans[i];
      if (!names.empty()) add(span, names, "'" + textOf(span) + "' becomes '" + names + "'");
    }
  }

  /// The title of the twin: left for right, or an addition.
  std::string twinTitle(const std::string& title) const {
    std::string twin = title;
    for (const auto& [word, other] : {std::pair<std::string, std::string>{"right", "left"},
                                      {"Right", "Left"},
                                      {"left", "right"},
                                      {"Left", "Right"}}) {
      const std::size_t at = twin.find(word);
      if (at == std::string::npos) continue;
      twin.replace(at, word.size(), other);
      break;
    }
    if (twin == title) twin += ", mirrored";
    while (isTaken(twin)) twin += ", 2";
    return twin;
  }

  bool isTaken(const std::string& title) const {
    return std::ranges::any_of(loaded_.file->rules, [&](const CompiledRule& rule) {
      return rule.definition.name == title;
    });
  }

  void addMirror(const Diagnostic& diagnostic, const CompiledRule& rule) {
    const bool isMissing =
        diagnostic.code == "M1" && diagnostic.message == "this rule has no mirror image";
    // Of a family or a template one clause would stand for several rules.
    if (!isMissing || rule.text->family || !rule.parameters.empty()) return;
    if (rule.text->clauses.empty()) return;
    const std::uint32_t end = rule.text->clauses.back().span.end;
    const std::string twin = twinTitle(rule.definition.name);
    add({end, end}, "\n  mirror \"" + twin + "\";", "the mirror image \"" + twin + "\" added");
  }

  void removeMirror(const Diagnostic& diagnostic, const CompiledRule& rule) {
    if (diagnostic.code != "M2" || !rule.mirrorSpan || !rule.parameters.empty()) return;
    Span span = *rule.mirrorSpan;
    while (span.begin > 0 &&
           std::isspace(static_cast<unsigned char>(source_.text()[span.begin - 1])) != 0)
      --span.begin;
    add(span, "", "a mirror clause removed that did the same once more");
  }

  void add(Span span, std::string replacement, std::string what) {
    edits_.push_back({span, std::move(replacement), std::move(what)});
  }

  const LoadedRules& loaded_;
  const SourceText& source_;
  std::vector<TextEdit> edits_;
};

/// Errors in the signs, in names and types, in what the rules say; then warnings. Earlier faults
/// hide later ones, so that fewer of the first kind are better whatever comes to light.
std::array<std::size_t, 4> faultsOf(const LoadedRules& loaded) {
  std::array<std::size_t, 4> counts{};
  for (const Diagnostic& d : loaded.diagnostics) {
    const std::string_view early = "LS", middle = "RYA";
    const bool isError = d.severity == Severity::Error;
    const std::size_t stage = early.find(d.code[0]) != early.npos     ? 0
                              : middle.find(d.code[0]) != middle.npos ? 1
                                                                      : 2;
    ++counts[isError ? stage : 3];
  }
  return counts;
}

std::string edited(const std::string& text, const TextEdit& edit) {
  std::string result = text;
  return result.replace(edit.span.begin, edit.span.end - edit.span.begin, edit.replacement);
}

}  // namespace

std::vector<TextEdit> editsFor(const LoadedRules& loaded) { return EditFinder(loaded).find(); }

FixedText fixText(const std::string& name, std::string text, const LoadOptions& options) {
  constexpr int kMostTries = 500;
  FixedText fixed{std::move(text), {}};
  LoadedRules loaded = loadRulesFromText(name, fixed.text, options);
  int tries = 0;
  for (bool isBetter = true; isBetter;) {
    isBetter = false;
    for (const TextEdit& edit : editsFor(loaded)) {
      if (++tries > kMostTries) return fixed;
      std::string candidate = edited(fixed.text, edit);
      LoadedRules then = loadRulesFromText(name, candidate, options);
      if (faultsOf(then) >= faultsOf(loaded)) continue;
      fixed.text = std::move(candidate);
      fixed.done.push_back(edit.what);
      loaded = std::move(then);
      isBetter = true;
      break;
    }
  }
  return fixed;
}

}  // namespace af2::dsl
