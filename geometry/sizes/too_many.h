// Sizes that ask for more elements than there can be, or for smaller ones than can be placed.
#pragma once

namespace af2::geometry {

/// Throws InputError if a mesh is to have more elements than can be numbered. It says so before the
/// memory is full.
///
/// elements  about how many there would be
void refuseTooMany(double elements);

/// Throws InputError if coordinates as large as these, of a model of that extent, blur elements of
/// the size.
void refuseBlurred(double farthest, double extent, double size);

}  // namespace af2::geometry
