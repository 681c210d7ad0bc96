// One rule file with the names that it defines.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dsl/program/registry.h"
#include "dsl/program/values.h"
#include "dsl/syntax/ast.h"
#include "dsl/syntax/grammar.h"
#include "dsl/text/source_text.h"

namespace af2::dsl {

struct Module;

/// A `const`: a value that needs no match.
struct ConstantName {
  Type type = Type::Any;
  double number = 0, x = 0, y = 0;
  const Module* home = nullptr;
  Span span;
};

/// What an `extern` declares: one of the three, as a program registered it. Where none is
/// registered, it is a stand-in that never has a value, so that the rules can be checked.
struct ExternName {
  std::shared_ptr<const UserFunction> function;
  std::shared_ptr<const UserShape> shape;
  std::shared_ptr<const AF2ElementMetric> metric;
  bool isMissing = false;  ///< whether it is a stand-in
};

/// A `def`, a `metric` or an `extern`.
struct FunctionName {
  const std::vector<Name>* parameters = nullptr;  ///< of an `extern`: the types of the arguments
  const Expr* body = nullptr;
  bool isMetric = false;
  bool isBroken = false;  ///< reported at the definition; calls cause no further errors
  const Module* home = nullptr;
  Span span;
  std::shared_ptr<const ExternName> external = {};  ///< of an `extern`, which has no body
};

struct TemplateName {
  const Template* text = nullptr;
  const Module* home = nullptr;
  Span span;
};

/// A file during compilation. The syntax tree is never moved, so pointers into it stay valid.
struct Module {
  explicit Module(SourceText text) : source(std::move(text)) {}
  SourceText source;
  ParsedFile parsed;
  std::map<std::string, ConstantName> constants;
  std::map<std::string, FunctionName> functions;
  std::map<std::string, TemplateName> templates;
  std::map<std::string, const Module*>
      imports;                              ///< by the name given with `as`, or the file's stem
  bool hasBrokenImport = false;             ///< names of that import may be missing
  std::map<std::string, Span> brokenNames;  ///< names that the unreadable parts may define
};

}  // namespace af2::dsl
