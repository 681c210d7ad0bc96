// Makes the meshes of periodic faces images of each other.
#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "engine/base/error.h"
#include "engine/base/place_text.h"
#include "geometry/check/sound_faces.h"
#include "geometry/mesh/unused_vertices.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/merge/mesh_merged.h"
#include "geometry/occ/model/model_shape.h"
#include "geometry/occ/periodic/face_map.h"
#include "geometry/occ/periodic/image_mesh.h"
#include "geometry/occ/periodic/image_middles.h"
#include "geometry/occ/periodic/periodic_faces.h"

namespace af2::geometry {
namespace {

constexpr double kMatching = 1e-5;  // of the diagonal

/// Points along an edge; none if it has no length.
std::vector<Point3> samplesOf(const ModelShape& shape, int edge) {
  constexpr int kParts = 64;
  std::vector<Point3> points;
  if (BRep_Tool::Degenerated(shape.edge(edge))) return points;
  const BRepAdaptor_Curve curve(shape.edge(edge));
  const double first = curve.FirstParameter(), last = curve.LastParameter();
  for (int i = 0; i <= kParts; ++i)
    points.push_back(toPoint(curve.Value(first + (last - first) * i / kParts)));
  return points;
}

double lengthOfLine(const std::vector<Point3>& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += distance(line[i - 1], line[i]);
  return sum;
}

double distanceFromPoints(const std::vector<Point3>& points, const Point3& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Point3& q : points) nearest = std::min(nearest, distance(p, q));
  return nearest;
}

/// Whether a line is the image of another. Ends are exact, and so are middles but for steps.
bool isImage(const FaceMap& map, const std::vector<Point3>& from, const std::vector<Point3>& to,
             double tolerance) {
  if (from.empty() || to.empty()) return false;
  const double whole = lengthOfLine(from);
  if (std::abs(whole - lengthOfLine(to)) > 1e-3 * whole + tolerance) return false;
  const Point3 first = map.at(from.front()), last = map.at(from.back());
  const auto near = [&](const Point3& p, const Point3& q) { return distance(p, q) <= tolerance; };
  if (!(near(first, to.front()) && near(last, to.back())) &&
      !(near(first, to.back()) && near(last, to.front())))
    return false;
  return std::ranges::all_of(
      from, [&](const Point3& p) { return distanceFromPoints(to, map.at(p)) <= whole / 32; });
}

struct EdgeLink {
  int from = 0, to = 0;
  FaceMap map;
};

std::set<int> edgesAround(const ModelShape& shape, int face) {
  std::set<int> edges;
  for (const EdgeUse& use : shape.edgesOfFaces[static_cast<std::size_t>(face) - 1])
    edges.insert(use.id);
  return edges;
}

std::vector<EdgeLink> linksOf(const Model& model, const std::vector<PeriodicPair>& pairs) {
  const ModelShape& shape = model.shape();
  const double tolerance = kMatching * model.diagonal();
  std::vector<EdgeLink> links;
  for (const PeriodicPair& pair : pairs) {
    const FaceMap map(pair.transform);
    std::map<int, std::vector<Point3>> images;
    for (const int edge : edgesAround(shape, pair.second)) images[edge] = samplesOf(shape, edge);
    for (const int edge : edgesAround(shape, pair.first)) {
      const std::vector<Point3> line = samplesOf(shape, edge);
      if (line.empty()) continue;
      const auto found = std::ranges::find_if(
          images, [&](const auto& other) { return isImage(map, line, other.second, tolerance); });
      if (found == images.end())
        throw InputError("faces " + std::to_string(pair.first) + " and " +
                         std::to_string(pair.second) + " are not periodic: edge " +
                         std::to_string(edge) + " of the first has no image on the second");
      links.push_back({edge, found->first, map});
    }
  }
  return links;
}

/// By edge: its vertices between its ends.
std::map<int, std::vector<Point3>> divisionOf(const ModelMesh& mesh) {
  std::map<int, std::vector<Point3>> points;
  for (const EdgeSegment& segment : mesh.segments) {
    const auto [at, isFirst] = points.try_emplace(segment.edge);
    if (!isFirst) at->second.push_back(mesh.vertices[segment.from.value]);
  }
  return points;
}

/// An edge, with the maps that lead there one after the other.
struct Linked {
  int edge = 0;
  std::vector<FaceMap> maps;
};

/// All edges that are images of one another, beginning with `edge`.
std::vector<Linked> linkedWith(int edge, const std::vector<EdgeLink>& links) {
  std::vector<Linked> all{{edge, {}}};
  const auto add = [&](int next, const FaceMap& map, const Linked& from) {
    if (std::ranges::count(all, next, &Linked::edge) > 0) return;
    Linked linked{next, from.maps};
    linked.maps.push_back(map);
    all.push_back(linked);
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Linked here = all[i];
    for (const EdgeLink& link : links) {
      if (link.from == here.edge) add(link.to, link.map, here);
      if (link.to == here.edge) add(link.from, link.map.inverse(), here);
    }
  }
  return all;
}

/// The finest division of edges that are images of one another becomes that of all of them.
EdgePoints alikeDivisions(const std::vector<EdgeLink>& links, const ModelMesh& mesh) {
  const std::map<int, std::vector<Point3>> divided = divisionOf(mesh);
  const auto countOf = [&](int edge) {
    const auto found = divided.find(edge);
    return found == divided.end() ? 0 : found->second.size();
  };
  EdgePoints points;
  for (const EdgeLink& link : links) {
    if (points.contains(link.from)) continue;
    int finest = link.from;
    for (const Linked& linked : linkedWith(link.from, links))
      if (countOf(linked.edge) > countOf(finest)) finest = linked.edge;
    const auto own = divided.find(finest);
    if (own == divided.end()) continue;
    for (const Linked& linked : linkedWith(finest, links)) {
      std::vector<Point3>& images = points[linked.edge] = own->second;
      for (const FaceMap& map : linked.maps)
        for (Point3& p : images) p = map.at(p);
    }
  }
  return points;
}

}  // namespace

