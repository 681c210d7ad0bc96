// Rule sets and their settings in the syntax tree. See ast.h.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "dsl/syntax/rule_ast.h"

namespace af2::dsl {

struct ElementsSetting {
  std::vector<Name> kinds;

  void visitParts(auto&&) const {}  // kinds are keywords
};

struct MatchSetting {
  Expr value;

  void visitParts(auto&& part) const { part(value); }
};

struct FadeSetting {
  Expr value;

  void visitParts(auto&& part) const { part(value); }
};

struct ScoreSetting {
  Name fold;  ///< max, sum or mean
  Expr metric;

  void visitParts(auto&& part) const { part(metric); }
};

struct AcceptSetting {
  std::vector<Expr> conditions;  ///< all must hold

  void visitParts(auto&& part) const {
    for (const Expr& condition : conditions) part(condition);
  }
};

struct ClearSetting {
  Expr value;

  void visitParts(auto&& part) const { part(value); }
};

/// counts 130deg, 235deg, 315deg
struct CountsSetting {
  std::vector<Expr> bounds;

  void visitParts(auto&& part) const {
    for (const Expr& bound : bounds) part(bound);
  }
};

/// columns 0.7..1.4 from layer 3
struct ColumnsSetting {
  Expr low, high, layer;

  void visitParts(auto&& part) const {
    part(low);
    part(high);
    part(layer);
  }
};

/// at row smooth 3
struct RowEndSetting {
  Expr rounds;

  void visitParts(auto&& part) const { part(rounds); }
};

/// at end clean 2
struct EndSetting {
  Expr depth;

  void visitParts(auto&& part) const { part(depth); }
};

struct OrderSetting {
  std::vector<Expr> keys;

  void visitParts(auto&& part) const {
    for (const Expr& key : keys) part(key);
  }
};

/// front rows(start: smallest_turn)
struct RowsSetting {
  std::vector<MetaEntry> arguments;

  void visitParts(auto&&) const {}  // arguments and their values are keywords
};

struct ClassesSetting {
  Expr first, last;

  void visitParts(auto&& part) const {
    part(first);
    part(last);
  }
};

struct ScaleSetting {
  Name unit;

  void visitParts(auto&&) const {}  // units are keywords
};

struct ParitySetting {
  Name parity;

  void visitParts(auto&&) const {}  // parities are keywords
};

struct FinishSetting {
  Name finish;

  void visitParts(auto&&) const {}  // ways to finish are keywords
};

using SettingContent =
    std::variant<std::monostate, ElementsSetting, MatchSetting, FadeSetting, ScoreSetting,
                 AcceptSetting, ClearSetting, OrderSetting, RowsSetting, RowEndSetting, EndSetting,
                 ClassesSetting, ScaleSetting, ParitySetting, CountsSetting, ColumnsSetting,
                 FinishSetting, MetaClause>;

struct Setting {
  Span span;
  SettingContent content;
};

struct RuleSetBlock {
  std::string doc;
  Name name;
  std::optional<Name> base;  ///< extends
  std::vector<Setting> settings;
};

}  // namespace af2::dsl
