// Refuses sizes that give too many elements, or elements too small for the coordinates.
#pragma once

#include <string>

#include "engine/base/error.h"

namespace af2::geometry {

/// The sizes give too many elements.
class TooManyElements : public InputError {
 public:
  TooManyElements(const std::string& what, double factor) : InputError(what), factor_(factor) {}
  /// How many times larger the sizes must be.
  double factor() const { return factor_; }

 private:
  double factor_;
};

/// Throws TooManyElements if a mesh would have more elements than can be numbered, or than fit into
/// memory.
///
/// elements   approximate number
/// maxMemory  bytes for the mesh; 0: what is free
void refuseTooMany(double elements, double maxMemory);

/// Throws InputError if the rounding of such large coordinates is too coarse for elements of the
/// size, in a model of this extent.
void refuseBlurred(double farthest, double extent, double size);

}  // namespace af2::geometry
