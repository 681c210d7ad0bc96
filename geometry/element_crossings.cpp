#include "geometry/element_crossings.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "geometry/drawn_part.h"
#include "geometry/element_tree.h"
#include "geometry/patch_outline.h"
#include "geometry/triangle_pair.h"

namespace af2::geometry {

namespace {

/// Elements that reach into each other by less than this share of the mesh's diagonal touch: its
/// points are no more exact, nor are the models.
constexpr double kDepth = 1e-9;
/// Elements at a common edge lie on each other if the angle between them is below this, in radians.
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

/// Elements of one face.
struct Patch {
  std::size_t first, last;
  int face;
  Box3 box;
  bool mayCrossItself = true;
  ElementTree tree;  ///< of a patch that is held against one
};

class Search {
 public:
  Search(const ModelMesh& mesh, const Repeat& repeat) : mesh_(mesh), repeat_(repeat) {}

  std::vector<Crossing> find() {
    if (mesh_.elements.empty()) return {};
    split();
    pieces();
    findShapes();
    Box3 all;
    for (const Patch& patch : patches_) all.add(patch.box);
    depth_ = kDepth * distance(all.low, all.high);
    const auto pairs = nearPairs();
    growTrees(pairs);
    std::vector<std::vector<Crossing>> found(pairs.size());
    repeat_(pairs.size(), [&](std::size_t i) {
      searchPair(patches_[pairs[i].first], patches_[pairs[i].second], found[i]);
    });
    std::vector<Crossing> crossings;
    for (const auto& some : found) crossings.insert(crossings.end(), some.begin(), some.end());
    std::ranges::sort(crossings, {}, &Crossing::elements);
    // Both halves of a quadrilateral may be at it.
    crossings.erase(
        std::unique(crossings.begin(), crossings.end(),
                    [](const Crossing& a, const Crossing& b) { return a.elements == b.elements; }),
        crossings.end());
    return crossings;
  }

 private:
  void split() {
    for (std::size_t i = 0; i < mesh_.elements.size(); ++i) {
      if (i == 0 || mesh_.face[i] != mesh_.face[i - 1])
        patches_.push_back({i, i, mesh_.face[i], {}, true, {}});
      patches_.back().last = i + 1;
    }
  }

  void findShapes() {
    const PatchOutlines outlines(mesh_);
    findStarShapes(outlines);
    repeat_(patches_.size(), [&](std::size_t i) {
      Patch& patch = patches_[i];
      for (std::size_t k = patch.first; k < patch.last; ++k)
        for (const VertexId v : mesh_.elements[k].vertices())
          patch.box.add(mesh_.vertices[v.value]);
      const PatchOutlines::Range range(patch.first, patch.last);
      patch.mayCrossItself = !isStarShaped_[rootOf(i)] &&
                             !outlines.canBeDrawn(patch.first, patch.last) &&
                             (isAlone_[rootOf(i)] || !outlines.isStarShaped({&range, 1}));
    });
  }

  void growTrees(const std::vector<std::pair<std::size_t, std::size_t>>& pairs) {
    std::vector<std::vector<Box3>> others(patches_.size());  // around what each is held against
    for (const auto& [one, other] : pairs) {
      others[one].push_back(ElementTree::grown(patches_[other].box, depth_));
      others[other].push_back(ElementTree::grown(patches_[one].box, depth_));
    }
    repeat_(patches_.size(), [&](std::size_t i) {
      if (others[i].empty()) return;
      Patch& patch = patches_[i];
      patch.tree = ElementTree(mesh_, patch.first, elementsNear(patch, others[i]));
      if (patch.mayCrossItself)
        patch.tree.findFree([&](std::size_t first, std::size_t count, const std::uint32_t* places) {
          return canBeDrawn({mesh_, first, count, places});
        });
    });
  }

  /// Those that reach into one of some boxes, counted from the patch's first: of two faces at an
  /// edge of a model seldom more than a strip.
  std::vector<std::uint32_t> elementsNear(const Patch& patch,
                                          const std::vector<Box3>& boxes) const {
    // To ask each element about many boxes costs more than to have it in a tree.
    constexpr std::size_t kManyBoxes = 16;
    const bool takesAll = patch.mayCrossItself || boxes.size() > kManyBoxes;
    const auto reachesThere = [&](const Element& element) {
      Box3 own;
      for (const VertexId v : element.vertices()) own.add(mesh_.vertices[v.value]);
      return std::ranges::any_of(boxes, [&](const Box3& box) { return own.meets(box); });
    };
    std::vector<std::uint32_t> found;
    for (std::size_t i = patch.first; i < patch.last; ++i)
      if (takesAll || reachesThere(mesh_.elements[i]))
        found.push_back(static_cast<std::uint32_t>(i - patch.first));
    return found;
  }

  std::size_t rootOf(std::size_t patch) const {
    while (piece_[patch] != patch) patch = piece_[patch];
    return patch;
  }

  void findStarShapes(const PatchOutlines& outlines) {
    std::map<std::size_t, std::vector<PatchOutlines::Range>> ranges;  // by piece
    for (std::size_t i = 0; i < patches_.size(); ++i)
      ranges[rootOf(i)].emplace_back(patches_[i].first, patches_[i].last);
    isStarShaped_.resize(patches_.size(), 0);
    std::vector<std::size_t> roots;
    for (const auto& [root, all] : ranges) roots.push_back(root);
    isAlone_.resize(patches_.size(), 0);
    repeat_(roots.size(), [&](std::size_t i) {
      const auto& all = ranges.at(roots[i]);
      isStarShaped_[roots[i]] = outlines.isStarShaped(all);
      isAlone_[roots[i]] = all.size() == 1;
    });
  }

