// Refuses sizes that give too many elements, or elements too small for the coordinates.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "engine/base/error.h"

namespace af2::geometry {

/// The sizes give too many elements.
class TooManyElements : public InputError {
 public:
  TooManyElements(const std::string& what, double factor, bool fitSpooled)
      : InputError(what), factor_(factor), fitSpooled_(fitSpooled) {}
  /// How many times larger the sizes must be.
  double factor() const { return factor_; }
  /// Whether they fit if finished faces are put on disk.
  bool fitSpooled() const { return fitSpooled_; }

 private:
  double factor_;
  bool fitSpooled_;
};

/// The memory that a mesh may take.
struct MemoryLimit {
  double bytes = 0;                                         ///< 0: what is free
  bool isSpooled = false;                                   ///< finished faces are put away
  int threads = 1;                                          ///< so many faces are in work at once
  double onDisk = std::numeric_limits<double>::infinity();  ///< bytes that are free there
  bool isPacked = false;                                    ///< they are put away in memory
};

/// Throws TooManyElements if a mesh would have more elements than can be numbered, or than fit into
/// memory or, finished faces, on the disk.
///
/// elements  approximate numbers, by face
void refuseTooMany(const std::vector<double>& elements, const MemoryLimit& limit);

/// Throws InputError if the rounding of such large coordinates is too coarse for elements of the
/// size, in a model of this extent.
void refuseBlurred(double farthest, double extent, double size);

}  // namespace af2::geometry
