#include "engine/run/vertex_elements.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/element.h"

namespace af2 {
namespace {

using testing::elementOf;

std::vector<std::size_t> elementsAt(const VertexElements& elements, std::uint32_t v) {
  std::vector<std::size_t> all;
  elements.forEachAt(VertexId(v), [&](std::size_t e, std::size_t) { all.push_back(e); });
  return all;
}

struct Strip {
  Mesh mesh;
  VertexElements elements;
  Strip() {
    mesh.vertices.resize(4);
    mesh.elements = {elementOf({0, 1, 2}), elementOf({0, 2, 3})};
    elements.enter(mesh, 0);
  }
};

TEST(VertexElements, AreThoseAtEachVertex) {
  const Strip strip;
  EXPECT_EQ(elementsAt(strip.elements, 0), (std::vector<std::size_t>{1, 0}));
  EXPECT_EQ(elementsAt(strip.elements, 1), (std::vector<std::size_t>{0}));
  EXPECT_TRUE(elementsAt(strip.elements, 99).empty());
}

TEST(VertexElements, AreGivenToAnotherVertex) {
  Strip strip;
  strip.elements.give(VertexId(1u), VertexId(3u));
  EXPECT_TRUE(elementsAt(strip.elements, 1).empty());
  EXPECT_EQ(elementsAt(strip.elements, 3), (std::vector<std::size_t>{0, 1}));
}

/// A path adds vertices to the front before there are elements at them, and these may be welded.
TEST(VertexElements, AreGivenFromAndToVerticesWithoutAny) {
  VertexElements none;
  none.give(VertexId(7u), VertexId(3u));
  EXPECT_TRUE(elementsAt(none, 3).empty());
  Strip strip;
  strip.elements.give(VertexId(9u), VertexId(1u));
  EXPECT_EQ(elementsAt(strip.elements, 1), (std::vector<std::size_t>{0}));
  strip.elements.give(VertexId(1u), VertexId(9u));
  EXPECT_EQ(elementsAt(strip.elements, 9), (std::vector<std::size_t>{0}));
}

}  // namespace
}  // namespace af2
