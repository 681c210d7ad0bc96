// Sizes that grow with the distance from places that want small ones.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/pair.h"
#include "engine/base/point.h"

namespace af2::geometry {

/// A ball that wants a size, which may grow with the distance from it.
struct SizeSource {
  Point3 position;
  double size = 0;
  double radius = 0;
};

/// The smallest of source.size + growth * distance over all sources: a tree of boxes around them,
/// so that most are never looked at.
class AF2_EXPORT GrowingSize {
 public:
  /// largest  the size where no source reaches; may be infinite
  GrowingSize(std::vector<SizeSource> sources, double growth, double largest);
  double at(const Point3& position) const;
  bool isEmpty() const { return sources_.empty(); }

 private:
  struct Box {
    Point3 low, high;
    double size = 0;       ///< the smallest size in it
    double atCentres = 0;  ///< the smallest of size - growth * radius
  };
  /// The boxes of both halves of some sources, side by side.
  struct Halves {
    Pair lowX, lowY, lowZ, highX, highY, highZ, size, atCentres;
  };
  Box build(std::size_t node, std::size_t first, std::size_t last);
  Box boxOf(std::size_t first, std::size_t last) const;
  void divide(const Box& box, std::size_t first, std::size_t half, std::size_t last);
  void look(std::size_t node, std::size_t first, std::size_t last, const Point3& position,
            double& least) const;
  Pair leastIn(const Halves& halves, const Point3& position) const;

  std::vector<SizeSource> sources_;
  std::vector<Halves> halves_;  ///< a heap: the halves of those at i are at 2 i + 1 and 2 i + 2
  double growth_, largest_;
};

/// Without the sources, all of sizes > 0, that want nowhere less than the others do.
AF2_EXPORT std::vector<SizeSource> uncovered(std::vector<SizeSource> sources, double growth);

}  // namespace af2::geometry
