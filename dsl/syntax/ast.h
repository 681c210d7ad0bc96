// The syntax tree of a rule file, as the parser builds it.
//
// Nothing here is resolved or checked. Every node has a span. A node with an empty span could not
// be read; it has been reported and must be skipped without further messages.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "dsl/syntax/rule_ast.h"
#include "dsl/syntax/rule_set_ast.h"
#include "dsl/syntax/test_ast.h"

namespace af2::dsl {

struct Import {
  Name path;
  std::optional<Name> alias;
};

/// use lib.*; use lib."right 60"; use lib.* except "a", "b";
struct Use {
  Name library;
  std::optional<Name> rule;  ///< nothing: all
  std::vector<Name> except;
};

struct Constant {
  std::string doc;
  Name name;
  Expr value;
};

struct Function {
  std::string doc;
  Name name;
  std::vector<Name> parameters;
  Expr value;
};

struct Metric {
  std::string doc;
  Name name;
  std::vector<Name> parameters;
  Expr value;
};

/// extern function heat(point) : number;
struct Extern {
  std::string doc;
  Name kind;  ///< function, shape or metric
  Name name;
  bool hasList = false;          ///< whether there are parentheses
  std::vector<Name> parameters;  ///< the types of the arguments
  std::optional<Name> result;    ///< the type of the value
};

using ItemContent = std::variant<std::monostate, Import, Use, Constant, Function, Metric, Extern,
                                 RuleSetBlock, Rule, Template, Instance, Test, Property>;

struct Item {
  Span span;
  ItemContent content;
};

struct File {
  std::vector<Item> items;
};

}  // namespace af2::dsl
