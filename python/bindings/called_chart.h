// Charts that a Python class gives.
#pragma once

#include <af2/engine/local_transform.h>

#include <memory>

#include "python/bindings/called_surface.h"

namespace af2::python {

/// Each chart is what surface.chart returns: an object of Python with to_chart(points, normals,
/// uv), which returns places in the chart, and to_surface(places), which returns parameters, NaN
/// where there are none. `surface` must outlive the charts.
std::unique_ptr<AF2LocalTransformMaker> chartsOfPython(const CalledSurface& surface);

}  // namespace af2::python
