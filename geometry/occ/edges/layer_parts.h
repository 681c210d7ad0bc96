// Divides edges on which layers of faces end.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include "geometry/layers/layer_heights.h"
#include "geometry/occ/edges/cusps.h"

namespace af2::geometry {

/// Parameters that divide a part of an edge, ends included: at the vertices of layers that end on
/// it, and between them as divideFromCusps does.
std::vector<double> divideBetweenLayers(const ModelShape& model, const EdgePart& part,
                                        const LayerEnds& layers, const CuspLengths& cusps,
                                        const std::map<std::uint32_t, double>& tips,
                                        AskedSegments asked, const CadSizes& sizes);

}  // namespace af2::geometry
