// What filling a face asks of the surface under it, whatever that is made of.
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
  /// Charts of a kind that looks at the surface from each base edge anew. They may refer to this
  /// surface.
  virtual std::unique_ptr<AF2LocalTransformMaker> makeCharts(ChartKind kind) const = 0;
  /// The map of a kind that lays out the whole face; null for the others. It may refer to this
  /// surface.
  virtual std::unique_ptr<PlaneMap> makePlaneMap(ChartKind) const { return nullptr; }
  /// The surface by parameters (u, v), in which its boundaries are given; null: it has none.
  virtual const ParametricSurface* inParameters() const { return nullptr; }

 protected:
  ChartedSurface() = default;
  ChartedSurface(const ChartedSurface&) = default;
  ChartedSurface& operator=(const ChartedSurface&) = default;
};

}  // namespace af2::geometry
