#include "geometry/mpi/crew/face_bytes.h"

#include <gtest/gtest.h>

#include "geometry/mpi/crew/region_bytes.h"

namespace af2::mpi {
namespace {

template <class T>
T again(const T& value) {
  const Bytes bytes = bytesOf(value);
  ByteReader reader(bytes);
  T copy = reader.take<T>();
  EXPECT_TRUE(reader.rest().empty());
  return copy;
}

/// A mesh of a face in which nothing is as it is by default.
geometry::FaceMesh someMesh() {
  geometry::FaceMesh mesh;
  mesh.report.id = 7;
  mesh.report.name = "rim";
  mesh.report.attempts = {"one", "two"};
  mesh.report.stuck.push_back({{1, 2, 3}, {4, 5, 6}, 0.5, 0.25, 3, {{2, Refusal::Score}}, {}});
  mesh.report.stuck[0].around.chains = {{0, 1}, {2}};
  mesh.report.stuck[0].around.colours = {{1, true}};
  mesh.report.deviation = 0.125;
  mesh.report.cause = geometry::FailureCause::Model;
  mesh.boundary = {3, 1, 2};
  mesh.inside = {{0.1, -0.0, 1e-300}};
  mesh.elements = {{{VertexId(0), VertexId(1), VertexId(2), VertexId()}}};
  mesh.history.push_back(geometry::failedFace("no room"));
  mesh.diagnosis.places.push_back({{1, 1, 1}, 0.5, 2});
  mesh.searchCost = std::size_t{1} << 40;
  return mesh;
}

TEST(FaceBytes, GiveTheSameMeshBackBitForBit) {
  const geometry::FaceMesh mesh = someMesh(), copy = again(mesh);
  EXPECT_EQ(bytesOf(copy), bytesOf(mesh));
  EXPECT_EQ(copy.report.name, "rim");
  EXPECT_EQ(copy.report.attempts, mesh.report.attempts);
  EXPECT_EQ(copy.report.stuck[0].refusals, mesh.report.stuck[0].refusals);
  EXPECT_EQ(copy.report.stuck[0].around.chains, mesh.report.stuck[0].around.chains);
  EXPECT_EQ(copy.report.deviation, 0.125);
  EXPECT_EQ(copy.report.cause, geometry::FailureCause::Model);
  EXPECT_EQ(copy.inside, mesh.inside);
  EXPECT_TRUE(std::signbit(copy.inside[0].y));
  EXPECT_EQ(copy.elements, mesh.elements);
  EXPECT_EQ(copy.history, mesh.history);
  EXPECT_EQ(copy.searchCost, mesh.searchCost);
}

TEST(FaceBytes, GiveWhatTheChecksNeedBackBitForBit) {
  KeptFace face;
  face.number = 5;
  face.counts.inside = 1;
  face.counts.elements = 3;
  face.counts.quads = 2;
  face.counts.isUsed = {true, false, true};
  face.evidence.findings = {{7, "an element has no area", {1, 2, 3}}};
  face.evidence.area = 0.125;
  face.evidence.isSoundInside = false;
  face.evidence.atBoundary = {{{VertexId(0), VertexId(1), VertexId(2), VertexId()}}};
  face.evidence.patch.last = 3;
  face.evidence.patch.boxes.resize(2);
  face.evidence.patch.boxes[1].add(Point3{1, -0.0, 2});
  face.evidence.patch.sides = {{0, 1}, {1, 2}};
  face.evidence.patch.onSegments = {2};
  face.evidence.firstCorners[3] = {4, 5, 6};
  face.evidence.isStarShaped = true;
  const KeptFace copy = again(face);
  EXPECT_EQ(bytesOf(copy), bytesOf(face));
  EXPECT_EQ(copy.counts.isUsed, face.counts.isUsed);
  EXPECT_EQ(copy.evidence.findings, face.evidence.findings);
  EXPECT_EQ(copy.evidence.atBoundary, face.evidence.atBoundary);
  EXPECT_EQ(copy.evidence.patch.sides, face.evidence.patch.sides);
  EXPECT_EQ(copy.evidence.firstCorners, face.evidence.firstCorners);
  EXPECT_TRUE(copy.evidence.isStarShaped);
  EXPECT_FALSE(copy.evidence.isSoundInside);
}

TEST(FaceBytes, GivePiecesBackBitForBit) {
  RegionMesh piece;
  piece.result.outcome = Outcome::Stuck;
  piece.result.mesh.vertices.push_back({{1, 2, 3}, {0, 0, 1}, 0.5, 0.25});
  piece.result.stuck.push_back({VertexId(3), VertexId(4), 2, {}, {}});
  piece.result.stuck[0].refusals.push_back({5, Refusal::Beaten, {}, {}, 9, {VertexId(1)}, 0.5, 0});
  piece.progress.candidates = 77;
  const RegionMesh copy = again(piece);
  EXPECT_EQ(bytesOf(copy), bytesOf(piece));
  EXPECT_EQ(copy.result.mesh, piece.result.mesh);
  EXPECT_EQ(copy.result.stuck[0].refusals[0].matched, piece.result.stuck[0].refusals[0].matched);
  EXPECT_EQ(copy.progress.candidates, 77u);
}

TEST(FaceBytes, RefuseAMessageThatIsCutOff) {
  Bytes bytes = bytesOf(someMesh());
  for (const std::size_t size : {bytes.size() - 1, bytes.size() / 2, std::size_t{3}}) {
    bytes.resize(size);
    EXPECT_THROW(ByteReader(bytes).take<geometry::FaceMesh>(), InternalError);
  }
}

}  // namespace
}  // namespace af2::mpi
