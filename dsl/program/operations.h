// The operations of programs in one table.
//
// To add an operation, write its name in `Op`, its row here, its value in program.cpp, its bounds
// and slopes in dsl/proof/box_run.cpp, and a function of the language that uses it in builtins.cpp.
// The two switches do not compile without it; everything else uses the row.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace af2::dsl {

/// The operation of a step. "No value" is NaN while a program runs. It propagates through
/// arithmetic, but a choice that takes the other branch discards it.
enum class Op : unsigned char {
  Unknown,  ///< an expression that could not be compiled; never run
  Constant,
  CoordinateX,  ///< of the matched vertex `index`
  CoordinateY,
  Level,
  Input,  ///< a number from the caller, such as the score in `accept`
  Layer,
  OnBoundary,
  Valence,
  IsFixed,
  SizeOf,
  BeforeX,  ///< of the front vertex before the matched vertex `index`
  BeforeY,
  AfterX,
  AfterY,
  Turn,            ///< of the matched vertex `index`
  TurnOrStraight,  ///< the same; a half turn where it is not known
  Count,           ///< elements wanted at a vertex, by the three bounds of its free angle
  LoopSize,
  SizeAt,
  FrontDistance,
  CurvatureAt,  ///< at a point
  Add,
  Subtract,
  Multiply,
  Divide,
  Negate,
  Power,
  SquareRoot,
  Sine,
  Cosine,
  Tangent,
  Atan2,
  Absolute,
  Minimum,
  Maximum,
  Sweep,  ///< angle counter-clockwise from one vector to another, in (0, 2 pi]
  BisectX,
  BisectY,  ///< unit vector along the bisector of that angle
  Less,
  LessEqual,
  Equal,
  And,
  Or,
  Not,
  Select,
  LeftTurn,      ///< whether three points turn left; exact
  NotRightTurn,  ///< whether three points do not turn right; exact
  Inside,        ///< whether a point lies in a shape
  Call,          ///< a registered function
};

/// What a step needs in addition to the values of its arguments.
enum class Needs {
  Nothing,  ///< computed in advance if the arguments are constants
  Level,    ///< the quality level alone
  Match,    ///< the positions of the matched vertices
  Front,    ///< the front around the match
  Input,    ///< numbers from the caller
  Program,  ///< the shapes and functions of the program
};

/// The meaning of the index of a step.
enum class IndexOf { Nothing, Vertex, Other };

struct Operation {
  Op op;
  std::string_view text;  ///< as `af2 compile --dump` writes it
  int arguments;          ///< the minimum; a Call has as many as its function
  Needs needs;
  IndexOf index = IndexOf::Nothing;
  /// Whether the operation is known to have a value whenever its arguments have values.
  bool isTotal = false;
};

