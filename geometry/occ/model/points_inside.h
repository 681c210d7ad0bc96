// Vertices inside faces of a CAD model, besides those that the file has.
#pragma once

#include <span>

#include "engine/base/export.h"
#include "geometry/occ/model/model.h"

namespace af2::geometry {

/// The model with further vertices inside its faces, which become vertices of every mesh at exactly
/// these coordinates. A point that two faces have, such as at an interface, is given to the first
/// of them.
///
/// Throws InputError, with the point, if a point is on no face, within a hundred-thousandth of the
/// diagonal, or on an edge.
AF2_EXPORT Model withPointsInside(const Model& model, std::span<const Point3> points);

}  // namespace af2::geometry
