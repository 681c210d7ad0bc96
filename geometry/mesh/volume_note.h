// Compares the volume that a mesh encloses with that of its model.
// Not installed.
#pragma once

#include <string>

namespace af2::geometry {

/// A note if the volume that a mesh encloses differs from `wanted` by more than 2 %; empty if
/// not. Elements that are large beside the bends of a surface cut off what is outside of them.
///
/// of  whose volume is wanted, such as "the triangles of the file"
std::string volumeNote(double enclosed, double wanted, const std::string& of);

}  // namespace af2::geometry
