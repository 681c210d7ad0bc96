// The functions of the language.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dsl/program/values.h"

namespace af2::dsl {

/// One built-in function.
///
/// `parameters` has one letter for each: n number, r angle or number, x number or angle (all `x` of
/// one call have the same type), p point, v vector, g point or vector (all of the same weight), l
/// any type that can be interpolated (all `l` have the same type), t truth value, w a matched
/// vertex, c a vertex with a known place on the front, e an end of the base edge, s shape. A `*`
/// repeats the letter before it.
struct Builtin {
  std::string_view name;
  std::string_view parameters;
  std::string_view usage;  ///< as shown in diagnostics and editors: "lerp(from, to, t)"
  Value (*make)(const Algebra& algebra, std::span<const Value> arguments);
  std::string_view help;  ///< one sentence
};

std::span<const Builtin> builtins();
const Builtin* findBuiltin(std::string_view name);

/// Metrics, which are 0 for the ideal element and larger for others, or measures, which are larger
/// for better elements.
struct BuiltinMetric {
  std::string_view name;
  int weights;  ///< parameters before the corners
  std::string_view usage;
  /// Corners are three or four points.
  Value (*make)(const Algebra& algebra, std::span<const Value> weights,
                std::span<const Value> corners);
  std::string_view help;  ///< one sentence
};

std::span<const BuiltinMetric> builtinMetrics();
const BuiltinMetric* findBuiltinMetric(std::string_view name);

/// Functions that make shapes: poly, hull, disc, left, sector, grow, and arc inside of poly.
bool isShapeFunction(std::string_view name);

/// The form of a call: "lerp(from, to, t)"; for a name without arguments, the name.
std::string_view usageOf(std::string_view name);

/// A description in one sentence; empty if the language has no such name.
std::string_view helpOf(std::string_view name);

/// Whether a name is one of the above.
bool isBuiltin(std::string_view name);

/// All names, for "did you mean".
std::vector<std::string> builtinNames();

}  // namespace af2::dsl
