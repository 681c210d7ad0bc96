#include "geometry/fill/boundary_alone_way.h"
#include "geometry/fill/chart_way.h"
#include "geometry/fill/closing_way.h"
#include "geometry/fill/crossed_boundary.h"
#include "geometry/fill/fill_way.h"
#include "geometry/fill/ignoring_normals_way.h"

namespace af2::geometry {

namespace {

constexpr FillWay kWays[] = {{.name = "boundary without crossings",
                              .applies = mayHaveCrossedBoundary,
                              .fill = findCrossedBoundary,
                              .isCondition = true},
                             {.name = "boundary of a strip alone",
                              .applies = needsNoVertices,
                              .fill = fillFromBoundary,
                              .isBetter = isBetterWithoutVertices,
                              .needsNoRule = true},
                             {"charts", isUnfilled, fillThroughCharts},
                             {.name = "closing the rest of the front",
                              .applies = isUnfilled,
                              .fill = fillByClosing,
                              .needsNoRule = true},
                             {.name = "boundary alone",
                              .applies = mayNeedNoVertices,
                              .fill = fillFromBoundary,
                              .isBetter = isBetterWithoutVertices,
                              .needsNoRule = true},
                             {.name = "ignoring normals in the parameters",
                              .applies = canIgnoreNormalsInParameters,
                              .fill = fillIgnoringNormals,
                              .ignoresNormals = true,
                              .needsNoRule = true},
                             {.name = "ignoring normals across loops",
                              .applies = canCloseLoops,
                              .fill = fillAcrossLoops,
                              .ignoresNormals = true,
                              .needsNoRule = true}};

}  // namespace

std::span<const FillWay> fillWays() { return kWays; }

}  // namespace af2::geometry
