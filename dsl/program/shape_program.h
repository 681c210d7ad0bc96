// Shapes whose numbers are worked out at a match.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "dsl/program/program.h"
#include "dsl/program/values.h"
#include "engine/rule/free_zone.h"

namespace af2::dsl {

/// A tree of shape constructors together with the program that works out its numbers.
class ShapeProgram {
 public:
  ShapeProgram(const ProgramBuilder& builder, const ShapeValue& shape);

  /// The tree of constructors, and its numbers in the order of the tree: of each shape its points,
  /// its own numbers, then those of its parts.
  const ShapeValue& shape() const { return shape_; }
  const Program& program() const { return program_; }

  /// Nothing where a number has no value.
  std::optional<Shape> shapeAt(const AF2Binding& binding) const;
  /// 1 or 0: whether a point lies in the closed shape; NaN where it has no valid form.
  double holds(const AF2Binding& binding, Point2 point) const;

 private:
  Shape build(const ShapeValue& shape, const AF2Binding& binding, std::span<const double> numbers,
              std::size_t& next) const;
  ShapeValue shape_;
  Program program_;
};

/// The zone clauses of a rule that are not one list of corners.
class ShapeZoneDef final : public AF2FreeZoneDef {
 public:
  struct Alternative {
    std::shared_ptr<const AF2BindingFunction> when;  ///< null: always
    std::shared_ptr<const ShapeProgram> shape;
  };

  /// The first alternative whose condition holds is the zone; if none does, the match is refused.
  explicit ShapeZoneDef(std::vector<Alternative> alternatives);

  Made makeFreeZone(const AF2Binding& binding) const override;
  /// The shape at a match, for pictures and checks; nothing if there is none.
  std::optional<Shape> shapeAt(const AF2Binding& binding) const;
  std::span<const Alternative> alternatives() const { return alternatives_; }

 private:
  std::vector<Alternative> alternatives_;
};

}  // namespace af2::dsl
