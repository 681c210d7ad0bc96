// Sizes that grow with the distance from places that want small ones.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/pair.h"
#include "engine/base/point.h"

namespace af2::geometry {

/// A ball with a wanted size, which grows with the distance from the ball.
struct SizeSource {
  Point3 position;
  double size = 0;
  double radius = 0;
};

/// The smallest of source.size + growth * distance over all sources. A tree of boxes avoids the
/// evaluation of most of them.
class AF2_EXPORT GrowingSize {
 public:
  /// largest  the size that applies where no source gives a smaller one; may be infinite
  /// threads  for making the tree; 0: as many as the caller's TBB arena has
  GrowingSize(std::vector<SizeSource> sources, double growth, double largest, int threads = 1);
  double at(const Point3& position) const { return at(position, largest_); }
  /// Not more than `most`: what is known to be too large is not evaluated.
  double at(const Point3& position, double most) const;
  /// Lowers each size to that at its position, where that is smaller. Costs less than to ask for
  /// one after the other where positions follow each other closely.
  void lower(std::span<const Point3> at, std::span<double> sizes) const;
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
  Box build(std::size_t node, std::size_t first, std::size_t last, int threads);
  Box boxOf(std::size_t first, std::size_t last) const;
  void divide(const Box& box, std::size_t first, std::size_t half, std::size_t last);
  void look(std::size_t node, std::size_t first, std::size_t last, const Point3& position,
            double& least) const;
  bool lowerTo(std::size_t source, const Point3& position, double& least) const;
  static Pair squaredDistances(const Halves& halves, const Point3& position);

  std::vector<SizeSource> sources_;
  std::vector<Halves> halves_;  ///< a heap: the halves of those at i are at 2 i + 1 and 2 i + 2
  double growth_, perGrowth_, largest_;
};

/// Removes the sources that nowhere give a smaller size than the others do. All sizes must be > 0.
AF2_EXPORT std::vector<SizeSource> uncovered(const std::vector<SizeSource>& sources, double growth,
                                             int threads = 1);

}  // namespace af2::geometry
