#include "geometry/check/element_pairs.h"

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>

#include "geometry/check/triangle_pair.h"

namespace af2::geometry {

namespace {

/// Elements at a common edge overlap if the angle between them is below this, in radians.
constexpr double kFoldAngle = 0.005;

/// Half of a quadrilateral, or a triangle.
struct Part {
  std::size_t element;
  std::array<std::uint32_t, 3> vertices;
  Box3 box;
};

/// The parts of the elements of a leaf that reach into a box.
void findParts(const ModelMesh& mesh, const ElementTree::Run& run, const Box3& where,
               std::vector<Part>& parts) {
  parts.clear();
  for (std::size_t place = run.first; place < run.last; ++place) {
    const std::size_t i = run.element(place);
    const Element& element = mesh.elements[i];
    for (std::size_t k = 1; k + 1 < static_cast<std::size_t>(element.size()); ++k) {
      const std::array ids{element.corners[0].value, element.corners[k].value,
                           element.corners[k + 1].value};
      Box3 box;
      for (const std::uint32_t v : ids) box.add(mesh.vertices[v]);
      if (box.meets(where)) parts.push_back({i, ids, box});
    }
  }
}

/// One tree against another.
class PairSearch {
 public:
  PairSearch(const ModelMesh& mesh, double depth, std::vector<Crossing>& found)
      : mesh_(mesh), depth_(depth), found_(found) {}

  void search(const ElementTree& one, const ElementTree& other) {
    constexpr std::size_t kNone = ~std::size_t{0};
    std::vector<Part> mine, its;
    std::size_t lastRun = kNone;  // the runs of the other tree near one of this come in a row
    const bool isSelf = &one == &other;
    one.forEachNear(other, depth_, [&](const auto& run, const auto& otherRun) {
      if (run.first != lastRun) findParts(mesh_, run, run.box, mine);
      lastRun = run.first;
      const Box3 where = ElementTree::grown(otherRun.box, depth_);
      Box3 near;  // around what reaches there
      for (const Part& part : mine)
        if (part.box.meets(where)) near.add(part.box);
      near = ElementTree::grown(near, depth_);
      if (!near.meets(otherRun.box)) return;
      findParts(mesh_, otherRun, near, its);
      const bool isOneRun = isSelf && run.first == otherRun.first;
      for (const Part& part : mine)
        for (const Part& another : its)
          if (!isOneRun || part.element < another.element) examine(part, another);
    });
  }

 private:
  void examine(const Part& part, const Part& other) {
    if (!part.box.meets(ElementTree::grown(other.box, depth_))) return;
    const std::optional<bool> isFold = meeting(part, other);
    if (!isFold) return;
    const auto [low, high] = std::minmax(part.element, other.element);
    found_.push_back({{ElementId(low), ElementId(high)},
                      {mesh_.face[low], mesh_.face[high]},
                      *isFold,
                      middleOfBoth(part.box, other.box),
                      {widthOf(low), widthOf(high)}});
  }

  double widthOf(std::size_t element) const {
    const auto corners = mesh_.elements[element].vertices();
    double longest = 0;
    for (const VertexId a : corners)
      for (const VertexId b : corners)
        longest = std::max(longest, distance(mesh_.vertices[a.value], mesh_.vertices[b.value]));
    return longest;
  }

  static Point3 middleOfBoth(const Box3& a, const Box3& b) {
    const auto middle = [](double lowA, double highA, double lowB, double highB) {
      return (std::max(lowA, lowB) + std::min(highA, highB)) / 2;
    };
    return {middle(a.low.x, a.high.x, b.low.x, b.high.x),
            middle(a.low.y, a.high.y, b.low.y, b.high.y),
            middle(a.low.z, a.high.z, b.low.z, b.high.z)};
  }

  Corners cornersOf(const Part& part) const {
    const auto& [a, b, c] = part.vertices;
    return {mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]};
  }

  /// Whether they overlap at a common edge (true), cross (false), or neither.
  std::optional<bool> meeting(const Part& part, const Part& other) const {
    std::array<bool, 3> isCommon{}, isCommonInOther{};
    int common = 0;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b)
        if (part.vertices[a] == other.vertices[b]) {
          isCommon[a] = isCommonInOther[b] = true;
          ++common;
        }
    if (common == 3) return true;
    const Corners corners = cornersOf(part), itsCorners = cornersOf(other);
    if (common == 2) {
      const auto lone = [](const std::array<bool, 3>& flags) {
        return static_cast<std::size_t>(std::ranges::find(flags, false) - flags.begin());
      };
      const std::size_t a = lone(isCommon), b = lone(isCommonInOther);
      const bool isFolded = areFolded(corners[(a + 1) % 3], corners[(a + 2) % 3], corners[a],
                                      itsCorners[b], kFoldAngle);
      return isFolded ? std::optional(true) : std::nullopt;
    }
    const bool crosses = reachIntoEachOther(corners, itsCorners, depth_);
    return crosses ? std::optional(false) : std::nullopt;
  }

  const ModelMesh& mesh_;
  double depth_;
  std::vector<Crossing>& found_;
};

}  // namespace

void addCrossings(const ModelMesh& mesh, const ElementTree& one, const ElementTree& other,
                  double depth, std::vector<Crossing>& found) {
  PairSearch(mesh, depth, found).search(one, other);
}

/// Of both halves of a quadrilateral the one that folds comes first, then the one in the first
/// place: the order in which they were found does not matter.
void sortCrossings(std::vector<Crossing>& crossings) {
  const auto key = [](const Crossing& crossing) {
    const Point3& p = crossing.place;
    return std::tuple(crossing.elements, !crossing.isFold, p.x, p.y, p.z);
  };
  std::sort(crossings.begin(), crossings.end(),
            [&](const Crossing& a, const Crossing& b) { return key(a) < key(b); });
  const auto same = std::ranges::unique(crossings, {}, &Crossing::elements);
  crossings.erase(same.begin(), same.end());
}

double depthFor(const std::vector<Box3>& boxes) {
  Box3 all;
  for (const Box3& box : boxes) all.add(box);
  return kDepth * distance(all.low, all.high);
}

}  // namespace af2::geometry
