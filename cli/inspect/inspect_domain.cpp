#include "cli/inspect/inspect_domain.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <string>

#include "cli/inspect/domain_json.h"
#include "cli/inspect/inspect_tables.h"
#include "cli/meshing/mesh_summary.h"
#include "cli/meshing/model_formats.h"
#include "cli/program/exit_code.h"
#include "geometry/base/box_tree.h"
#include "geometry/domain/domain_defects.h"
#include "geometry/faceted/mesh_faceted.h"
#include "geometry/planar/mesh_planar.h"
#include "geometry/planar/planar_file.h"

namespace af2::cli {
namespace {

using geometry::DomainFace;
using geometry::DomainModel;

/// The given size, or the default fraction of the diagonal.
double sizeFor(double asked, const geometry::Box3& box) {
  return asked > 0 ? asked : distance(box.low, box.high) / kSizesPerDiagonal;
}

DomainModel facetedModel(const DomainInspection& request) {
  const geometry::Facets facets = geometry::readFacets(request.model);
  geometry::Box3 box;
  for (const Point3& p : facets.vertices) box.add(p);
  geometry::MeshingOptions options;
  options.sizes.size = sizeFor(request.size, box);
  return geometry::facetedModel(facets, options);
}

DomainModel planarModel(const DomainInspection& request) {
  const geometry::PlanarDomain domain = geometry::readPlanar(request.model);
  geometry::Box3 box;
  for (const Point2 p : domain.points) box.add(Point3{p.x, p.y, 0});
  geometry::MeshingOptions options;
  options.sizes.size = sizeFor(request.size, box);
  return geometry::planarModel(domain, options);
}

std::string edgesText(const DomainFace& face, const DomainModel& model) {
  constexpr std::size_t kMaxNamed = 8;
  const std::vector<int> ids = edgesOfFace(face, model);
  std::string text;
  for (std::size_t i = 0; i < std::min(kMaxNamed, ids.size()); ++i)
    text += fmt::format("{}{}", i > 0 ? ", " : "", ids[i]);
  if (ids.size() > kMaxNamed) text += fmt::format(" and {} more", ids.size() - kMaxNamed);
  return text;
}

void printFaces(const DomainModel& model) {
  fmt::print("{:>8}  {:<12}  {:>12}  {}\n", "face", "surface", "area", "edges");
  for (std::size_t i = 0; i < model.faces.size(); ++i) {
    const DomainFace& face = model.faces[i];
    fmt::print("{:>8}  {:<12}  {:>12.6g}  {}\n", i + 1, face.surfaceType, face.area,
               edgesText(face, model));
    for (const std::string& note : face.notes) fmt::print("{:>8}  note: {}\n", "", note);
  }
}

void printSurfaceTypes(const DomainModel& model) {
  std::map<std::string, int> counts;
  for (const DomainFace& face : model.faces) ++counts[face.surfaceType];
  for (const auto& [type, count] : counts) fmt::print("{:>8}  {}\n", count, type);
}

}  // namespace

int inspectDomain(const DomainInspection& request) {
  const DomainModel model = modelKindOf(request.model) == ModelKind::Planar ? planarModel(request)
                                                                            : facetedModel(request);
  if (request.json) {
    fmt::print("{}", domainJson(model));
    return kComplete;
  }
  fmt::print("{} faces, {} edges, {} vertices; diagonal {:.6g}\n", model.faces.size(),
             model.curves.size(), model.corners.size(), model.diagonal);
  fmt::print("{}", notesText(model.notes));
  request.brief ? printSurfaceTypes(model) : printFaces(model);
  if (request.edges) printEdges(edgesOf(model));
  printGroups(model.groups);
  printBoundaries(model.boundaries);
  if (request.brief) return kComplete;
  const double size = request.size > 0 ? request.size : model.diagonal / kSizesPerDiagonal;
  printDefects(geometry::findDefects(model, size), size, request.all);
  return kComplete;
}

}  // namespace af2::cli