  /// Patches with a common vertex are of one piece.
  void pieces() {
    constexpr std::uint32_t kNone = 0xffffffffu;
    piece_.resize(patches_.size());
    std::iota(piece_.begin(), piece_.end(), std::size_t{0});
    std::vector<std::uint32_t> patchAt(mesh_.vertices.size(), kNone);
    for (std::size_t p = 0; p < patches_.size(); ++p)
      for (std::size_t i = patches_[p].first; i < patches_[p].last; ++i)
        for (const VertexId v : mesh_.elements[i].vertices()) {
          std::uint32_t& other = patchAt[v.value];
          if (other != kNone && other != p) piece_[p] = piece_[rootOf(p)] = rootOf(other);
          other = static_cast<std::uint32_t>(p);
        }
    for (std::size_t p = 0; p < piece_.size(); ++p) piece_[p] = rootOf(p);
  }

  std::vector<std::pair<std::size_t, std::size_t>> nearPairs() {
    std::vector<Box3> boxes;
    for (const Patch& patch : patches_) boxes.push_back(ElementTree::grown(patch.box, depth_));
    const BoxTree tree(boxes);
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      if (patches_[i].mayCrossItself) pairs.emplace_back(i, i);
      tree.forEachIn(boxes[i], [&](std::size_t k) {
        if (k > i && rootOf(i) == rootOf(k) && !isStarShaped_[rootOf(i)]) pairs.emplace_back(i, k);
      });
    }
    return pairs;
  }

  void searchPair(const Patch& one, const Patch& other, std::vector<Crossing>& found) const {
    constexpr std::size_t kNone = ~std::size_t{0};
    std::vector<Part> mine, its;
    std::size_t lastRun = kNone;  // the runs of the other tree near one of this come in a row
    const bool isSelf = &one == &other;
    one.tree.forEachNear(other.tree, depth_, [&](const auto& run, const auto& otherRun) {
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
          if (!isOneRun || part.element < another.element) examine(part, another, found);
    });
  }

  void examine(const Part& part, const Part& other, std::vector<Crossing>& found) const {
    if (!part.box.meets(ElementTree::grown(other.box, depth_))) return;
    const std::optional<bool> isFold = meeting(part, other);
    if (!isFold) return;
    const auto [low, high] = std::minmax(part.element, other.element);
    found.push_back({{ElementId(low), ElementId(high)},
                     {mesh_.face[low], mesh_.face[high]},
                     *isFold,
                     middleOfBoth(part.box, other.box)});
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

  /// Whether they lie on each other at a common edge (true), cross (false), or neither.
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
  const Repeat& repeat_;
  std::vector<Patch> patches_;
  std::vector<std::size_t> piece_;          ///< by patch: another one of the same piece, or itself
  std::vector<std::uint8_t> isStarShaped_;  ///< by the patch that stands for a piece
  std::vector<std::uint8_t> isAlone_;       ///< the same: whether it is the piece
  double depth_ = 0;
};

bool isAt(const Crossing& crossing, int face) {
  return crossing.faces[0] == face || crossing.faces[1] == face;
}

/// The face with the most crossings; of two with as many the later one, as what is there twice was
/// more often added than forgotten.
int worstFace(const std::vector<Crossing>& crossings) {
  std::map<int, std::size_t> counts;
  for (const Crossing& crossing : crossings) {
    ++counts[crossing.faces[0]];
    if (crossing.faces[1] != crossing.faces[0]) ++counts[crossing.faces[1]];
  }
  const auto most = [](const auto& entry) { return std::pair(entry.second, entry.first); };
  return std::ranges::max_element(counts, {}, most)->first;
}

MeshFinding findingFor(int face, const std::vector<Crossing>& crossings) {
  std::size_t pairs = 0;
  std::set<int> others;
  const Crossing* first = nullptr;
  for (const Crossing& crossing : crossings) {
    if (!isAt(crossing, face)) continue;
    if (!first) first = &crossing;
    others.insert(crossing.faces[crossing.faces[0] == face ? 1 : 0]);
    ++pairs;
  }
  std::string text = first->isFold ? "elements lie on " : "elements cross ";
  const int other = first->faces[first->faces[0] == face ? 1 : 0];
  text += other == face ? "each other" : "those of face " + std::to_string(other);
  if (others.size() > 1) text += " and " + std::to_string(others.size() - 1) + " more";
  return {face, text + " (" + std::to_string(pairs) + (pairs == 1 ? " pair)" : " pairs)"),
          first->place};
}

}  // namespace

std::vector<Crossing> elementCrossings(const ModelMesh& mesh, const Repeat& repeat) {
  return Search(mesh, repeat).find();
}

std::vector<MeshFinding> facesThatCross(std::vector<Crossing> crossings,
                                        const std::vector<int>& without) {
  for (const int face : without)
    std::erase_if(crossings, [&](const Crossing& crossing) { return isAt(crossing, face); });
  std::vector<MeshFinding> findings;
  while (!crossings.empty()) {
    const int worst = worstFace(crossings);
    findings.push_back(findingFor(worst, crossings));
    std::erase_if(crossings, [&](const Crossing& crossing) { return isAt(crossing, worst); });
  }
  return findings;
}

}  // namespace af2::geometry
