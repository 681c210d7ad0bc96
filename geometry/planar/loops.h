// From segments in the plane to the regions that they bound.
#pragma once

#include <string>
#include <vector>

#include "geometry/planar/poly_file.h"

namespace af2::geometry {

/// A piece of a segment between two points of a PlanarRegions.
struct PlanarPiece {
  int from = 0, to = 0;
  int segment = 0;  ///< index in the domain
};

/// One piece as a region runs along it, with the region on the left.
struct DirectedPiece {
  int piece = 0;
  bool reversed = false;
};

/// A connected region: its outer loop first, then the loops around what is left out inside, and
/// around segments that end inside.
struct PlanarRegion {
  std::vector<std::vector<DirectedPiece>> loops;
  std::vector<int> isolated;  ///< points inside that no segment uses
  double area = 0;
  int domain = PlanarDomain::kAnyDomain;  ///< of the first region point inside
};

struct PlanarRegions {
  std::vector<Point2> points;   ///< each position once
  std::vector<bool> isBlurred;  ///< by point: others or segments lay beside it, too near to matter
  std::vector<PlanarPiece> pieces;  ///< that meet at their ends only
  std::vector<PlanarRegion> regions;
  std::vector<std::string> notes;  ///< on points of holes and regions that have no effect

  int start(DirectedPiece d) const {
    const PlanarPiece& p = pieces[static_cast<std::size_t>(d.piece)];
    return d.reversed ? p.to : p.from;
  }
  int end(DirectedPiece d) const { return start({d.piece, !d.reversed}); }
};

/// Finds the bounded regions of a domain, less those with a hole point inside. All decisions are
/// exact.
///
/// Points with the same position are taken as one, equal segments likewise; a segment on which a
/// point lies is split there. Throws InputError if segments cross, if nothing is enclosed, or if a
/// coordinate is no finite number or a segment names no point.
///
/// blur  points nearer to each other, or to a segment, count as the same, or as on it
PlanarRegions findRegions(const PlanarDomain& domain, double blur = 0);

/// The order of points from left to right, and from below to above where they stand on each other.
inline bool before(Point2 p, Point2 q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

}  // namespace af2::geometry
