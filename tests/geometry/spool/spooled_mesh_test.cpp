#include "geometry/spool/spooled_mesh.h"

#include <gtest/gtest.h>

#include <vector>

namespace af2::geometry {
namespace {

/// A face of as many elements as it is told; notes when it is read, and as a negative number when
/// it is read ahead.
class NotedFace final : public StoredFace {
 public:
  NotedFace(std::vector<int>& notes, int number, std::size_t elements)
      : NotedFace(notes, number,
                  SpooledFace(std::make_shared<SpoolFile>(),
                              {{},
                               {},
                               std::vector<Element>(elements, kElement),
                               std::vector<ElementOrigin>(elements)},
                              3)) {}

  void read(std::size_t count, const UseBytes& use) const override {
    notes_.push_back(number_);
    use(std::span(bytes_).first(count));
  }
  void readAhead() const override { notes_.push_back(-number_); }

 private:
  static constexpr Element kElement{{VertexId(0), VertexId(1), VertexId(2)}};

  NotedFace(std::vector<int>& notes, int number, const SpooledFace& face)
      : StoredFace(face.counts()), notes_(notes), number_(number) {
    face.read(face.counts().allBytes(), [&](std::span<const std::uint8_t> bytes) {
      bytes_.assign(bytes.begin(), bytes.end());
    });
  }

  std::vector<int>& notes_;
  int number_;
  std::vector<std::uint8_t> bytes_;
};

TEST(SpooledMesh, ReadsTheNextFacesAhead) {
  std::vector<int> notes;
  std::vector<SpooledPart> parts;
  int number = 0;
  for (const std::size_t elements : {10u, 20'000u, 20'000u, 20'000u, 70'000u, 10u})
    parts.push_back({++number, std::make_shared<NotedFace>(notes, number, elements), {0, 1, 2}});
  const SpooledMesh mesh(std::move(parts), 3, nullptr);
  const std::vector<Point3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  std::size_t elements = 0;
  mesh.visitAll({corners, {}}, [&](const MeshSlice& slice) { elements += slice.elements.size(); });
  EXPECT_EQ(elements, 130'020u);
  // Small ones together, large ones only when they are next.
  EXPECT_EQ(notes, (std::vector<int>{-2, -3, -4, 1, -5, 2, 3, 4, -6, 5, 6}));
}

}  // namespace
}  // namespace af2::geometry
