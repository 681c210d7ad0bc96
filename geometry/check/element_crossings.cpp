#include "geometry/check/element_crossings.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "geometry/base/disjoint_sets.h"
#include "geometry/check/drawn_part.h"
#include "geometry/check/element_tree.h"
#include "geometry/check/patch_outline.h"
#include "geometry/check/triangle_pair.h"

namespace af2::geometry {

namespace {

/// Elements that reach into each other by less than this share of the mesh's diagonal touch: its
/// points are no more exact, nor are the models.
constexpr double kDepth = 1e-9;
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

/// The elements of one face.
struct FacePatch {
  Patch patch;
  bool mayCrossItself = true;
  ElementTree tree = {};  ///< if it is held against one
};

class Search {
 public:
  Search(const ModelMesh& mesh, const Repeat& repeat) : mesh_(mesh), repeat_(repeat) {}

  std::vector<Crossing> find() {
    if (mesh_.elements.empty()) return {};
    const PatchOutlines outlines(mesh_);
    findPatches(outlines);
    findShells();
    findShapes(outlines);
    Box3 all;
    for (const FacePatch& face : faces_) all.add(face.patch.box);
    depth_ = kDepth * distance(all.low, all.high);
    const auto pairs = nearPairs();
    growTrees(pairs);
    std::vector<std::vector<Crossing>> found(pairs.size());
    repeat_(pairs.size(), [&](std::size_t i) {
      searchPair(faces_[pairs[i].first], faces_[pairs[i].second], found[i]);
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
  void findPatches(const PatchOutlines& outlines) {
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < mesh_.elements.size(); ++i)
      if (i == 0 || mesh_.face[i] != mesh_.face[i - 1]) starts.push_back(i);
    starts.push_back(mesh_.elements.size());
    faces_.resize(starts.size() - 1);
    repeat_(faces_.size(),
            [&](std::size_t i) { faces_[i].patch = outlines.patch(starts[i], starts[i + 1]); });
  }

  /// Faces with a common vertex are of one shell.
  void findShells() {
    constexpr std::uint32_t kNone = 0xffffffffu;
    DisjointSets shells(faces_.size());
    std::vector<std::uint32_t> faceAt(mesh_.vertices.size(), kNone);
    for (std::size_t i = 0; i < faces_.size(); ++i)
      for (const std::uint32_t v : faces_[i].patch.onSegments) {
        std::uint32_t& other = faceAt[v];
        const auto own = static_cast<std::uint32_t>(i);
        if (other != kNone) shells.join(own, other);
        other = own;
      }
    for (std::uint32_t i = 0; i < faces_.size(); ++i) shell_.push_back(shells.of(i));
  }

  void findShapes(const PatchOutlines& outlines) {
    std::map<std::size_t, std::vector<const Patch*>> patches;  // by shell
    for (std::size_t i = 0; i < faces_.size(); ++i) patches[shell_[i]].push_back(&faces_[i].patch);
    std::vector<std::size_t> shells;
    for (const auto& [shell, all] : patches) shells.push_back(shell);
    isStarShaped_.resize(faces_.size(), 0);
    repeat_(shells.size(), [&](std::size_t i) {
      isStarShaped_[shells[i]] = outlines.isStarShaped(patches.at(shells[i]));
    });
    repeat_(faces_.size(), [&](std::size_t i) {
      const Patch* patch = &faces_[i].patch;
      const bool isAlone = patches.at(shell_[i]).size() == 1;
      faces_[i].mayCrossItself = !isStarShaped_[shell_[i]] && !outlines.canBeDrawn(*patch) &&
                                 (isAlone || !outlines.isStarShaped({&patch, 1}));
    });
  }

  void growTrees(const std::vector<std::pair<std::size_t, std::size_t>>& pairs) {
    std::vector<std::vector<Box3>> others(faces_.size());  // around what each is held against
    for (const auto& [one, other] : pairs) {
      others[one].push_back(ElementTree::grown(faces_[other].patch.box, depth_));
      others[other].push_back(ElementTree::grown(faces_[one].patch.box, depth_));
    }
    repeat_(faces_.size(), [&](std::size_t i) {
      if (others[i].empty()) return;
      FacePatch& face = faces_[i];
      face.tree = ElementTree(mesh_, face.patch.first, elementsNear(face, others[i]));
      if (face.mayCrossItself)
        face.tree.findFree([&](std::size_t first, std::size_t count, const std::uint32_t* places) {
          return canBeDrawn({mesh_, first, count, places});
        });
    });
  }

  /// Those that reach into one of some boxes, counted from the first of the face: of two faces at
  /// an edge of a model seldom more than a strip.
  std::vector<std::uint32_t> elementsNear(const FacePatch& face,
                                          const std::vector<Box3>& boxes) const {
    const Patch& patch = face.patch;
    // To ask each element about many boxes costs more than to have it in a tree.
    constexpr std::size_t kManyBoxes = 16;
    const bool takesAll = face.mayCrossItself || boxes.size() > kManyBoxes;
    std::vector<std::uint32_t> found;
    for (std::size_t run = 0; run < patch.boxes.size(); ++run) {
      std::vector<Box3> near;
      for (const Box3& box : boxes)
        if (box.meets(patch.boxes[run])) near.push_back(box);
      if (near.empty() && !takesAll) continue;
      const std::size_t begin = run * Patch::kRun,
                        end = std::min(begin + Patch::kRun, patch.last - patch.first);
      for (std::size_t i = begin; i < end; ++i)
        if (takesAll || reaches(mesh_.elements[patch.first + i], near))
          found.push_back(static_cast<std::uint32_t>(i));
    }
    return found;
  }

  bool reaches(const Element& element, const std::vector<Box3>& boxes) const {
    Box3 own;
    for (const VertexId v : element.vertices()) own.add(mesh_.vertices[v.value]);
    return std::ranges::any_of(boxes, [&](const Box3& box) { return own.meets(box); });
  }

  std::vector<std::pair<std::size_t, std::size_t>> nearPairs() {
    std::vector<Box3> boxes;
    for (const FacePatch& face : faces_)
      boxes.push_back(ElementTree::grown(face.patch.box, depth_));
    const BoxTree tree(boxes);
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      if (faces_[i].mayCrossItself) pairs.emplace_back(i, i);
      tree.forEachIn(boxes[i], [&](std::size_t k) {
        if (k > i && shell_[i] == shell_[k] && !isStarShaped_[shell_[i]]) pairs.emplace_back(i, k);
      });
    }
    return pairs;
  }

  void searchPair(const FacePatch& one, const FacePatch& other,
                  std::vector<Crossing>& found) const {
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
  const Repeat& repeat_;
  std::vector<FacePatch> faces_;
  std::vector<std::size_t> shell_;          ///< by face: the one that stands for its shell
  std::vector<std::uint8_t> isStarShaped_;  ///< by the face that stands for a shell
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
