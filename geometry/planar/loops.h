// Finds the regions that segments in the plane bound.
#pragma once

#include <string>
#include <vector>

#include "geometry/planar/poly_file.h"

namespace af2::geometry {

/// A piece of a segment, between two points of PlanarRegions.
struct PlanarPiece {
  int from = 0, to = 0;
  int segment = 0;  ///< index in the domain
};

/// One piece in the direction in which a region uses it, with the region on the left.
struct DirectedPiece {
  int piece = 0;
  bool reversed = false;
};

/// A connected region: its outer loop first, then the loops around holes, and around segments that
/// end inside.
struct PlanarRegion {
  std::vector<std::vector<DirectedPiece>> loops;
  std::vector<int> isolated;  ///< points inside that no segment uses
  double area = 0;
  int domain = PlanarDomain::kAnyDomain;  ///< of the first region point inside
};

struct PlanarRegions {
  std::vector<Point2> points;       ///< each position once
  std::vector<bool> isBlurred;      ///< by point: nearby points or segments were merged with it
  std::vector<PlanarPiece> pieces;  ///< which meet only at their ends
  std::vector<PlanarRegion> regions;
  std::vector<std::string> notes;  ///< about hole points and region points without effect

  int start(DirectedPiece d) const {
    const PlanarPiece& p = pieces[static_cast<std::size_t>(d.piece)];
    return d.reversed ? p.to : p.from;
  }
  int end(DirectedPiece d) const { return start({d.piece, !d.reversed}); }
};

/// Finds the bounded regions of a domain, less those with a hole point inside. All decisions are
/// exact.
///
/// Points with the same position are merged, and so are equal segments; a segment is split at a
/// point that is on it. Throws InputError if segments cross, if nothing is enclosed, if a
/// coordinate is not finite, or if a segment refers to a point that does not exist.
///
/// blur  distance below which points are merged, or count as on a segment
PlanarRegions findRegions(const PlanarDomain& domain, double blur = 0);

/// The order of points by x, and by y where x is equal.
inline bool before(Point2 p, Point2 q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

}  // namespace af2::geometry
