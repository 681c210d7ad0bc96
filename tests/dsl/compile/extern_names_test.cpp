// Names that rule files declare and programs register.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "dsl/load/loaded_file.h"
#include "dsl/load/rule_file.h"
#include "dsl/program/registry.h"
#include "dsl/proof/match_diagnostics.h"

namespace af2::dsl {
namespace {

const std::string kSet = "ruleset \"s\" { elements tri; }\n";
const std::string kFree =
    "rule \"free\" quality 1 { new c = mid(a, b) + (0, 0.866); zone a, b, c; tri a b c; ";

Registry allRegistered() {
  Registry registry;
  registry.addFunction(
      {"heat", "p", 'n', [](std::span<const double> at) { return std::optional<double>(at[1]); }});
  registry.addShape({"spot", "pn", [](std::span<const double>) {
                       return AF2FreeZoneDef::Made{nullptr, Refusal::Shape};
                     }});
  registry.addMetric("mine", std::make_shared<ShapeSizeMetric>(10));
  return registry;
}

LoadedRules loadWith(const std::string& text, Externs externs, const Registry* registry = nullptr) {
  LoadOptions options;
  options.externs = externs;
  options.registry = registry;
  return loadRulesFromText("test.af2", "af2 1;\n" + text, options);
}

/// The code and the message of the only finding.
std::string onlyFinding(const std::string& text, const Registry* registry = nullptr) {
  const LoadedRules loaded = loadWith(text, Externs::Declared, registry);
  EXPECT_EQ(loaded.diagnostics.size(), 1u) << toPretty(loaded.diagnostics);
  if (loaded.diagnostics.empty()) return {};
  return std::string(idOf(loaded.diagnostics[0].code)) + ": " + loaded.diagnostics[0].message;
}

TEST(Externs, AreCalledAsTheRegisteredNamesThatTheyAre) {
  const Registry all = allRegistered();
  const LoadedRules loaded = loadWith(
      "extern function heat(point) : number;\nextern shape spot(point, number);\n"
      "extern metric mine;\nruleset \"s\" { elements tri; score max of mine; }\n" +
          kFree + "require heat(c) < 0.5 or inside(a, spot(c, 2)); }",
      Externs::Registered, &all);
  EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  EXPECT_EQ(loaded.rules->definition().metric, all.metrics().at("mine"));
  EXPECT_TRUE(loaded.file->missing.empty());
}

TEST(Externs, ThatNothingImplementsAreAnErrorAtTheirDeclarationIfRulesAreToRun) {
  const LoadedRules loaded = loadWith(
      "extern function heat(point) : number;\n" + kSet + kFree + "require heat(c) < 0.5; }",
      Externs::Registered);
  EXPECT_FALSE(loaded.rules);
  ASSERT_EQ(loaded.diagnostics.size(), 1u) << toPretty(loaded.diagnostics);
  EXPECT_EQ(loaded.diagnostics[0].code, Code::MissingImplementation);
  EXPECT_EQ(loaded.diagnostics[0].place.line, 2u);
  EXPECT_EQ(loaded.diagnostics[0].place.column, 17u);
  EXPECT_NE(loaded.diagnostics[0].help.find("--plugin"), std::string::npos);
}

TEST(Externs, ThatNothingImplementsLeaveTheRestToBeChecked) {
  const std::string text =
      "extern function heat(point) : number;\nextern shape spot(point, number);\n" + kSet + kFree +
      "require heat(c) < 0.5; }\n"
      "rule \"spotted\" quality 2 { new c = mid(a, b) + (0, 0.8); zone spot(c, 2); tri a b c; }\n"
      "rule \"low\" quality 3 { new c = mid(a, b) + (0, 0.5); zone a, b, c; tri a b c; }\n";
  const LoadedRules loaded = loadWith(text, Externs::Declared);
  ASSERT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  EXPECT_TRUE(loaded.diagnostics.empty()) << toPretty(loaded.diagnostics);
  EXPECT_EQ(unknownRules(loaded), (std::set<std::size_t>{0, 1}));

  SamplingOptions options;
  options.unknown = unknownRules(loaded);
  const SampledResult result = runSampledChecks(*loaded.rules, options);
  EXPECT_FALSE(result.answers[0].isTried);
  EXPECT_FALSE(result.answers[1].isTried);
  EXPECT_TRUE(result.answers[2].isTried);
  for (const SampledFinding& finding : result.findings) EXPECT_EQ(finding.rule, 2u);

  const auto told = missingNamesIn(loaded);
  ASSERT_EQ(told.size(), 2u);
  EXPECT_EQ(told[0].severity, Severity::Warning);
  EXPECT_EQ(told[0].notes[0].message,
            "2 rules are checked by the text alone, and gaps between rules are not looked for");
}

TEST(Externs, OfTheRuleSetMakeAllRulesUnknown) {
  for (const char* setting : {"score max of mine;", "accept heat((0, score)) < 1;",
                              "score max of mine + 0.1;", "front by heat(a);"}) {
    const std::string declared =
        "extern metric mine;\nextern function heat(" +
        std::string(std::string(setting).starts_with("accept") ? "vector" : "point") +
        ") : number;\n";
    const LoadedRules loaded =
        loadWith(declared + "ruleset \"s\" { elements tri; " + setting + " }\n" + kFree + "}",
                 Externs::Declared);
    EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
    EXPECT_EQ(unknownRules(loaded).size(), 1u) << setting;
  }
}

TEST(Externs, ThatNoRuleCallsNeedNoImplementation) {
  const LoadedRules loaded = loadWith(
      "extern function heat(point) : number;\ndef warm(p) = heat(p) > 0.5;\n" + kSet + kFree +
          "}\ntemplate t(k)\nrule \"{k}\" quality 1 { new c = mid(a, b) + (0, k); "
          "require warm(c); zone a, b, c; tri a b c; }\n",
      Externs::Registered);
  EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
}

TEST(Externs, HaveTheirArgumentsChecked) {
  const std::string declared = "extern function heat(point) : number;\n" + kSet + kFree;
  EXPECT_EQ(onlyFinding(declared + "require heat(c, b) < 1; }"),
            "Y6: 'heat' is called with 2 arguments");
  EXPECT_EQ(onlyFinding(declared + "require heat(3) < 1; }"), "Y1: this is not a point");
  EXPECT_EQ(onlyFinding(declared + "require heat(c); }").substr(0, 3), "Y1:");
  EXPECT_EQ(onlyFinding(kSet + kFree +
                        "require heat(c) < 1; }\n"
                        "extern function heat(point) : number;"),
            "R1: 'heat' is used before it is defined");
}

TEST(Externs, ThatContradictWhatIsRegisteredAreAnErrorAtTheDeclaration) {
  const Registry all = allRegistered();
  for (const char* declared :
       {"extern function heat(vector) : number;", "extern function heat(point) : angle;",
        "extern function heat(point, point) : number;", "extern shape heat(point);",
        "extern metric heat;"}) {
    const LoadedRules loaded =
        loadWith(std::string(declared) + "\n" + kSet + kFree + "}", Externs::Declared, &all);
    ASSERT_EQ(loaded.diagnostics.size(), 1u) << declared << toPretty(loaded.diagnostics);
    EXPECT_EQ(loaded.diagnostics[0].message, "'heat' is registered otherwise");
    EXPECT_EQ(loaded.diagnostics[0].help,
              "the program or plugin registers `function heat(point) : number`");
    EXPECT_EQ(loaded.diagnostics[0].place.line, 2u);
  }
}

TEST(Externs, MustBeWellFormed) {
  const std::string rest = "\n" + kSet + kFree + "}";
  EXPECT_EQ(onlyFinding("extern function heat;" + rest),
            "S1: a function needs the types of its arguments and of its value");
  EXPECT_EQ(onlyFinding("extern shape egg(point) : number;" + rest),
            "S1: a shape needs the types of its arguments, and has no value");
  EXPECT_EQ(onlyFinding("extern metric mine(point);" + rest),
            "S1: a metric is declared by its name alone");
  EXPECT_EQ(onlyFinding("extern shape egg(point, point, point, point, number);" + rest),
            "Y6: the arguments are more than eight numbers");
  EXPECT_EQ(onlyFinding("extern shape egg(dot);" + rest),
            "S1: expected number, angle, point or vector, found 'dot'");
  EXPECT_EQ(onlyFinding("extern rule egg(point);" + rest),
            "S1: expected function, shape or metric, found 'rule'");
  EXPECT_EQ(onlyFinding("extern shape hull(point);" + rest),
            "R2: 'hull' is a function of the language");
}

TEST(Externs, OfTestsLeaveTheRulesKnown) {
  const LoadedRules loaded =
      loadWith("extern function heat(point) : number;\n" + kSet + kFree +
                   "}\nproperty \"cold\" forall match of \"free\" { expect heat(c) < 1; }\n",
               Externs::Declared);
  EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  EXPECT_EQ(loaded.file->missing.size(), 1u);
  EXPECT_TRUE(unknownRules(loaded).empty());
}

TEST(Externs, MayBeDeclaredAlikeInSeveralFiles) {
  LoadOptions options;
  options.externs = Externs::Declared;
  options.unsaved = [](const std::filesystem::path& path) -> std::optional<std::string> {
    const std::string name = path.filename().string();
    if (name != "one.af2" && name != "two.af2" && name != "other.af2") return std::nullopt;
    const std::string type = name == "other.af2" ? "vector" : "point";
    return "af2 1;\nextern function heat(" + type + ") : number;\n";
  };
  const auto errorsWith = [&](const std::string& items) {
    const LoadedRules loaded =
        loadRulesFromText("test.af2", "af2 1;\n" + items + kSet + kFree + "}", options);
    return loaded.diagnostics.size();
  };
  const std::string own = "extern function heat(point) : number;\n";
  EXPECT_EQ(errorsWith("import \"one.af2\";\nimport \"two.af2\";\n" + own), 0u);
  EXPECT_EQ(errorsWith("import \"one.af2\";\nimport \"other.af2\";\n"), 1u);
  EXPECT_EQ(errorsWith("import \"other.af2\";\n" + own), 1u);
  EXPECT_EQ(errorsWith(own + own), 1u);
}

TEST(Externs, OfAnImportedFileAreKnown) {
  LoadOptions options;
  options.externs = Externs::Declared;
  options.unsaved = [](const std::filesystem::path& path) -> std::optional<std::string> {
    if (path.filename() != "lib.af2") return std::nullopt;
    return "af2 1;\nextern function heat(point) : number;\n";
  };
  for (const char* call : {"lib.heat(c)", "heat(c)"}) {
    const std::string as = call[0] == 'l' ? " as lib" : "";
    const LoadedRules loaded = loadRulesFromText(
        "test.af2",
        "af2 1;\nimport \"lib.af2\"" + as + ";\n" + kSet + kFree + "require " + call + " < 1; }",
        options);
    EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
    ASSERT_EQ(loaded.file->missing.size(), 1u);
    EXPECT_EQ(loaded.file->missing[0].home, loaded.file->modules[1].get());
  }
}

}  // namespace
}  // namespace af2::dsl
