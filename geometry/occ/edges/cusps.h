// Where edges of a face part from a common vertex without an angle, as a circle and a tangent do.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "geometry/occ/edges/edge_parts.h"
#include "geometry/occ/edges/edge_samples.h"
#include "geometry/occ/edges/open_ends.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// How far from its end an edge is to have no vertex: nearer to it, the edge that parts from it
/// there is so near that an element between them would have less than one degree.
using CuspLengths = std::map<EdgeEnd, double>;

/// At most two times the wanted size, if there are 0.53 degrees there; none where edges part at an
/// angle that no length opens.
///
/// ends, samples  by edge; [0] is edge 1
CuspLengths cuspsOf(const ModelShape& model, const std::vector<Ends>& ends,
                    const std::vector<EdgeSamples>& samples);

/// Parameters that divide a part of an edge, ends included, as divideFromTips does; segments at
/// cusps are no shorter than it takes there.
std::vector<double> divideFromCusps(const ModelShape& model, const EdgePart& part,
                                    const CuspLengths& cusps,
                                    const std::map<std::uint32_t, double>& tips, std::size_t least,
                                    const CadSizes& sizes);

}  // namespace af2::geometry
