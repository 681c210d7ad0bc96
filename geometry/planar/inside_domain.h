// Vertices and lines inside planar domains, besides those of the file.
#pragma once

#include <span>
#include <vector>

#include "engine/base/export.h"
#include "geometry/domain/domain_model.h"
#include "geometry/planar/poly_file.h"

namespace af2::geometry {

/// The domain with further vertices and polylines, which every mesh keeps. The segments of the
/// polylines follow those of the domain.
///
/// Throws InputError for points that are not in the plane z = 0, and for lines with less than two
/// points.
AF2_EXPORT PlanarDomain withInside(PlanarDomain domain, std::span<const Point3> points,
                                   std::span<const std::vector<Point3>> lines);

/// Throws InputError, with the number and the place, if one of the points is not a vertex of the
/// model, because it is outside.
///
/// near  the distance up to which points of the model are merged
AF2_EXPORT void requireInside(const DomainModel& model, std::span<const Point3> points,
                              std::span<const std::vector<Point3>> lines, double near);

}  // namespace af2::geometry
