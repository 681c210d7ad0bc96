#include "geometry/check/patch_outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <tuple>

#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

/// The surface of a cube of side 2 in n x n squares on each side, two triangles each, as one face
/// without any segment; each point goes where `place` says.
template <class Place>
ModelMesh closed(int n, const Place& place) {
  ModelMesh mesh;
  std::map<std::tuple<int, int, int>, std::size_t> ids;
  const auto vertex = [&](std::array<int, 3> at) {
    const auto [found, isNew] = ids.try_emplace({at[0], at[1], at[2]}, mesh.vertices.size());
    const auto along = [&](std::size_t axis) { return 2.0 * at[axis] / n - 1; };
    if (isNew) mesh.vertices.push_back(place(Point3{along(0), along(1), along(2)}));
    return VertexId(found->second);
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int end : {0, n})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int di, int dj) {
            std::array<int, 3> at{};
            at[axis] = end;
            at[(axis + 1) % 3] = i + (end > 0 ? di : dj);
            at[(axis + 2) % 3] = j + (end > 0 ? dj : di);
            return vertex(at);
          };
          mesh.elements.push_back({{corner(0, 0), corner(1, 0), corner(1, 1), VertexId()}});
          mesh.elements.push_back({{corner(0, 0), corner(1, 1), corner(0, 1), VertexId()}});
          mesh.face.insert(mesh.face.end(), 2, 1);
        }
  return mesh;
}

bool isStarShaped(const ModelMesh& mesh) {
  const PatchOutlines outlines(mesh, kOneByOne);
  const OutlinedPatch all = outlines.patch(0, mesh.elements.size());
  const OutlinedPatch* const patch = &all;
  return outlines.isStarShaped({&patch, 1});
}

TEST(PatchOutlines, KnowABallByAPointInside) {
  EXPECT_TRUE(isStarShaped(closed(8, [](const Point3& p) { return unit(p); })));
  EXPECT_TRUE(isStarShaped(closed(3, [](const Point3& p) { return 5.0 * p; })));
}

/// With more elements than are looked at together.
TEST(PatchOutlines, KnowALargeBall) {
  ModelMesh ball = closed(80, [](const Point3& p) { return unit(p); });
  EXPECT_TRUE(isStarShaped(ball));
  std::swap(ball.elements.back().corners[0], ball.elements.back().corners[1]);
  EXPECT_FALSE(isStarShaped(ball));
}

TEST(PatchOutlines, AreTheSameWhateverOrderTheirPartsAreFoundIn) {
  const ModelMesh ball = closed(80, [](const Point3& p) { return unit(p); });
  const Repeat lastFirst = [](std::size_t count, const auto& work) {
    for (std::size_t i = count; i-- > 0;) work(i);
  };
  const OutlinedPatch one = PatchOutlines(ball, kOneByOne).patch(0, ball.elements.size()),
                      other = PatchOutlines(ball, lastFirst).patch(0, ball.elements.size());
  EXPECT_EQ(one.normal, other.normal);
  EXPECT_EQ(one.corners, other.corners);
  EXPECT_EQ(one.onSegments, other.onSegments);
  ASSERT_EQ(one.boxes.size(),
            (ball.elements.size() + OutlinedPatch::kRun - 1) / OutlinedPatch::kRun);
  ASSERT_EQ(one.boxes.size(), other.boxes.size());
  for (std::size_t i = 0; i < one.boxes.size(); ++i)
    EXPECT_EQ(one.boxes[i].low, other.boxes[i].low);
}

TEST(PatchOutlines, KnowABallThatIsTurnedInsideOut) {
  EXPECT_TRUE(isStarShaped(closed(8, [](const Point3& p) { return -1.0 * unit(p); })));
}

TEST(PatchOutlines, SayNothingOfABallThatIsPushedThroughItself) {
  const ModelMesh mesh = closed(8, [](const Point3& p) {
    const Point3 on = unit(p);
    return on.z > 0.8 ? Point3{on.x, on.y, on.z - 2.5} : on;
  });
  EXPECT_FALSE(isStarShaped(mesh));
  EXPECT_GT(testing::crossingsOf(mesh), 0u);
}

TEST(PatchOutlines, SayNothingOfASurfaceThatIsOpenOrSeenFromNoPoint) {
  ModelMesh open = closed(4, [](const Point3& p) { return unit(p); });
  for (const VertexId v : open.elements.back().vertices())
    for (const VertexId w : open.elements.back().vertices())
      if (v < w) open.segments.push_back({v, w, 1, 1, {}});
  open.elements.pop_back();
  open.face.pop_back();
  EXPECT_FALSE(isStarShaped(open));
  const ModelMesh bent = closed(16, [](const Point3& p) {
    const Point3 on = unit(p);
    return Point3{2 * on.x, on.y / 4, on.z / 4 + 2 * on.x * on.x};
  });
  EXPECT_FALSE(isStarShaped(bent));
  EXPECT_EQ(testing::crossingsOf(bent), 0u);
}

}  // namespace
}  // namespace af2::geometry
