#include "geometry/meshing/spooled_faces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "geometry/io/mesh_files.h"
#include "geometry/mesh/element_scores.h"
#include "geometry/mesh/fingerprint.h"
#include "geometry/mesh/inside_out.h"
#include "geometry/mesh/quality.h"
#include "geometry/mesh/scaled_mesh.h"
#include "geometry/spool/spooled_mesh.h"
#include "tests/support/spooled.h"
#include "tests/support/written.h"

namespace af2::geometry {
namespace {

using testing::BothMeshes;
using testing::facesOf;
using testing::joined;
using testing::MeshOfFaces;
using testing::written;

using Bend = std::function<Point3(double x, double y)>;

/// [0, faces] x [0, 1], bent: face i is what lies over [i - 1, i], with n squares along each side;
/// each is a quadrilateral or two triangles.
ModelMesh strip(int faces, std::size_t n, const Bend& bend) {
  ModelMesh mesh;
  const std::size_t columns = static_cast<std::size_t>(faces) * n;
  const auto id = [&](std::size_t i, std::size_t j) { return VertexId(i * (n + 1) + j); };
  for (std::size_t i = 0; i <= columns; ++i)
    for (std::size_t j = 0; j <= n; ++j)
      mesh.vertices.push_back(bend(static_cast<double>(i) / static_cast<double>(n),
                                   static_cast<double>(j) / static_cast<double>(n)));
  for (int face = 1; face <= faces; ++face) {
    FaceReport& report = mesh.faces.emplace_back();
    report.id = face;
    report.surfaceType = "plane";
    for (std::size_t i = static_cast<std::size_t>(face - 1) * n;
         i < static_cast<std::size_t>(face) * n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const VertexId a = id(i, j), b = id(i + 1, j), c = id(i + 1, j + 1), d = id(i, j + 1);
        if ((i + j) % 4 == 0) {
          mesh.elements.push_back({{a, b, c, d}});
          mesh.face.push_back(face);
        } else {
          mesh.elements.push_back({{a, b, c, VertexId()}});
          mesh.elements.push_back({{a, c, d, VertexId()}});
          mesh.face.insert(mesh.face.end(), 2, face);
        }
      }
  }
  for (std::size_t i = 0; i < columns; ++i)
    for (const std::size_t j : {std::size_t{0}, n})
      mesh.segments.push_back({id(i, j), id(i + 1, j), 1, 1, {}});
  for (std::size_t i = 0; i <= columns; i += n)
    for (std::size_t j = 0; j < n; ++j) mesh.segments.push_back({id(i, j), id(i, j + 1), 2, 1, {}});
  return mesh;
}

Point3 flat(double x, double y) { return {x, y, 0}; }
Point3 wavy(double x, double y) { return {x, y, 0.3 * std::sin(3 * x) * std::cos(2 * y)}; }
/// The second and third face pass through the first.
Point3 curled(double x, double y) {
  return {std::cos(3 * x) + 0.3 * x, std::sin(3 * x), y + 0.05 * x};
}
/// Each face crosses itself.
Point3 looped(double x, double y) {
  const double t = 9 * (x - std::floor(x));
  return {x + 0.2 * std::cos(t), 0.4 * std::sin(t), y};
}

void expectSameFaults(const MeshOfFaces& apart) {
  const BothMeshes both = joined(apart);
  const MeshFaults wanted = faultsOf(both.inMemory, true, 1);
  const MeshFaults found = faultsOfSpooled(both.onDisk, both.evidence, true, 1);
  EXPECT_EQ(found.findings, wanted.findings);
  EXPECT_EQ(found.crossings, wanted.crossings);
}

TEST(SpooledFaces, HaveNoFaultsWhereTheMeshInMemoryHasNone) {
  for (const Bend& bend : {Bend(flat), Bend(wavy)}) {
    const BothMeshes both = joined(facesOf(strip(4, 6, bend)));
    const MeshFaults found = faultsOfSpooled(both.onDisk, both.evidence, true, 1);
    EXPECT_TRUE(found.findings.empty());
    EXPECT_TRUE(found.crossings.empty());
  }
}

TEST(SpooledFaces, CrossWhereTheyDoInMemory) {
  for (const Bend& bend : {Bend(curled), Bend(looped)}) {
    const MeshOfFaces apart = facesOf(strip(4, 9, bend));
    const BothMeshes both = joined(apart);
    ASSERT_GT(faultsOf(both.inMemory, true, 1).crossings.size(), 5u);
    expectSameFaults(apart);
  }
}

TEST(SpooledFaces, HaveTheFaultsThatTheyHaveInMemory) {
  std::mt19937 random(3);
  const auto below = [&](std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
  };
  std::size_t findings = 0;
  for (int round = 0; round < 60; ++round) {
    MeshOfFaces apart = facesOf(strip(3, 5, round % 2 == 0 ? flat : wavy));
    for (int fault = 0; fault <= round % 3; ++fault) {
      FaceMesh& face = apart.faces[below(3)];
      const std::size_t e = below(face.elements.size());
      std::array<VertexId, 4>& corners = face.elements[e].corners;
      switch (below(5)) {
        case 0:  // a hole
          face.elements.erase(face.elements.begin() + static_cast<std::ptrdiff_t>(e));
          face.origins.pop_back();
          break;
        case 1:  // upside down
          std::swap(corners[0], corners[1]);
          break;
        case 2:  // a corner somewhere else
          corners[below(3)] = VertexId(below(face.boundary.size() + face.inside.size()));
          break;
        case 3:  // without area
          face.inside[below(face.inside.size())] = face.inside.front();
          break;
        default:  // there twice
          face.elements.push_back(face.elements[e]);
          face.origins.push_back(face.origins[e]);
      }
    }
    findings += faultsOf(joined(apart).inMemory, false, 1).findings.size();
    expectSameFaults(apart);
  }
  EXPECT_GT(findings, 200u);
}

TEST(SpooledFaces, HaveAreasThatAreCompared) {
  MeshOfFaces apart = facesOf(strip(3, 8, flat));
  apart.faces[0].report.area = 1;
  apart.faces[1].report.area = 3;
  const BothMeshes both = joined(apart);
  const auto findings = faultsOfSpooled(both.onDisk, both.evidence, true, 1).findings;
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings.front().face, 2);
  EXPECT_EQ(findings, faultsOf(both.inMemory, true, 1).findings);
}

TEST(SpooledFaces, MakeTheSameFiles) {
  const BothMeshes both = joined(facesOf(strip(4, 6, wavy)));
  std::size_t formats = 0;
  for (const MeshFormat& format : meshFormats()) {
    if (!format.holdsSpooled) continue;
    ++formats;
    for (const LinesAlong along : {LinesAlong::Boundaries, LinesAlong::AllEdges}) {
      const FileOptions options{along, {}, false};
      EXPECT_EQ(written(both.onDisk, format.extension, options),
                written(both.inMemory, format.extension, options))
          << format.name;
    }
    const FileOptions grouped{LinesAlong::Boundaries, {Grouping::Solids, Grouping::Faces}, true};
    EXPECT_EQ(written(both.onDisk, format.extension, grouped),
              written(both.inMemory, format.extension, grouped))
        << format.name;
  }
  EXPECT_GE(formats, 6u);
}

TEST(SpooledFaces, AreRefusedByOtherFormats) {
  const BothMeshes both = joined(facesOf(strip(2, 2, flat)));
  EXPECT_THROW(written(both.onDisk, ".inp"), InputError);
}

TEST(SpooledFaces, MakeTheSameFilesInOtherUnits) {
  const BothMeshes both = joined(facesOf(strip(3, 4, wavy)));
  EXPECT_EQ(written(scaledMesh(both.onDisk, 0.1), ".vtu"),
            written(scaledMesh(both.inMemory, 0.1), ".vtu"));
}

TEST(SpooledFaces, HaveTheSameMeasures) {
  const BothMeshes both = joined(facesOf(strip(5, 7, wavy)));
  EXPECT_EQ(vertexCount(both.onDisk), both.inMemory.vertices.size());
  EXPECT_EQ(elementCount(both.onDisk), both.inMemory.elements.size());
  EXPECT_EQ(quadCount(both.onDisk), quadCount(both.inMemory));
  EXPECT_EQ(fingerprint(both.onDisk), fingerprint(both.inMemory));
  const MeshQuality found = measureQuality(both.onDisk), wanted = measureQuality(both.inMemory);
  EXPECT_EQ(found.min, wanted.min);
  EXPECT_EQ(found.p1, wanted.p1);
  EXPECT_NEAR(found.mean, wanted.mean, 1e-12);
  EXPECT_EQ(found.worstFace, wanted.worstFace);
  EXPECT_EQ(found.worstPlace, wanted.worstPlace);
  EXPECT_EQ(found.minAngle, wanted.minAngle);
  EXPECT_EQ(found.maxAngle, wanted.maxAngle);
  EXPECT_EQ(found.freeEdges, wanted.freeEdges);
  EXPECT_GT(found.freeEdges, 0u);
  EXPECT_NEAR(found.edges.mean, wanted.edges.mean, 1e-12);
  EXPECT_EQ(found.edges.p5, wanted.edges.p5);
  EXPECT_EQ(found.edges.p95, wanted.edges.p95);
  EXPECT_EQ(found.edges.histogram, wanted.edges.histogram);
  EXPECT_EQ(found.edges.leastLength, wanted.edges.leastLength);
  EXPECT_EQ(found.edges.mostWanted, wanted.edges.mostWanted);
}

TEST(SpooledFaces, AreDroppedAsInMemory) {
  BothMeshes both = joined(facesOf(strip(5, 4, wavy)));
  dropElements(both.inMemory, {2, 5});
  dropElements(both.onDisk, {2, 5});
  EXPECT_EQ(written(both.onDisk, ".vtu"), written(both.inMemory, ".vtu"));
  EXPECT_EQ(both.onDisk.segments, both.inMemory.segments);
}

TEST(SpooledFaces, ComeBackIntoMemory) {
  MeshOfFaces apart = facesOf(strip(2, 4, flat));
  const FaceMesh before = apart.faces[1];
  FaceMesh& face = apart.faces[1];
  spoolFace(face, apart.divided, true, std::make_shared<SpoolFile>(::testing::TempDir()));
  EXPECT_TRUE(face.elements.empty());
  EXPECT_EQ(elementCount(face), before.elements.size());
  loadBulk(face);
  EXPECT_EQ(face.elements, before.elements);
  EXPECT_EQ(face.inside, before.inside);
  EXPECT_EQ(face.wantedSizes, before.wantedSizes);
  EXPECT_EQ(face.origins, before.origins);
}

TEST(SpooledFaces, UseOneVertexOfEachPointOfASeam) {
  MeshOfFaces apart = facesOf(strip(2, 4, flat));
  FaceMesh& face = apart.faces[0];
  // A second vertex at the point of the first one, as at the other side of a seam.
  face.boundary.push_back(face.boundary.front());
  face.wantedSizes.insert(
      face.wantedSizes.begin() + static_cast<std::ptrdiff_t>(face.boundary.size() - 1), 0.1);
  for (Element& element : face.elements)
    for (VertexId& v : element.corners)
      if (!v.isNone() && v.value + 1 >= face.boundary.size()) v = VertexId(v.value + 1);
  for (VertexId& v : face.elements.front().corners)
    if (v == VertexId(0)) v = VertexId(face.boundary.size() - 1);
  expectSameFaults(apart);
  const BothMeshes both = joined(apart);
  EXPECT_EQ(written(both.onDisk, ".obj"), written(both.inMemory, ".obj"));
}

}  // namespace
}  // namespace af2::geometry
