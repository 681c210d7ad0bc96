// Constants that several folders use, each with its unit and its reason.
// Not installed.
#pragma once

#include <numbers>

namespace af2::geometry {

/// A degree, in radians.
inline constexpr double kDegree = std::numbers::pi / 180;

/// Details smaller than this share of the wanted size are invisible in a mesh. Keeping them would
/// take hundreds of times more elements around them, or leave useless elements.
inline constexpr double kUnseen = 5e-5;
/// The same for slivers between faces that meet when the sliver is closed, and for small steps.
inline constexpr double kUnseenSliver = 1e-3;

/// Elements with an angle below this, in degrees, are hardly usable.
inline constexpr double kUselessAngle = 0.7;

/// Edges shorter and strips narrower than this share of the mesh size are reported as defects:
/// elements there are ten times smaller than requested, or ten times longer than wide.
inline constexpr double kTinyShare = 0.1;

/// A factor for lengths that are equal but for the rounding of some operations.
inline constexpr double kMoreThanRounding = 1 + 1e-9;

}  // namespace af2::geometry
