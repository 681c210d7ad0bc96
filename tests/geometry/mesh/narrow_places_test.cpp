#include "geometry/mesh/narrow_places.h"

#include <gtest/gtest.h>

#include <random>

#include "geometry/base/box_tree.h"

namespace af2::geometry {
namespace {

Element triangle(std::size_t a, std::size_t b, std::size_t c) {
  Element element;
  element.corners = {VertexId(a), VertexId(b), VertexId(c), VertexId()};
  return element;
}

/// A strip of `cells` squares of width `width`, cut into triangles, in the plane z = `z`.
void addStrip(ModelMesh& mesh, std::size_t cells, double width, double z, int face) {
  const std::size_t base = mesh.vertices.size();
  for (std::size_t i = 0; i <= cells; ++i)
    for (const double y : {0.0, width}) mesh.vertices.push_back({width * double(i), y, z});
  const auto at = [&](std::size_t i, std::size_t side) { return base + 2 * i + side; };
  for (std::size_t i = 0; i < cells; ++i) {
    mesh.elements.push_back(triangle(at(i, 0), at(i + 1, 0), at(i + 1, 1)));
    mesh.elements.push_back(triangle(at(i, 0), at(i + 1, 1), at(i, 1)));
    mesh.face.insert(mesh.face.end(), 2, face);
    for (const std::size_t side : {0, 1})
      mesh.segments.push_back({VertexId(at(i, side)), VertexId(at(i + 1, side)), face, 1});
  }
  mesh.wantedSizes.assign(mesh.vertices.size(), 1);
}

TEST(NarrowPlaces, AreStripsOfFaces) {
  ModelMesh mesh;
  addStrip(mesh, 6, 0.5, 0, 1);
  const std::vector<SizeSource> places = narrowPlaces(mesh, 3);
  ASSERT_FALSE(places.empty());
  for (const SizeSource& place : places) EXPECT_NEAR(place.size, 0.5 / 3, 1e-12);
  EXPECT_TRUE(narrowPlaces(mesh, 0.5).empty()) << "half an element fits across";
}

TEST(NarrowPlaces, AreGapsAndWalls) {
  ModelMesh mesh;
  addStrip(mesh, 4, 10, 0, 1);
  addStrip(mesh, 4, 10, 0.25, 2);
  const std::vector<SizeSource> places = narrowPlaces(mesh, 2);
  EXPECT_EQ(places.size(), mesh.elements.size());
  for (const SizeSource& place : places) EXPECT_NEAR(place.size, 0.125, 1e-12);
}

TEST(NarrowPlaces, ComeInTheSameOrderOnAnyNumberOfThreads) {
  ModelMesh mesh;
  addStrip(mesh, 5000, 0.5, 0, 1);
  addStrip(mesh, 5000, 0.5, 0.25, 2);
  const std::vector<SizeSource> one = narrowPlaces(mesh, 3), two = narrowPlaces(mesh, 3, 2);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].position, two[i].position);
    EXPECT_EQ(one[i].size, two[i].size);
  }
}

TEST(NarrowPlaces, AreNotWhereNeighboursMeet) {
  ModelMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0.1}};
  mesh.elements = {triangle(0, 1, 2), triangle(1, 0, 3)};
  mesh.face = {1, 2};
  mesh.wantedSizes.assign(4, 1);
  mesh.segments = {{VertexId(0u), VertexId(1u), 1, 2}};
  EXPECT_TRUE(narrowPlaces(mesh, 5).empty());
}

TEST(BoxTree, FindsWhatABruteSearchFinds) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(0, 10), some(0, 1);
  const auto point = [&] { return Point3{any(random), any(random), any(random)}; };
  std::vector<Box3> boxes(500);
  for (Box3& box : boxes) {
    box.add(point());
    box.add(box.low + Point3{some(random), some(random), some(random)});
  }
  const BoxTree tree(boxes);
  for (int k = 0; k < 200; ++k) {
    Box3 where;
    where.add(point());
    where.add(where.low + Point3{1, 2, 3});
    std::vector<std::uint32_t> found, expected;
    tree.forEachIn(where, [&](std::uint32_t i) { found.push_back(i); });
    std::sort(found.begin(), found.end());
    std::uint32_t nearest = 0;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      if (boxes[i].meets(where)) expected.push_back(i);
      if (boxes[i].distanceTo(where.low) < boxes[nearest].distanceTo(where.low)) nearest = i;
    }
    EXPECT_EQ(found, expected);
    EXPECT_EQ(tree.nearest(where.low, 100,
                           [&](std::uint32_t i) { return boxes[i].distanceTo(where.low); }),
              nearest);
  }
}

}  // namespace
}  // namespace af2::geometry
