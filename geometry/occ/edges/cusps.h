// Cusps: edges of a face that leave a common vertex without an angle, like circle and tangent.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "geometry/occ/edges/edge_parts.h"
#include "geometry/occ/edges/edge_segments.h"
#include "geometry/occ/edges/open_ends.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// The distance from its end within which an edge must have no vertex: there the other edge of the
/// cusp is so near that an element between them would have an angle below one degree.
using CuspLengths = std::map<EdgeEnd, double>;

/// The distance is at most twice the wanted size, where the angle must be at least 0.53 degrees;
/// there is none where edges meet at an angle that does not open with the distance.
///
/// ends, samples  by edge; [0] is edge 1
CuspLengths cuspsOf(const ModelShape& model, const std::vector<Ends>& ends,
                    const std::vector<EdgeSamples>& samples);

/// Parameters that divide a part of an edge, ends included, as divideFromTips does; segments at
/// cusps have at least the length that the cusp needs.
std::vector<double> divideFromCusps(const ModelShape& model, const EdgePart& part,
                                    const CuspLengths& cusps,
                                    const std::map<std::uint32_t, double>& tips,
                                    AskedSegments asked, const CadSizes& sizes);

}  // namespace af2::geometry
