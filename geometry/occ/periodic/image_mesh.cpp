#include "geometry/occ/periodic/image_mesh.h"

#include <algorithm>
#include <map>
#include <set>

#include "engine/base/place_text.h"
#include "geometry/occ/periodic/face_map.h"

namespace af2::geometry {
namespace {

std::set<VertexId> verticesOfElements(const ModelMesh& mesh,
                                      const std::vector<std::size_t>& elements) {
  std::set<VertexId> vertices;
  for (const std::size_t e : elements)
    for (const VertexId v : mesh.elements[e].vertices()) vertices.insert(v);
  return vertices;
}

Point3 areaVector(const ModelMesh& mesh, const std::vector<std::size_t>& elements) {
  Point3 sum;
  for (const std::size_t e : elements) {
    const auto corners = mesh.elements[e].vertices();
    const Point3& origin = mesh.vertices[corners[0].value];
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      sum = sum + cross(mesh.vertices[corners[i].value] - origin,
                        mesh.vertices[corners[i + 1].value] - origin);
  }
  return sum;
}

Element turnedRound(const Element& element) {
  Element turned = element;
  const std::size_t count = element.vertices().size();
  std::reverse(turned.corners.begin() + 1,
               turned.corners.begin() + static_cast<std::ptrdiff_t>(count));
  return turned;
}

}  // namespace

std::vector<std::size_t> elementsOfFace(const ModelMesh& mesh, int face) {
  std::vector<std::size_t> elements;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (mesh.face[e] == face) elements.push_back(e);
  return elements;
}

std::string makeImage(ModelMesh& mesh, PeriodicPair& pair, double tolerance) {
  const std::vector<std::size_t> first = elementsOfFace(mesh, pair.first),
                                 second = elementsOfFace(mesh, pair.second);
  if (first.empty() || second.empty()) return "one of them has no mesh";
  const FaceMap map(pair.transform);
  std::set<VertexId> onEdges;
  for (const EdgeSegment& segment : mesh.segments) onEdges.insert({segment.from, segment.to});
  std::vector<VertexId> border;
  for (const VertexId v : verticesOfElements(mesh, second))
    if (onEdges.contains(v)) border.push_back(v);

  std::map<VertexId, VertexId> images;
  std::vector<VertexId> inside;
  for (const VertexId v : verticesOfElements(mesh, first)) {
    if (!onEdges.contains(v)) {
      inside.push_back(v);
      continue;
    }
    const Point3 at = map.at(mesh.vertices[v.value]);
    const auto nearest = std::ranges::min_element(
        border, {}, [&](VertexId w) { return distance(mesh.vertices[w.value], at); });
    if (nearest == border.end() || distance(mesh.vertices[nearest->value], at) > tolerance)
      return "the vertex at " + af2::textOf(mesh.vertices[v.value], 6) +
             " has no image on the edges of the second";
    images[v] = *nearest;
  }
  if (images.size() != border.size()) return "their edges have different numbers of vertices";

  for (const auto& [from, to] : images) mesh.vertices[to.value] = map.at(mesh.vertices[from.value]);
  for (const VertexId v : inside) {
    images[v] = VertexId(mesh.vertices.size());
    mesh.vertices.push_back(map.at(mesh.vertices[v.value]));
    if (!mesh.wantedSizes.empty()) mesh.wantedSizes.push_back(mesh.wantedSizes[v.value]);
  }
  const bool isTurned = dot(map.along(areaVector(mesh, first)), areaVector(mesh, second)) < 0;

  std::vector<Element> elements;
  std::vector<std::int32_t> faces;
  std::vector<ElementOrigin> origins;
  const auto add = [&](const Element& element, std::int32_t face, const ElementOrigin& origin) {
    elements.push_back(element);
    faces.push_back(face);
    origins.push_back(origin);
  };
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (mesh.face[e] != pair.second) add(mesh.elements[e], mesh.face[e], mesh.origins[e]);
    if (e != second.front()) continue;
    for (const std::size_t from : first) {
      Element image = isTurned ? turnedRound(mesh.elements[from]) : mesh.elements[from];
      for (VertexId& corner : image.corners)
        if (!corner.isNone()) corner = images.at(corner);
      add(image, pair.second, mesh.origins[from]);
    }
  }
  mesh.elements = std::move(elements);
  mesh.face = std::move(faces);
  mesh.origins = std::move(origins);
  for (FaceReport& face : mesh.faces)
    if (face.id == pair.second) face.elements = first.size();
  for (const auto& [from, to] : images) pair.vertices.emplace_back(to, from);
  return "";
}

}  // namespace af2::geometry
