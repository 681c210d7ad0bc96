#include "cli/rules/gallery.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <variant>

#include "cli/rules/html_code.h"
#include "dsl/load/loaded_file.h"
#include "dsl/picture/rule_picture.h"
#include "dsl/run/rule_tests.h"

namespace af2::cli {
namespace {

using dsl::CompiledRule;

/// Levels whose zones are also drawn separately.
constexpr int kLevels[] = {1, 2, 3, 5, 10, 20};

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --ink: #1f2937; --soft: #6b7280; --line: #d8dde4; --page: #f6f7f9; --card: #fff;
        --key: #7c3aed; --text: #047857; --number: #b45309; --good: #15803d; --bad: #b91c1c; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e5e7eb; --soft: #9ca3af; --line: #374151; --page: #111827; --card: #1f2937;
          --key: #c4b5fd; --text: #6ee7b7; --number: #fcd34d; --good: #4ade80; --bad: #f87171; }
}
* { box-sizing: border-box; }
body { margin: 0; font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--page); }
main { max-width: 72rem; margin: 0 auto; padding: 2rem 1.5rem 6rem; }
h1 { margin: 0; } h2 { margin: 0; font-size: 1.25rem; } a { color: inherit; }
.soft { color: var(--soft); } .bad { color: var(--bad); } .good { color: var(--good); }
nav { position: sticky; top: 0; z-index: 1; padding: .75rem 0; background: var(--page);
      border-bottom: 1px solid var(--line); margin-bottom: 1.5rem; }
nav label { margin-right: .75rem; white-space: nowrap; }
.index { columns: 16rem; padding: 0; list-style: none; }
article { display: grid; grid-template-columns: 420px 1fr; gap: 1.5rem; background: var(--card);
          border: 1px solid var(--line); border-radius: 10px; padding: 1.25rem; margin: 0 0 1.5rem;
          scroll-margin-top: 4rem; }
article > div { min-width: 0; }
article img { width: 100%; height: auto; background: #fff; border-radius: 6px; }
article img[data-level]:not([data-level="all"]) { display: none; }
pre { overflow-x: auto; padding: .75rem 1rem; background: var(--page); border-radius: 6px;
      font: 13px/1.5 ui-monospace, monospace; margin: .75rem 0; }
pre i { font-style: normal; } .k { color: var(--key); } .s { color: var(--text); }
.n { color: var(--number); } pre .c { color: var(--soft); }
.tests { padding: 0; margin: .75rem 0 0; list-style: none; font-size: .9rem; }
@media (max-width: 60rem) { article { grid-template-columns: 1fr; } }
@media print { nav { display: none; } article { break-inside: avoid; } }
)";

// Shows the zones of one level, or of several at once.
constexpr const char* kScript = R"(
document.querySelectorAll('nav input').forEach(input => input.addEventListener('change', () => {
  document.querySelectorAll('article').forEach(rule => {
    const pictures = [...rule.querySelectorAll('img[data-level]')];
    const chosen = pictures.find(p => p.dataset.level === input.value) || pictures[0];
    pictures.forEach(p => { p.style.display = p === chosen ? 'block' : 'none'; });
  });
}));
)";

struct TestOfRule {
  std::string title;
  bool passed = true;
};

/// Assigns each test to the rule that it names or that was applied in it.
std::map<std::string, std::vector<TestOfRule>> testsByRule(
    const dsl::LoadedRules& loaded, const std::vector<dsl::TestResult>& results) {
  std::map<std::string, std::vector<TestOfRule>> tests;
  for (const dsl::TestResult& result : results) {
    std::set<std::string> rules{result.appliedRule};
    for (const dsl::CompiledTest& test : loaded.file->tests) {
      if (test.title != result.title) continue;
      for (const dsl::CompiledExpectation& expectation : test.expectations) {
        const auto* rule = std::get_if<dsl::CompiledExpectation::IsRule>(&expectation.outcome);
        if (rule) rules.insert(rule->title);
      }
    }
    for (const std::string& rule : rules) tests[rule].push_back({result.title, result.passed()});
  }
  return tests;
}

class Gallery {
 public:
  explicit Gallery(const dsl::LoadedRules& loaded)
      : loaded_(loaded),
        rules_(loaded.rules.get()),
        results_(loaded.file->missing.empty() ? dsl::runRuleTests(loaded)
                                              : std::vector<dsl::TestResult>()),
        tests_(testsByRule(loaded, results_)) {}

  Site make() {
    std::string body = head() + levelChoice() + index();
    body += definitions();
    for (std::size_t i = 0; i < ruleCount(); ++i) body += article(i);
    site_["index.html"] = fmt::format(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n<title>{}</title>\n"
        "<style>{}</style>\n</head>\n<body>\n<main>\n{}</main>\n<script>{}</script>\n"
        "</body>\n</html>\n",
        escapeHtml(name()), kStyle, body, kScript);
    return std::move(site_);
  }

 private:
  std::string head() const {
    const auto passed = std::ranges::count_if(results_, &dsl::TestResult::passed);
    const auto failed = static_cast<std::ptrdiff_t>(results_.size()) - passed;
    const std::string missing = dsl::missingText(*loaded_.file);
    std::string tests = !missing.empty()   ? "tests not run: " + escapeHtml(missing)
                        : results_.empty() ? "no tests"
                                           : fmt::format("{} tests pass", passed);
    if (failed > 0) tests += fmt::format(", <span class=\"bad\">{} fail</span>", failed);
    return fmt::format("<h1>{}</h1>\n<p class=\"soft\">{} rules, {}</p>\n{}", escapeHtml(name()),
                       ruleCount(), tests, settings());
  }

