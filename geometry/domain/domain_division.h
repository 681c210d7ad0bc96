// Divides the curves of a domain, each once.
// Not installed.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "geometry/domain/domain_model.h"
#include "geometry/edges/divided_edges.h"
#include "geometry/layers/layer_heights.h"
#include "geometry/sizes/finer_inside.h"
#include "geometry/sizes/growing_size.h"

namespace af2::geometry {

/// The sizes that are wanted on a domain, by face and by curve.
struct DomainSizes {
  DomainSize byPosition;
  std::vector<double> onFace;    ///< by face
  std::map<int, double> onEdge;  ///< by id of an edge, instead of those of its faces
  std::shared_ptr<const GrowingSize> nearLoosePoints;  ///< null: there are none
  CurvatureLimits byCurvature;
  FinerInside finer = {};  ///< by position and near loose points
};

/// Segments have the wanted sizes along the curve, or end at the points that are given for it. A
/// closed curve has at least three segments; curves that share both ends have at least two each.
///
/// Throws InputError if the points given for a curve are not on it, in order and distinct, or if
/// there would be far too many segments.
///
/// changes  by curve; a number that would come below the least one is not changed
/// ends     of layers, by number of the curve, from 1: there curves without given points have
///          vertices
DividedEdges divideCurves(const DomainModel& model, const DomainSizes& sizes, double growth,
                          const EdgePoints& given, const SegmentChanges& changes = {},
                          const LayerEnds& ends = {});

}  // namespace af2::geometry
