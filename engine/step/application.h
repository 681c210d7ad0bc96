// The chosen match of a rule, ready to be applied.
// Not installed.
#pragma once

#include <optional>
#include <vector>

#include "engine/step/compiled_rules.h"
#include "engine/step/neighborhood.h"
#include "engine/step/open_places.h"

namespace af2 {

/// A new vertex on the surface, or none. The chart writes it in place, because copying a freshly
/// assembled object is slow.
struct LiftedPoint {
  std::optional<SurfacePoint> point;
  LiftedPoint(const StepChart& chart, Point2 inChart) : point(chart.lift(inChart)) {}
};

/// The chosen candidate, with all data needed to apply it.
struct Application {
  const CompiledRule* rule = nullptr;
  double score = 0;
  OpenPlaces open;
  std::vector<LiftedPoint> newPoints;  ///< by new vertex; all are present
};

/// Whether every corner of the new elements faces the way the surface does, except for as many
/// corners of each element as may be reflex.
bool staysUnfolded(const Front& front, const Application& application, int reflexCorners);

}  // namespace af2
