// The interface of a face's surface that filling the face needs, for every kind of surface.
#pragma once

#include <memory>

#include "engine/base/export.h"
#include "engine/run/region_split.h"
#include "engine/surface/local_transform.h"
#include "geometry/charts/chart_kind.h"
#include "geometry/charts/metric_chart.h"
#include "geometry/charts/plane_map.h"

namespace af2::geometry {

/// Need not be shared between threads.
class AF2_EXPORT ChartedSurface : public SurfaceEvaluator {
 public:
  virtual bool isPlane() const = 0;
  /// Whether there are charts of a kind for this surface.
  virtual bool has(ChartKind kind) const = 0;
  /// Charts of a kind that has a new chart for each base edge. They may refer to this surface.
  virtual std::unique_ptr<AF2LocalTransformMaker> makeCharts(ChartKind kind) const = 0;
  /// The map of a kind that lays out the whole face; null for the others. It may refer to this
  /// surface.
  virtual std::unique_ptr<PlaneMap> makePlaneMap(ChartKind) const { return nullptr; }
  /// The surface by the parameters (u, v) in which its boundaries are given; null if it has none.
  virtual const ParametricSurface* inParameters() const { return nullptr; }

 protected:
  ChartedSurface() = default;
  ChartedSurface(const ChartedSurface&) = default;
  ChartedSurface& operator=(const ChartedSurface&) = default;
};

}  // namespace af2::geometry
