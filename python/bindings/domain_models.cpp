// Planar domains and surfaces of triangles.
#include <af2/engine/error.h>
#include <af2/geometry/domain_defects.h>
#include <af2/geometry/facets.h>
#include <af2/geometry/inside_domain.h>
#include <af2/geometry/mesh_faceted.h>
#include <af2/geometry/mesh_planar.h>
#include <af2/geometry/nearest_on_facets.h>
#include <af2/geometry/planar_file.h>
#include <af2/geometry/points_in_domain.h>

#include <algorithm>
#include <map>
#include <set>

#include "python/bindings/model.h"

namespace af2::python {
namespace {

class DomainPlaces final : public Places {
 public:
  explicit DomainPlaces(std::shared_ptr<const geometry::DomainModel> model)
      : model_(std::move(model)), points_(*model_) {}

  std::vector<FoundPoint> nearest(std::span<const Point3> points, std::span<const int> faces,
                                  int) const override {
    std::vector<FoundPoint> found;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto [point, face, distance] = points_.nearest(points[i], faces.empty() ? 0 : faces[i]);
      found.push_back({point, face, distance});
    }
    return found;
  }
  std::vector<FoundPoint> at(int face, std::span<const Point2> parameters) const override {
    std::vector<FoundPoint> found;
    for (const auto& [u, v] : parameters) found.push_back({points_.at(face, u, v), face, 0});
    return found;
  }

 private:
  std::shared_ptr<const geometry::DomainModel> model_;
  geometry::PointsInDomain points_;
};

class TrianglePlaces final : public Places {
 public:
  explicit TrianglePlaces(std::shared_ptr<const geometry::Facets> facets)
      : facets_(std::move(facets)) {}

  std::vector<FoundPoint> nearest(std::span<const Point3> points, std::span<const int>,
                                  int threads) const override {
    const auto nearest = geometry::nearestPoints(*facets_, points, threads);
    std::vector<FoundPoint> found;
    for (std::size_t i = 0; i < points.size(); ++i)
      found.push_back({{nearest[i].position, nearest[i].normal, 0, 0},
                       0,
                       distance(points[i], nearest[i].position)});
    return found;
  }
  std::vector<FoundPoint> at(int, std::span<const Point2>) const override {
    throw InputError("a surface of triangles has no parameters; mesh.snap finds points on it");
  }

 private:
  std::shared_ptr<const geometry::Facets> facets_;
};

/// With the given size, or a hundredth of the extent.
template <class Points>
geometry::MeshingOptions withSize(double size, const Points& points) {
  auto low = points.front(), high = low;
  for (const auto& p : points) {
    low.x = std::min(low.x, p.x), high.x = std::max(high.x, p.x);
    low.y = std::min(low.y, p.y), high.y = std::max(high.y, p.y);
    if constexpr (requires { p.z; }) low.z = std::min(low.z, p.z), high.z = std::max(high.z, p.z);
  }
  geometry::MeshingOptions options;
  options.sizes.size = size > 0 ? size : distance(low, high) / 100;
  return options;
}

int edgeCount(const geometry::DomainModel& model) {
  int edges = 0;
  for (const geometry::DomainCurve& curve : model.curves) edges = std::max(edges, curve.id);
  return edges;
}

class PlanarModel final : public MeshableModel {
 public:
  explicit PlanarModel(geometry::PlanarDomain domain) : domain_(std::move(domain)) {}

  const char* kind() const override { return "planar"; }

  Meshed mesh(const Request& request, const AF2Algorithm& algorithm) const override {
    constexpr double kUnseen = 5e-5;  // of the size: planarModel merges points that are as near
    const geometry::PlanarDomain domain =
        geometry::withInside(domain_, request.points, request.curves);
    const auto model = std::make_shared<const geometry::DomainModel>(
        geometry::planarModel(domain, request.options));
    geometry::requireInside(*model, request.points, request.curves,
                            kUnseen * request.options.sizes.size);
    return meshedDomain(model, request, algorithm);
  }

  Parts parts(double size, const std::shared_ptr<Call>&) const override {
    return partsOf(geometry::planarModel(domain_, withSize(size, domain_.points)));
  }
  std::vector<geometry::Defect> defects(double size, const std::shared_ptr<Call>&) const override {
    const geometry::MeshingOptions options = withSize(size, domain_.points);
    return geometry::findDefects(geometry::planarModel(domain_, options), options.sizes.size);
  }

 private:
  geometry::PlanarDomain domain_;
};

class TriangleModel final : public MeshableModel {
 public:
  explicit TriangleModel(geometry::Facets facets)
      : facets_(std::make_shared<const geometry::Facets>(std::move(facets))) {}

  const char* kind() const override { return "triangles"; }
  std::vector<std::string> notes() const override { return facets_->notes; }

  Meshed mesh(const Request& request, const AF2Algorithm& algorithm) const override {
    geometry::ModelMesh mesh = geometry::meshFaceted(
        *facets_, algorithm, request.options, [&](const geometry::DomainModel& model) {
          checkIds(request, static_cast<int>(model.faces.size()), edgeCount(model));
        });
    return {std::move(mesh), std::make_shared<const TrianglePlaces>(facets_)};
  }

