#include "geometry/meshing/even_division.h"

#include <gtest/gtest.h>

#include "engine/base/error.h"

namespace af2::geometry {
namespace {

/// Two faces: the loop of the first is made of edges 1 and 2, that of the second of edge 3. Edges
/// have 5, 20 and 7 segments.
class TwoFaces : public FaceSource {
 public:
  int faceCount() const override { return 2; }
  int edgeCount() const override { return 3; }
  double diagonal() const override { return 1; }
  FaceReport reportOf(int) const override { return {}; }
  const std::vector<FaceGroup>& groups() const override { return groups_; }
  void prepare(const MeshingOptions&, const std::vector<int>&) override {}
  double workOn(int) const override { return 1; }
  const PositionSize& sizesByPosition() const override { return sizes_; }
  std::vector<int> edgesOf(int) const override { return {}; }
  Point3 pointOnEdge(int, double) const override { return {}; }

  DividedEdges divide(const PositionSize&, const CollapsedEdges&,
                      const SegmentChanges& changes) const override {
    ++divisions;
    DividedEdges divided;
    divided.counts = {{5, 5, 1, false}, {20, 20, 1, false}, {7, 7, 1, false}};
    for (std::size_t i = 0; i < divided.counts.size(); ++i)
      if (changeAt(changes, i) != 0 && i != stubborn) divided.counts[i].segments += 1;
    return divided;
  }
  std::vector<CountedLoop> loopsOf(int face, const DividedEdges&) const override {
    if (face == faulty) throw GeometryError("the boundary is not closed");
    if (face == 2) return {{{2}}};
    return {{{0, 1}}};
  }
  void fill(int, const FillRequest&, FaceMesh&) const override {}
  void complete(const MeshFaults&, ModelMesh&) const override {}

  std::size_t stubborn = 99;  // the count that follows no change
  int faulty = 0;             // the face without loops
  mutable int divisions = 0;

 private:
  std::vector<FaceGroup> groups_;
  PositionSize sizes_;
};

std::vector<std::size_t> segmentsOf(const TwoFaces& faces) {
  std::vector<std::size_t> segments;
  for (const SegmentCount& count : divideWithEvenLoops(faces, {}, {}, 1, {}).counts)
    segments.push_back(count.segments);
  return segments;
}

TEST(EvenDivision, DividesEdgesAgainWithChanges) {
  const TwoFaces faces;
  EXPECT_EQ(segmentsOf(faces), (std::vector<std::size_t>{5, 21, 8}));
  EXPECT_EQ(faces.divisions, 2);
}

TEST(EvenDivision, ChangesAnotherEdgeWhereOneCannotFollow) {
  TwoFaces faces;
  faces.stubborn = 1;
  EXPECT_EQ(segmentsOf(faces), (std::vector<std::size_t>{6, 20, 8}));
  EXPECT_EQ(faces.divisions, 3);
}

TEST(EvenDivision, LeavesFacesWithFaultyBoundariesOut) {
  TwoFaces faces;
  faces.faulty = 1;
  EXPECT_EQ(segmentsOf(faces), (std::vector<std::size_t>{5, 20, 8}));
}

}  // namespace
}  // namespace af2::geometry
