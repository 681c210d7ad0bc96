// Constants that several folders use, each with its unit and its reason.
// Not installed.
#pragma once

#include <numbers>

namespace af2::geometry {

/// A degree, in radians.
inline constexpr double kDegree = std::numbers::pi / 180;

/// What is smaller than this share of the wanted size is not to be seen in a mesh; to keep it would
/// take hundreds of times more elements around it, or leave useless ones.
inline constexpr double kUnseen = 5e-5;

/// Elements with an angle below this, in degrees, are hardly of use.
inline constexpr double kUselessAngle = 0.7;

/// Edges and strips narrower than this share of the size of a mesh are told as defects: elements
/// there are ten times smaller than asked for, or ten times longer than wide.
inline constexpr double kTinyShare = 0.1;

}  // namespace af2::geometry
