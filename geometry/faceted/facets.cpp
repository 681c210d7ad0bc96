#include "geometry/faceted/facets.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "engine/base/error.h"
#include "geometry/base/box_tree.h"
#include "geometry/base/words.h"
#include "geometry/faceted/flats.h"
#include "geometry/faceted/formats.h"
#include "geometry/faceted/repair_facets.h"

namespace af2::geometry {
namespace {

/// One vertex for each position, in the order in which they come first.
void mergeVertices(Facets& facets) {
  const auto key = [&](std::uint32_t i) {
    const Point3& p = facets.vertices[i];
    return std::tuple(p.x, p.y, p.z);
  };
  std::vector<std::uint32_t> order(facets.vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::vector<std::uint32_t> first(order.size()), renumbered(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
  std::vector<Point3> merged;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == i) {
      renumbered[i] = static_cast<std::uint32_t>(merged.size());
      merged.push_back(facets.vertices[i]);
    } else {
      renumbered[i] = renumbered[first[i]];
    }
  }
  facets.vertices = std::move(merged);
  for (auto& triangle : facets.triangles)
    for (std::uint32_t& corner : triangle) corner = renumbered[corner];
}

/// Triangles that join three vertices in a row stay: without them the surface would have a slit.
void dropCollapsedTriangles(Facets& facets) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < facets.triangles.size(); ++i) {
    const std::array<std::uint32_t, 3> t = facets.triangles[i];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    if (!facets.group.empty()) facets.group[kept] = facets.group[i];
    facets.triangles[kept++] = t;
  }
  facets.triangles.resize(kept);
  if (!facets.group.empty()) facets.group.resize(kept);
}

/// However far away they are, they do not belong to the surface.
void dropUnusedVertices(Facets& facets) {
  std::vector<bool> isUsed(facets.vertices.size(), false);
  for (const auto& triangle : facets.triangles)
    for (const std::uint32_t corner : triangle) isUsed[corner] = true;
  std::vector<std::uint32_t> renumbered(facets.vertices.size());
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < isUsed.size(); ++i) {
    if (!isUsed[i]) continue;
    renumbered[i] = kept;
    facets.vertices[kept++] = facets.vertices[i];
  }
  facets.vertices.resize(kept);
  for (auto& triangle : facets.triangles)
    for (std::uint32_t& corner : triangle) corner = renumbered[corner];
}

std::string textOf(const Facets& facets) {
  return facets.name.empty() ? "the facets" : facets.name;
}

void checkFacets(const Facets& facets) {
  const std::size_t vertices = facets.vertices.size();
  for (std::size_t i = 0; i < vertices; ++i) {
    const Point3& p = facets.vertices[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw InputError(textOf(facets) + ": vertex " + std::to_string(i) +
                       " has a coordinate that is not a number");
  }
  for (std::size_t i = 0; i < facets.triangles.size(); ++i)
    for (const std::uint32_t corner : facets.triangles[i])
      if (corner >= vertices)
        throw InputError(textOf(facets) + ": triangle " + std::to_string(i) + " has vertex " +
                         std::to_string(corner) + ", but there are only " +
                         std::to_string(vertices) + ", counted from 0");
  if (!facets.group.empty() && facets.group.size() != facets.triangles.size())
    throw InputError(textOf(facets) + ": there are parts for " +
                     std::to_string(facets.group.size()) + " triangles, but " +
                     std::to_string(facets.triangles.size()) + " triangles");
  for (std::size_t i = 0; i < facets.group.size(); ++i)
    if (facets.group[i] >= facets.groupNames.size())
      throw InputError(textOf(facets) + ": triangle " + std::to_string(i) + " is in part " +
                       std::to_string(facets.group[i]) + ", but there are names of only " +
                       std::to_string(facets.groupNames.size()) + " parts, counted from 0");
}

/// All on a line: no front has a direction to go to.
void refuseWithoutArea(const Facets& facets) {
  constexpr double kNone = 1e-14;  // of the square of the diagonal: rounding makes less
  Box3 box;
  double area = 0;
  for (std::uint32_t t = 0; t < facets.triangles.size(); ++t) {
    area += areaOf(facets, t);
    for (const std::uint32_t v : facets.triangles[t]) box.add(facets.vertices[v]);
  }
  const double diagonal = distance(box.low, box.high);
  if (!(area > kNone * diagonal * diagonal))
    throw InputError(textOf(facets) +
                     ": its triangles have no area, because all corners are on a " +
                     "line; give a surface");
}

}  // namespace

std::span<const FacetFormat> facetFormats() { return kFacetFormats; }

Facets readFacets(const std::filesystem::path& path) {
  Facets facets;
  facets.name = path.string();
  const FacetFormat* format = formatOf(facetFormats(), path);
  if (!format) throw InputError(facets.name + ": its extension is not that of a triangle format");
  format->read(contentOf(path), facets);
  return repairedFacets(std::move(facets));
}

Facets repairedFacets(Facets facets) {
  checkFacets(facets);
  mergeVertices(facets);
  dropCollapsedTriangles(facets);
  dropUnusedVertices(facets);
  if (facets.triangles.empty()) throw InputError(textOf(facets) + ": contains no triangle");
  repairFacets(facets);
  if (facets.triangles.empty())
    throw InputError(textOf(facets) +
                     ": no triangle is left after the repair of invalid triangles" +
                     (facets.notes.empty() ? "" : ": " + facets.notes.back()));
  refuseWithoutArea(facets);
  return facets;
}

}  // namespace af2::geometry
