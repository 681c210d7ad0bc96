// Fans of triangles around sharp tips of surfaces, made before the front, because around the tip of
// a needle there is less room than a front needs for one element.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <map>
#include <vector>

#include "geometry/mesh/face_boundary.h"
#include "geometry/mesh/fans.h"
#include "geometry/occ/edges/edge_parts.h"
#include "geometry/occ/edges/edge_segments.h"
#include "geometry/occ/edges/open_ends.h"
#include "geometry/occ/model/model_shape.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

/// By index of a point at which faces have a sharp tip: the length of the segments of all edges
/// there, such that the rims of four elements around it have the wanted size.
///
/// ends, samples  by edge; [0] is edge 1
/// isGiven        by edge: its points are given, so its segments cannot be chosen
std::map<std::uint32_t, double> segmentsAtTips(const ModelShape& model,
                                               const std::vector<Ends>& ends,
                                               const std::vector<EdgeSamples>& samples,
                                               const std::vector<bool>& isGiven);

/// Parameters that divide a part of an edge, ends included: a segment at a sharp tip is as long as
/// the fan around that, the rest has the wanted sizes. A part that is too short for this segment,
/// because another edge ends there, is divided like any other.
///
/// tips  as segmentsAtTips gave them
std::vector<double> divideFromTips(const EdgePart& part,
                                   const std::map<std::uint32_t, double>& tips, AskedSegments asked,
                                   const CadSizes& sizes);

/// Excludes fans around the tips from the loops, where the segments on both sides are equally long.
void leaveOutFans(const FaceSurface& surface, FanElements kind, FaceBoundary& boundary);

}  // namespace af2::geometry
