#include "geometry/spool/spooled_face.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <vector>

#include "geometry/spool/packed.h"

namespace af2::geometry {
namespace {

template <class T>
std::vector<T> thereAndBack(const std::vector<T>& values) {
  const Bytes bytes = packed(std::span<const T>(values));
  std::vector<T> back(values.size());
  unpack(bytes, std::span(back));
  return back;
}

Element elementOf(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  return {{VertexId(a), VertexId(b), VertexId(c)}};
}

TEST(Packed, ElementsComeBackAsTheyWere) {
  std::mt19937 random(3);
  std::vector<Element> elements;
  for (const unsigned bits : {1u, 7u, 8u, 15u, 31u, 32u}) {
    const auto any = [&] { return VertexId(static_cast<std::uint32_t>(random() >> (32 - bits))); };
    for (int i = 0; i < 1000; ++i) {
      Element& element = elements.emplace_back(Element{{any(), any(), any()}});
      if (i % 3 == 0) element.corners[3] = any();
    }
  }
  constexpr std::uint32_t kLargest = 0xfffffffe;
  elements.push_back(elementOf(0, kLargest, 1));
  elements.push_back(elementOf(kLargest, 0, kLargest - 1));
  EXPECT_EQ(thereAndBack(elements), elements);
  EXPECT_EQ(thereAndBack(std::vector<Element>()), std::vector<Element>());
}

TEST(Packed, TrianglesOfNeighboursTakeFewBytes) {
  std::vector<Element> elements;
  for (std::uint32_t i = 0; i < 10000; ++i)
    elements.push_back(elementOf(100000 + i, 100001 + i, 101000 + i));
  EXPECT_LE(packed(std::span<const Element>(elements)).size(), 4 * elements.size() + 16);
}

TEST(Packed, OriginsComeBackAsTheyWere) {
  std::vector<ElementOrigin> few, many;
  for (int i = 0; i < 3000; ++i) {
    few.push_back({static_cast<std::uint16_t>(i % 7), 1, i % 2 == 0});
    many.push_back({static_cast<std::uint16_t>(i * 22), static_cast<std::uint8_t>(i), i % 2 == 0});
  }
  EXPECT_EQ(thereAndBack(few), few);
  EXPECT_EQ(thereAndBack(many), many);
  EXPECT_LE(packed(std::span<const ElementOrigin>(few)).size(), few.size() + 100);
}

void expectSameIn(const std::shared_ptr<SpoolFile>& file, const std::vector<double>& sizes) {
  const std::vector<Point3> inside = {{1, 2, 3}, {4, 5, 6}};
  const std::vector<Element> elements = {elementOf(0, 1, 3), elementOf(1, 4, 3)};
  const std::vector<ElementOrigin> origins = {{5, 1, true}, {6, 2, false}};
  const SpooledFace face(file, {inside, sizes, elements, origins}, 3);
  const FaceBulk bulk = face.load(), shape = face.loadShape();
  EXPECT_EQ(bulk.inside, inside);
  EXPECT_EQ(bulk.elements, elements);
  EXPECT_EQ(bulk.wantedSizes, sizes);
  EXPECT_EQ(bulk.origins, origins);
  EXPECT_EQ(shape.inside, inside);
  EXPECT_EQ(shape.elements, elements);
  EXPECT_EQ(face.counts().isUsed, (std::vector<bool>{true, true, false}));
}

TEST(SpooledFace, HasWhatWasWritten) {
  for (const auto& file :
       {std::make_shared<SpoolFile>(::testing::TempDir()), std::make_shared<SpoolFile>()}) {
    expectSameIn(file, {0.5, 0.25});
    expectSameIn(file, {0.5, 0.5});
    expectSameIn(file, {});
  }
}

}  // namespace
}  // namespace af2::geometry
