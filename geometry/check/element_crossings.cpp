#include "geometry/check/element_crossings.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "geometry/base/disjoint_sets.h"
#include "geometry/check/drawn_part.h"
#include "geometry/check/element_pairs.h"
#include "geometry/check/element_tree.h"
#include "geometry/check/flat_patch.h"
#include "geometry/check/patch_outline.h"

namespace af2::geometry {

namespace {

/// The elements of one face.
struct FacePatch {
  OutlinedPatch patch;
  std::optional<FlatPatch> flat = {};
  bool mayCrossItself = true;
  ElementTree tree = {};  ///< if it is held against one
};

class Search {
 public:
  Search(const ModelMesh& mesh, const Repeat& repeat) : mesh_(mesh), repeat_(repeat) {}

  std::vector<Crossing> find() {
    if (mesh_.elements.empty()) return {};
    const PatchOutlines outlines(mesh_, repeat_);
    findPatches(outlines);
    findShells();
    findShapes(outlines);
    std::vector<Box3> boxes;
    for (const FacePatch& face : faces_) boxes.push_back(face.patch.box);
    depth_ = depthFor(boxes);
    findFlatFaces();
    const auto pairs = nearPairs(std::move(boxes), depth_, [&](std::size_t i, std::size_t k) {
      if (i == k) return faces_[i].mayCrossItself;
      return shell_[i] == shell_[k] && !isStarShaped_[shell_[i]] && !arePartedByAPlane(i, k);
    });
    growTrees(pairs);
    std::vector<std::vector<Crossing>> found(pairs.size());
    repeat_(pairs.size(), [&](std::size_t i) {
      addCrossings(mesh_, faces_[pairs[i].first].tree, faces_[pairs[i].second].tree, depth_,
                   found[i]);
    });
    std::vector<Crossing> crossings;
    for (const auto& some : found) crossings.insert(crossings.end(), some.begin(), some.end());
    sortCrossings(crossings);
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
    std::map<std::size_t, std::vector<const OutlinedPatch*>> patches;  // by shell
    for (std::size_t i = 0; i < faces_.size(); ++i) patches[shell_[i]].push_back(&faces_[i].patch);
    std::vector<std::size_t> shells;
    for (const auto& [shell, all] : patches) shells.push_back(shell);
    isStarShaped_.resize(faces_.size(), 0);
    repeat_(shells.size(), [&](std::size_t i) {
      isStarShaped_[shells[i]] = outlines.isStarShaped(patches.at(shells[i]));
    });
    repeat_(faces_.size(), [&](std::size_t i) {
      const OutlinedPatch* patch = &faces_[i].patch;
      const bool isAlone = patches.at(shell_[i]).size() == 1;
      faces_[i].mayCrossItself = !isStarShaped_[shell_[i]] && !outlines.canBeDrawn(*patch) &&
                                 (isAlone || !outlines.isStarShaped({&patch, 1}));
    });
  }

  void findFlatFaces() {
    repeat_(faces_.size(), [&](std::size_t i) {
      if (!isStarShaped_[shell_[i]]) faces_[i].flat = flatPatchOf(mesh_, faces_[i].patch, depth_);
    });
  }
  bool arePartedByAPlane(std::size_t i, std::size_t k) const {
    const FacePatch &one = faces_[i], &other = faces_[k];
    return one.flat && other.flat &&
           geometry::arePartedByAPlane(mesh_, one.patch, *one.flat, other.patch, *other.flat,
                                       depth_);
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
    const OutlinedPatch& patch = face.patch;
    // To ask each element about many boxes costs more than to have it in a tree.
    constexpr std::size_t kManyBoxes = 16;
    const bool takesAll = face.mayCrossItself || boxes.size() > kManyBoxes;
    std::vector<std::uint32_t> found;
    for (std::size_t run = 0; run < patch.boxes.size(); ++run) {
      std::vector<Box3> near;
      for (const Box3& box : boxes)
        if (box.meets(patch.boxes[run])) near.push_back(box);
      if (near.empty() && !takesAll) continue;
      const std::size_t begin = run * OutlinedPatch::kRun,
                        end = std::min(begin + OutlinedPatch::kRun, patch.last - patch.first);
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
