#include "cli/inspect/domain_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "geometry/base/box_tree.h"

namespace af2::cli {
namespace {

using geometry::DomainFace;
using geometry::DomainModel;
using Json = nlohmann::ordered_json;

Json placeJson(const Point3& p) { return Json::array({p.x, p.y, p.z}); }

/// Around the boundary, which is around all of a plane face.
Json boxOfFace(const DomainFace& face, const DomainModel& model) {
  geometry::Box3 box;
  for (const auto& loop : face.loops)
    for (const geometry::CurveUse& use : loop) {
      const geometry::DomainCurve& curve = model.curves[use.curve];
      for (const double knot : curve.knots) box.add(curve.pointAt(knot));
    }
  return {{"low", placeJson(box.low)}, {"high", placeJson(box.high)}};
}

double lengthOf(const geometry::DomainCurve& curve) {
  double length = 0;
  for (std::size_t k = 1; k < curve.knots.size(); ++k)
    length += distance(curve.pointAt(curve.knots[k - 1]), curve.pointAt(curve.knots[k]));
  return length;
}

}  // namespace

std::vector<geometry::EdgeEntry> edgesOf(const DomainModel& model) {
  std::vector<geometry::EdgeEntry> edges;
  for (const geometry::DomainCurve& curve : model.curves)
    edges.push_back({curve.id,
                     curve.knots.size() == 2 ? "line" : "curve",
                     lengthOf(curve),
                     model.corners[curve.first],
                     model.corners[curve.last],
                     {}});
  for (std::size_t f = 0; f < model.faces.size(); ++f)
    for (const auto& loop : model.faces[f].loops)
      for (const geometry::CurveUse& use : loop) {
        std::vector<int>& faces = edges[use.curve].faces;
        const int id = static_cast<int>(f) + 1;
        if (faces.empty() || faces.back() != id) faces.push_back(id);
      }
  std::ranges::stable_sort(edges, {}, &geometry::EdgeEntry::id);
  return edges;
}

std::vector<int> edgesOfFace(const DomainFace& face, const DomainModel& model) {
  std::set<int> ids;
  for (const auto& loop : face.loops)
    for (const geometry::CurveUse& use : loop) ids.insert(model.curves[use.curve].id);
  return {ids.begin(), ids.end()};
}

namespace {

Json domainFacesJson(const DomainModel& model, const std::vector<geometry::EdgeEntry>& edges) {
  std::vector<std::set<int>> neighbors(model.faces.size());
  for (const geometry::EdgeEntry& edge : edges)
    for (const int face : edge.faces)
      for (const int other : edge.faces)
        if (other != face) neighbors[static_cast<std::size_t>(face) - 1].insert(other);
  Json faces = Json::array();
  for (std::size_t i = 0; i < model.faces.size(); ++i) {
    const DomainFace& face = model.faces[i];
    faces.push_back({{"id", i + 1},
                     {"name", face.name},
                     {"surface", face.surfaceType},
                     {"area", face.area},
                     {"box", boxOfFace(face, model)},
                     {"edges", edgesOfFace(face, model)},
                     {"neighbors", neighbors[i]}});
  }
  return faces;
}

Json domainEdgesJson(const std::vector<geometry::EdgeEntry>& edges) {
  Json all = Json::array();
  for (const geometry::EdgeEntry& edge : edges)
    all.push_back({{"id", edge.id},
                   {"curve", edge.curve},
                   {"length", edge.length},
                   {"from", placeJson(edge.from)},
                   {"to", placeJson(edge.to)},
                   {"faces", edge.faces}});
  return all;
}

}  // namespace

std::string domainJson(const DomainModel& model) {
  const std::vector<geometry::EdgeEntry> edges = edgesOf(model);
  Json json{{"diagonal", model.diagonal},      {"faces", domainFacesJson(model, edges)},
            {"edges", domainEdgesJson(edges)}, {"groups", Json::array()},
            {"boundaries", Json::array()},     {"notes", model.notes}};
  for (const geometry::FaceGroup& group : model.groups)
    json["groups"].push_back(
        {{"kind", geometry::toString(group.kind)}, {"name", group.name}, {"faces", group.faces}});
  for (const geometry::EdgeGroup& boundary : model.boundaries)
    json["boundaries"].push_back(
        {{"number", boundary.number}, {"name", boundary.name}, {"edges", boundary.edges}});
  // Names that are no UTF-8 must not end the program.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace af2::cli
