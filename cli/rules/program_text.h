// Compiled expressions as text, for `af2 compile --dump`.
#pragma once

#include <string>
#include <vector>

#include "dsl/program/program.h"
#include "engine/rule/free_zone.h"
#include "engine/rule/point_transform.h"

namespace af2::cli {

/// Names of the matched vertices of a rule, in pattern order.
using VertexNames = std::vector<std::string>;

/// One step per line, indented by `indent` blanks; the results come last.
std::string programText(const dsl::Program& program, const VertexNames& names, int indent);

/// An affine placement as "x = ..., y = ..." on one line, a program on several lines.
std::string transformText(const AF2PointTransform& transform, const VertexNames& names, int indent);

/// A condition or cost.
std::string functionText(const AF2BindingFunction& function, const VertexNames& names, int indent);

/// A number with the fewest digits that reproduce it exactly.
std::string numberText(double number);

}  // namespace af2::cli
