// Divides the curves of a domain, each once.
// Not installed.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "geometry/domain/domain_model.h"
#include "geometry/edges/divided_edges.h"
#include "geometry/sizes/growing_size.h"

namespace af2::geometry {

/// The sizes that are wanted on a domain, by face and by curve.
struct DomainSizes {
  DomainSize byPosition;
  std::vector<double> onFace;    ///< by face
  std::map<int, double> onEdge;  ///< by id of an edge, instead of those of its faces
  std::shared_ptr<const GrowingSize> nearLoosePoints;         ///< null: there are none
  std::vector<std::shared_ptr<const CurvatureLimit>> limits;  ///< by face; null: it is plane
};

/// Segments are as long as the sizes want along the curve, or lie between the points that are given
/// for it. Closed curves have at least three, curves with the same two ends at least two.
///
/// Throws InputError if the points given for a curve do not lie on it, in order and apart, or if
/// there would be far too many segments.
DividedEdges divideCurves(const DomainModel& model, const DomainSizes& sizes, double growth,
                          const EdgePoints& given);

}  // namespace af2::geometry