  std::size_t ruleCount() const { return rules_ ? rules_->rules().size() : 0; }

  std::string name() const {
    return rules_ ? rules_->name() : std::string(loaded_.file->main().source.name());
  }

  /// The definitions that other files may import, with the comments above them.
  std::string definitions() const {
    const dsl::Module& main = loaded_.file->main();
    std::string out;
    for (const dsl::Item& item : main.parsed.file.items) {
      const std::string code = "<pre>" + codeHtml(main.source, item.span) + "</pre>\n";
      using namespace dsl;
      match(
          item.content, [&](const Constant&) { out += code; },
          [&](const AnyOf<Function, Metric, Extern, Template> auto& c) {
            out += paragraph(c.doc) + code;
          },
          [](const AnyOf<std::monostate, Import, Use, RuleSetBlock, Rule, Instance, Test,
                         Property> auto&) {});
    }
    return out.empty() ? out : "<section>\n<h2>Definitions</h2>\n" + out + "</section>\n";
  }

  /// The text of the rule set itself, with the comments above it.
  std::string settings() const {
    const dsl::Module& main = loaded_.file->main();
    for (const dsl::Item& item : main.parsed.file.items) {
      const auto* block = std::get_if<dsl::RuleSetBlock>(&item.content);
      if (!block || block->name.text != name()) continue;
      std::string out = paragraph(block->doc);
      return out + "<pre>" + codeHtml(main.source, item.span) + "</pre>\n";
    }
    return {};
  }

  static std::string paragraph(const std::string& doc) {
    return doc.empty() ? "" : "<p>" + escapeHtml(doc) + "</p>\n";
  }

  static std::string levelChoice() {
    std::string out =
        "<nav>Free zones at quality level: "
        "<label><input type=\"radio\" name=\"level\" value=\"all\" checked> several</label>";
    for (const int level : kLevels) {
      out += fmt::format("<label><input type=\"radio\" name=\"level\" value=\"{}\"> {}</label>",
                         level, level);
    }
    return out + "</nav>\n";
  }

  std::string index() const {
    std::string out = "<ul class=\"index\">\n";
    for (std::size_t i = 0; i < ruleCount(); ++i) {
      out += fmt::format("<li><a href=\"#rule-{}\">{}</a></li>\n", i + 1,
                         escapeHtml(rules_->rules()[i].name()));
    }
    return out + "</ul>\n";
  }

  std::string article(std::size_t i) {
    const CompiledRule& rule = loaded_.file->rules[i];
    std::string out = fmt::format("<article id=\"rule-{}\">\n<div>{}</div>\n<div>\n<h2>{}</h2>\n",
                                  i + 1, pictures(i), escapeHtml(rule.definition.name));
    if (rule.isMirror) {
      out += fmt::format("<p class=\"soft\">The mirror image of the rule \"{}\".</p>\n",
                         escapeHtml(rule.text->title.text));
    }
    out += paragraph(rule.doc) + parameters(rule);
    out += "<pre>" + codeHtml(rule.home->source, rule.text->span) + "</pre>\n";
    return out + testList(rule.definition.name) + "</div>\n</article>\n";
  }

  static std::string parameters(const CompiledRule& rule) {
    std::string list;
    for (const auto& [name, parameter] : rule.parameters) {
      list += fmt::format("{}{} = {}", list.empty() ? "" : ", ", name, parameter.value.number);
    }
    return list.empty() ? "" : "<p class=\"soft\">With " + escapeHtml(list) + ".</p>\n";
  }

  std::string testList(const std::string& rule) const {
    const auto found = tests_.find(rule);
    if (found == tests_.end()) return "<p class=\"soft\">No test names this rule.</p>\n";
    std::string out = "<ul class=\"tests\">\n";
    for (const TestOfRule& test : found->second) {
      out += fmt::format("<li><span class=\"{}\">{}</span> {}</li>\n", test.passed ? "good" : "bad",
                         test.passed ? "&#10003;" : "&#10007;", escapeHtml(test.title));
    }
    return out + "</ul>\n";
  }

  std::string pictures(std::size_t i) {
    std::string out = picture(i, "all", {});
    for (const int level : kLevels) {
      if (level <= rules_->maxLevel() && rules_->rules()[i].appliesAt(level)) {
        out += picture(i, std::to_string(level), {level});
      }
    }
    return out;
  }

  std::string picture(std::size_t i, const std::string& level, std::vector<int> levels) {
    const AF2Rule& rule = rules_->rules()[i];
    dsl::PictureOptions options;
    options.levels = std::move(levels);
    const std::string path = fmt::format("pictures/rule-{}-{}.svg", i + 1, level);
    site_[path] = dsl::drawRule(*rules_, rule, dsl::PictureFormat::Svg, options);
    return fmt::format("<img src=\"{}\" data-level=\"{}\" loading=\"lazy\" alt=\"{}\">", path,
                       level, escapeHtml(rule.name()));
  }

  const dsl::LoadedRules& loaded_;
  const RuleSet* rules_;  // null: a file without rules
  std::vector<dsl::TestResult> results_;
  std::map<std::string, std::vector<TestOfRule>> tests_;
  Site site_;
};

}  // namespace

Site makeGallery(const dsl::LoadedRules& loaded) { return Gallery(loaded).make(); }

}  // namespace af2::cli