ModelMesh meshPeriodic(const Model& model, const AF2Algorithm& algorithm,
                       const MeshingOptions& options, std::vector<PeriodicPair> pairs,
                       const std::optional<MergeRequest>& merge) {
  if (!options.faces.empty() || options.fewest)
    throw InputError("periodic faces need a mesh of all faces, with vertices where sizes ask for");
  if (options.spool.when == SpoolRequest::When::Always)
    throw InputError("a mesh that is put on disk face by face cannot have periodic faces");
  const std::vector<EdgeLink> links = linksOf(model, pairs);
  std::optional<MergeRequest> keeping = merge;
  if (keeping)
    for (const EdgeLink& link : links) keeping->keptEdges.insert({link.from, link.to});
  const auto meshAll = [&](const MeshingOptions& some) {
    return keeping ? meshMerged(model, algorithm, some, *keeping)
                   : meshModel(model, algorithm, some);
  };
  MeshingOptions own = options;
  own.spool = {};
  own.observer = {};
  own.order = 1;
  for (auto& [edge, points] : alikeDivisions(links, meshAll(own))) own.edgePoints[edge] = points;
  own.observer = options.observer;
  own.order = options.order;
  ModelMesh mesh = meshAll(own);
  const bool isSecondOrder = options.order == 2 && !mesh.midsides.empty();
  MiddlesByFace middles;
  if (isSecondOrder) middles = groupedByFace(mesh, takeSecondOrder(mesh));
  for (PeriodicPair& pair : pairs) {
    const std::string fault = makeImage(mesh, pair, kMatching * model.diagonal());
    if (!fault.empty()) {
      mesh.findings.push_back("faces " + std::to_string(pair.first) + " and " +
                              std::to_string(pair.second) + " are not periodic: " + fault);
      continue;
    }
    if (isSecondOrder) makeImagesOfMiddles(mesh, pair, middles);
    mesh.periodic.push_back(std::move(pair));
  }
  dropUnusedVertices(mesh);
  const std::size_t vertices = mesh.vertices.size();
  for (const std::string& finding : keepSoundFaces(mesh, faultsOf(mesh, true, options.threads)))
    mesh.findings.push_back(finding);
  if (mesh.vertices.size() != vertices) mesh.periodic.clear();  // faces failed, which says why
  if (!isSecondOrder) return mesh;
  makeSecondOrder(mesh, middlesOf(mesh, middles), imagesOfSides(mesh));
  addMidsides(mesh);
  return mesh;
}

}  // namespace af2::geometry
