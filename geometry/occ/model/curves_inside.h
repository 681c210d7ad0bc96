// Curves inside faces of a CAD model, besides those that the file has.
#pragma once

#include <span>
#include <vector>

#include "engine/base/export.h"
#include "geometry/occ/model/model.h"

namespace af2::geometry {

/// The model with further edges inside its faces, which every mesh keeps. Their ids follow those of
/// the model.
///
/// curves  each with at least two points, in order. Between two points, which must be on the same
///         face, a curve is straight in the parameters of the surface; on planes, cylinders and
///         cones that is the shortest way. Points may be on edges and at vertices of the model, and
///         on other curves if these have a point there.
///
/// Throws InputError, with the number of the curve and the place, for points that are on no face,
/// within a hundred-thousandth of the diagonal, and for parts that are not inside one face.
AF2_EXPORT Model withCurvesInside(const Model& model, std::span<const std::vector<Point3>> curves);

}  // namespace af2::geometry
