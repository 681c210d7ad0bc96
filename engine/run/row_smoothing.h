// Smoothing of the front and of the elements behind it when a row is complete.
// Not installed.
#pragma once

#include "engine/run/advance.h"

namespace af2 {

/// Moves the vertices of the front, and those behind it that belong to the same elements, towards
/// places where these elements are parallelograms with even sides. Given vertices, and vertices
/// with several places on the front, stay. Returns the number of moves.
///
/// In each round a vertex moves by at most a quarter of the wanted length. No element gets a scaled
/// Jacobian below the smaller of 0.5 and what the worst one has, and the front stays apart from
/// itself. Charts that do not exist leave a vertex where it is.
std::size_t smoothRow(Advance& advance, int rounds);

}  // namespace af2