inline constexpr std::array kOperations{
    Operation{Op::Unknown, "unknown", 0, Needs::Program},
    Operation{Op::Constant, "constant", 0, Needs::Nothing, IndexOf::Nothing, true},
    Operation{Op::CoordinateX, "x of", 0, Needs::Match, IndexOf::Vertex, true},
    Operation{Op::CoordinateY, "y of", 0, Needs::Match, IndexOf::Vertex, true},
    Operation{Op::Level, "q", 0, Needs::Level, IndexOf::Nothing, true},
    Operation{Op::Input, "input", 0, Needs::Input, IndexOf::Other},
    Operation{Op::Layer, "layer of", 0, Needs::Front, IndexOf::Vertex},
    Operation{Op::OnBoundary, "on_boundary of", 0, Needs::Front, IndexOf::Vertex},
    Operation{Op::Valence, "valence of", 0, Needs::Front, IndexOf::Vertex},
    Operation{Op::IsFixed, "fixed of", 0, Needs::Front, IndexOf::Vertex},
    Operation{Op::SizeOf, "h of", 0, Needs::Front, IndexOf::Vertex},
    Operation{Op::BeforeX, "x before", 0, Needs::Front, IndexOf::Vertex},
    Operation{Op::BeforeY, "y before", 0, Needs::Front, IndexOf::Vertex},
    Operation{Op::AfterX, "x after", 0, Needs::Front, IndexOf::Vertex},
    Operation{Op::AfterY, "y after", 0, Needs::Front, IndexOf::Vertex},
    Operation{Op::Turn, "turn of", 0, Needs::Front, IndexOf::Vertex},
    Operation{Op::TurnOrStraight, "turn or 180 of", 0, Needs::Front, IndexOf::Vertex},
    Operation{Op::Count, "count of", 3, Needs::Front, IndexOf::Vertex},
    Operation{Op::LoopSize, "loop_size", 0, Needs::Front},
    Operation{Op::SizeAt, "h at", 2, Needs::Front},
    Operation{Op::FrontDistance, "dist_front at", 2, Needs::Front},
    Operation{Op::CurvatureAt, "curvature at", 2, Needs::Front},
    Operation{Op::Add, "add", 2, Needs::Nothing, IndexOf::Nothing, true},
    Operation{Op::Subtract, "subtract", 2, Needs::Nothing, IndexOf::Nothing, true},
    Operation{Op::Multiply, "multiply", 2, Needs::Nothing, IndexOf::Nothing, true},
    Operation{Op::Divide, "divide", 2, Needs::Nothing},
    Operation{Op::Negate, "negate", 1, Needs::Nothing, IndexOf::Nothing, true},
    Operation{Op::Power, "power", 2, Needs::Nothing},
    Operation{Op::SquareRoot, "sqrt", 1, Needs::Nothing},
    Operation{Op::Sine, "sin", 1, Needs::Nothing},
    Operation{Op::Cosine, "cos", 1, Needs::Nothing},
    Operation{Op::Tangent, "tan", 1, Needs::Nothing},
    Operation{Op::Atan2, "atan2", 2, Needs::Nothing},
    Operation{Op::Absolute, "abs", 1, Needs::Nothing},
    Operation{Op::Minimum, "min", 2, Needs::Nothing},
    Operation{Op::Maximum, "max", 2, Needs::Nothing},
    Operation{Op::Sweep, "sweep", 4, Needs::Nothing},
    Operation{Op::BisectX, "bisector x", 4, Needs::Nothing},
    Operation{Op::BisectY, "bisector y", 4, Needs::Nothing},
    Operation{Op::Less, "less", 2, Needs::Nothing, IndexOf::Nothing, true},
    Operation{Op::LessEqual, "less or equal", 2, Needs::Nothing, IndexOf::Nothing, true},
    Operation{Op::Equal, "equal", 2, Needs::Nothing, IndexOf::Nothing, true},
    Operation{Op::And, "and", 2, Needs::Nothing, IndexOf::Nothing, true},
    Operation{Op::Or, "or", 2, Needs::Nothing, IndexOf::Nothing, true},
    Operation{Op::Not, "not", 1, Needs::Nothing, IndexOf::Nothing, true},
    Operation{Op::Select, "select", 3, Needs::Nothing},
    Operation{Op::LeftTurn, "turns left", 6, Needs::Nothing, IndexOf::Nothing, true},
    Operation{Op::NotRightTurn, "does not turn right", 6, Needs::Nothing, IndexOf::Nothing, true},
    Operation{Op::Inside, "inside shape", 2, Needs::Program, IndexOf::Other},
    Operation{Op::Call, "call function", 0, Needs::Program, IndexOf::Other},
};

constexpr const Operation& operationOf(Op op) { return kOperations[static_cast<std::size_t>(op)]; }

static_assert(kOperations.size() == static_cast<std::size_t>(Op::Call) + 1 &&
                  std::ranges::is_sorted(kOperations, {}, &Operation::op) &&
                  std::ranges::adjacent_find(kOperations, {}, &Operation::op) == kOperations.end(),
              "each operation has its row, in the order of Op");

/// Whether a step uses only the values of other steps.
constexpr bool isArithmetic(Op op) {
  return operationOf(op).needs == Needs::Nothing && operationOf(op).arguments > 0;
}

constexpr int argumentCount(Op op) { return operationOf(op).arguments; }

}  // namespace af2::dsl
