// One rule file with the names that it defines.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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

/// A `def` or a `metric`.
struct FunctionName {
  const std::vector<Name>* parameters = nullptr;
  const Expr* body = nullptr;
  bool isMetric = false;
  bool isBroken = false;  ///< told about where it is defined; calls cause no further errors
  const Module* home = nullptr;
  Span span;
};

struct TemplateName {
  const Template* text = nullptr;
  const Module* home = nullptr;
  Span span;
};

/// A file as it is being worked on. The tree stays where it is, so that pointers into it hold.
struct Module {
  explicit Module(SourceText text) : source(std::move(text)) {}
  SourceText source;
  ParsedFile parsed;
  std::map<std::string, ConstantName> constants;
  std::map<std::string, FunctionName> functions;
  std::map<std::string, TemplateName> templates;
  std::map<std::string, const Module*>
      imports;                   ///< by the name given with `as`, or the file's stem
  bool hasBrokenImport = false;  ///< names may be missing that would have come from there
  std::map<std::string, Span> brokenNames;  ///< perhaps defined in what could not be read
};

}  // namespace af2::dsl
