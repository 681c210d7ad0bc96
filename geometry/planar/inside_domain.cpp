#include "geometry/planar/inside_domain.h"

#include <algorithm>
#include <string>
#include <utility>

#include "engine/base/error.h"
#include "engine/base/place_text.h"

namespace af2::geometry {
namespace {

Point2 inPlane(const Point3& p, const std::string& what) {
  if (p.z != 0)
    throw InputError(what + ", " + af2::textOf(p, 6) + ": planar domains are in the plane z = 0");
  return {p.x, p.y};
}

/// Points that no segment uses, such as control points of curves, are no vertices.
void dropUnused(PlanarDomain& domain) {
  std::vector<int> indices(domain.points.size(), -1);
  std::vector<Point2> used;
  const auto renumber = [&](int& i) {
    int& index = indices[static_cast<std::size_t>(i)];
    if (index < 0) {
      index = static_cast<int>(used.size());
      used.push_back(domain.points[static_cast<std::size_t>(i)]);
    }
    i = index;
  };
  for (PlanarDomain::Segment& segment : domain.segments) {
    renumber(segment.from);
    renumber(segment.to);
  }
  domain.points = std::move(used);
  domain.pointLines.clear();
  domain.keepsPoints = true;
}

std::string nameOf(const char* what, std::size_t index) {
  return std::string(what) + " " + std::to_string(index + 1) + " inside the domain";
}

}  // namespace

PlanarDomain withInside(PlanarDomain domain, std::span<const Point3> points,
                        std::span<const std::vector<Point3>> lines) {
  if (points.empty() && lines.empty()) return domain;
  if (!domain.keepsPoints) dropUnused(domain);
  domain.pointLines.clear();
  for (std::size_t i = 0; i < points.size(); ++i)
    domain.points.push_back(inPlane(points[i], nameOf("point", i)));
  int edge = 0;
  for (const PlanarDomain::Segment& segment : domain.segments) edge = std::max(edge, segment.edge);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].size() < 2) throw InputError(nameOf("curve", i) + " needs at least two points");
    for (std::size_t k = 0; k < lines[i].size(); ++k) {
      domain.points.push_back(inPlane(lines[i][k], nameOf("curve", i)));
      if (k == 0) continue;
      PlanarDomain::Segment segment;
      segment.to = static_cast<int>(domain.points.size()) - 1;
      segment.from = segment.to - 1;
      segment.edge = ++edge;
      domain.segments.push_back(segment);
    }
  }
  return domain;
}

void requireInside(const DomainModel& model, std::span<const Point3> points,
                   std::span<const std::vector<Point3>> lines, double near) {
  const auto require = [&](const Point3& p, const std::string& what) {
    const bool isThere = std::ranges::any_of(
        model.corners, [&](const Point3& corner) { return distance(corner, p) <= near; });
    if (!isThere) throw InputError(what + ", " + af2::textOf(p, 6) + ": it is outside");
  };
  for (std::size_t i = 0; i < points.size(); ++i) require(points[i], nameOf("point", i));
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (const Point3& p : lines[i]) require(p, nameOf("a point of curve", i));
}

}  // namespace af2::geometry