  Parts parts(double size, const std::shared_ptr<Call>&) const override {
    return partsOf(geometry::facetedModel(*facets_, withSize(size, facets_->vertices)));
  }
  std::vector<geometry::Defect> defects(double size, const std::shared_ptr<Call>&) const override {
    const geometry::MeshingOptions options = withSize(size, facets_->vertices);
    return geometry::findDefects(geometry::facetedModel(*facets_, options), options.sizes.size);
  }

 private:
  std::shared_ptr<const geometry::Facets> facets_;
};

using Indices = py::array_t<std::int64_t, py::array::c_style>;

/// Throws InputError unless there is a point with this index.
template <class Index>
Index checkedIndex(std::int64_t index, std::size_t count, const char* part, py::ssize_t number,
                   const char* point) {
  if (index >= 0 && static_cast<std::size_t>(index) < count) return static_cast<Index>(index);
  throw InputError(std::string(part) + " " + std::to_string(number) + " refers to " + point + " " +
                   std::to_string(index) + "; they are counted from 0 to " +
                   std::to_string(count - 1));
}

void addSegments(const Indices& ends, const Indices& markers, geometry::PlanarDomain& domain) {
  const auto rows = ends.unchecked<2>();
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    geometry::PlanarDomain::Segment& segment = domain.segments.emplace_back();
    const auto end = [&](py::ssize_t k) {
      return checkedIndex<int>(rows(i, k), domain.points.size(), "segment", i, "point");
    };
    segment.from = end(0);
    segment.to = end(1);
    segment.line = segment.edge = static_cast<int>(i) + 1;
    if (markers.size() > 0) segment.marker = static_cast<int>(markers.at(i));
  }
}

}  // namespace

Meshed meshedDomain(std::shared_ptr<const geometry::DomainModel> model, const Request& request,
                    const AF2Algorithm& algorithm) {
  checkIds(request, static_cast<int>(model->faces.size()), edgeCount(*model));
  geometry::ModelMesh mesh = geometry::meshDomain(*model, algorithm, request.options);
  return {std::move(mesh), std::make_shared<const DomainPlaces>(std::move(model))};
}

Parts partsOf(const geometry::DomainModel& model) {
  Parts parts;
  std::map<int, geometry::EdgeEntry> edges;
  for (const geometry::DomainCurve& curve : model.curves) {
    geometry::EdgeEntry& edge = edges[curve.id];
    if (edge.id == 0)
      edge = {curve.id, "line", 0, model.corners[curve.first], model.corners[curve.last], {}};
    edge.to = model.corners[curve.last];
    if (curve.knots.size() > 2) edge.curve = "curve";
    for (std::size_t k = 1; k < curve.knots.size(); ++k)
      edge.length += distance(curve.pointAt(curve.knots[k - 1]), curve.pointAt(curve.knots[k]));
  }
  for (std::size_t i = 0; i < model.faces.size(); ++i) {
    const geometry::DomainFace& face = model.faces[i];
    std::set<int> ids;
    for (const auto& loop : face.loops)
      for (const geometry::CurveUse& use : loop) ids.insert(model.curves[use.curve].id);
    const int id = static_cast<int>(i) + 1;
    for (const int edge : ids) edges[edge].faces.push_back(id);
    parts.faces.push_back({id, face.name, face.surfaceType, face.area, {ids.begin(), ids.end()}});
  }
  for (auto& [id, edge] : edges) parts.edges.push_back(std::move(edge));
  parts.groups = model.groups;
  parts.boundaries = model.boundaries;
  return parts;
}

ModelPointer planarModelFrom(const std::filesystem::path& path) {
  return std::make_shared<const PlanarModel>(geometry::readPlanar(path));
}

ModelPointer planarModelFrom(const py::dict& from) {
  geometry::PlanarDomain domain;
  domain.name = from["name"].cast<std::string>();
  domain.points = points2(from["points"], "points");
  addSegments(from["segments"].cast<Indices>(), from["markers"].cast<Indices>(), domain);
  domain.markerNames = from["marker_names"].cast<std::map<int, std::string>>();
  domain.domainNames = from["domain_names"].cast<std::map<int, std::string>>();
  domain.domainSizes = from["domain_sizes"].cast<std::map<int, double>>();
  domain.holes = points2(from["holes"], "hole_points");
  const auto inside = points2(from["regions"], "regions");
  for (std::size_t i = 0; i < inside.size(); ++i)
    domain.regionPoints.push_back({inside[i], static_cast<int>(i) + 1});
  return std::make_shared<const PlanarModel>(std::move(domain));
}

ModelPointer trianglesFrom(const std::filesystem::path& path) {
  return std::make_shared<const TriangleModel>(geometry::readFacets(path));
}

ModelPointer trianglesFrom(const py::dict& from) {
  geometry::Facets facets;
  facets.name = from["name"].cast<std::string>();
  facets.vertices = points3(from["vertices"], "vertices");
  const auto corners = from["triangles"].cast<Indices>();
  const auto rows = corners.unchecked<2>();
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    std::array<std::uint32_t, 3>& triangle = facets.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      triangle[k] = checkedIndex<std::uint32_t>(rows(i, static_cast<py::ssize_t>(k)),
                                                facets.vertices.size(), "triangle", i, "vertex");
  }
  const auto parts = from["parts"].cast<Indices>();
  facets.group.assign(parts.data(), parts.data() + parts.size());
  facets.groupNames = from["part_names"].cast<std::vector<std::string>>();
  const py::gil_scoped_release noGil;
  return std::make_shared<const TriangleModel>(geometry::repairedFacets(std::move(facets)));
}

}  // namespace af2::python
