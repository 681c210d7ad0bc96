// Shapes whose numbers are computed at a match.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "dsl/program/program.h"
#include "dsl/program/values.h"
#include "engine/rule/free_zone.h"

namespace af2::dsl {

/// A tree of shape constructors, with the program that computes its numbers.
class ShapeProgram {
 public:
  ShapeProgram(const ProgramBuilder& builder, const ShapeValue& shape);

  /// The tree of constructors, and its numbers in the order of the tree: for each shape its points,
  /// its own numbers, then those of its parts.
  const ShapeValue& shape() const { return shape_; }
  const Program& program() const { return program_; }

  /// Nothing if a number has no value.
  std::optional<Shape> shapeAt(const AF2Binding& binding) const;
  /// 1 or 0: whether a point lies in the closed shape; NaN if the shape is invalid.
  double holds(const AF2Binding& binding, Point2 point) const;

 private:
  Shape build(const ShapeValue& shape, const AF2Binding& binding, std::span<const double> numbers,
              std::size_t& next) const;
  ShapeValue shape_;
  Program program_;
};

/// The zone clauses of a rule, unless they are a single list of corners.
class ShapeZoneDef final : public AF2FreeZoneDef {
 public:
  struct Alternative {
    std::shared_ptr<const AF2BindingFunction> when;  ///< null: always
    std::shared_ptr<const ShapeProgram> shape;
  };

  /// The zone is the first alternative whose condition holds. If no condition holds, the match is
  /// refused.
  /// cornerVertices  see AF2FreeZoneDef
  explicit ShapeZoneDef(std::vector<Alternative> alternatives,
                        std::vector<std::int8_t> cornerVertices = {});

  Made makeFreeZone(const AF2Binding& binding) const override;
  std::span<const std::int8_t> cornerVertices() const override { return cornerVertices_; }
  /// The shape at a match, for pictures and checks; nothing if there is none.
  std::optional<Shape> shapeAt(const AF2Binding& binding) const;
  std::span<const Alternative> alternatives() const { return alternatives_; }

 private:
  std::vector<Alternative> alternatives_;
  std::vector<std::int8_t> cornerVertices_;
};

}  // namespace af2::dsl
