// Sizes that ask for more elements than there can be.
#pragma once

namespace af2::geometry {

/// Throws InputError if a mesh is to have more elements than can be numbered. It says so before the
/// memory is full.
///
/// elements  about how many there would be
void refuseTooMany(double elements);

}  // namespace af2::geometry
