// The same mesh in memory and on disk.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

#include "geometry/mesh/join_faces.h"
#include "geometry/meshing/spooled_faces.h"

namespace af2::testing {

/// A mesh by its faces.
struct MeshOfFaces {
  geometry::DividedEdges divided;
  std::vector<geometry::FaceMesh> faces;
};

/// Takes a mesh apart. Vertices on segments are those of boundaries; each segment is an edge.
inline MeshOfFaces facesOf(const geometry::ModelMesh& mesh) {
  using namespace geometry;
  MeshOfFaces apart;
  std::vector<std::uint32_t> pointOf(mesh.vertices.size(), 0xffffffffu);
  for (const EdgeSegment& segment : mesh.segments)
    for (const VertexId v : {segment.from, segment.to}) pointOf[v.value] = 0;
  for (std::size_t v = 0; v < pointOf.size(); ++v)
    if (pointOf[v] == 0) {
      pointOf[v] = static_cast<std::uint32_t>(apart.divided.points.size());
      apart.divided.points.push_back(mesh.vertices[v]);
    }
  for (const EdgeSegment& segment : mesh.segments) {
    DividedEdge& edge = apart.divided.edges.emplace_back();
    edge.points = {pointOf[segment.from.value], pointOf[segment.to.value]};
    edge.parameters = {0, 1};
  }
  for (const FaceReport& report : mesh.faces) {
    FaceMesh& face = apart.faces.emplace_back();
    face.report = report;
    std::map<std::uint32_t, std::uint32_t> local;
    const auto isOf = [&](std::size_t e) { return mesh.face[e] == report.id; };
    for (const bool isInside : {false, true})
      for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        for (const VertexId v : mesh.elements[e].vertices()) {
          if (!isOf(e) || (pointOf[v.value] == 0xffffffffu) != isInside) continue;
          if (!local.try_emplace(v.value, static_cast<std::uint32_t>(local.size())).second)
            continue;
          isInside ? face.inside.push_back(mesh.vertices[v.value])
                   : face.boundary.push_back(pointOf[v.value]);
          face.wantedSizes.push_back(0.1 + 0.01 * (v.value % 7));
        }
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
      if (!isOf(e)) continue;
      Element& element = face.elements.emplace_back(mesh.elements[e]);
      for (VertexId& v : element.corners)
        if (!v.isNone()) v = VertexId(local.at(v.value));
      face.origins.push_back({static_cast<std::uint16_t>(e % 3), 1, e % 5 == 0});
    }
    face.report.elements = face.elements.size();
    for (std::size_t s = 0; s < mesh.segments.size(); ++s) {
      const auto isBeside = [&](std::size_t e) {
        const auto c = mesh.elements[e].vertices();
        return std::ranges::count(c, mesh.segments[s].from) > 0 &&
               std::ranges::count(c, mesh.segments[s].to) > 0;
      };
      for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        if (isOf(e) && isBeside(e)) {
          face.uses.push_back({static_cast<int>(s) + 1, 0});
          break;
        }
    }
  }
  return apart;
}

struct BothMeshes {
  geometry::ModelMesh inMemory, onDisk;
  geometry::EvidenceOfParts evidence;
};

inline BothMeshes joined(MeshOfFaces apart) {
  BothMeshes both;
  const auto named = [](geometry::ModelMesh mesh) {
    mesh.ruleNames = {"one", "two", "three"};
    return mesh;
  };
  both.inMemory = named(joinFaces(apart.divided, apart.faces, {}));
  const auto file = std::make_shared<geometry::SpoolFile>(::testing::TempDir());
  for (geometry::FaceMesh& face : apart.faces) spoolFace(face, apart.divided, true, file);
  geometry::JoinOptions onDisk;
  onDisk.spool = file;
  both.onDisk = named(joinFaces(apart.divided, apart.faces, onDisk));
  both.evidence = geometry::evidenceOf(apart.faces);
  return both;
}

}  // namespace af2::testing
