#include "geometry/check/spooled_crossings.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

#include "geometry/base/disjoint_sets.h"
#include "geometry/check/drawn_part.h"
#include "geometry/check/element_pairs.h"
#include "geometry/check/star_shape.h"
#include "geometry/spool/spooled_mesh.h"

namespace af2::geometry {

namespace {

/// A face in memory.
struct LoadedFace {
  std::size_t index;  ///< of the part
  const SpooledPart& part;
  std::span<const Point3> shared;
  FaceBulk bulk;

  LoadedFace(const ModelMesh& mesh, std::size_t i)
      : index(i),
        part(mesh.spooled->parts()[i]),
        shared(mesh.vertices),
        bulk(part.bulk->loadShape()) {}

  const Point3& position(VertexId v) const {
    const std::size_t boundary = part.boundary.size();
    return v.value < boundary ? shared[part.boundary[v.value]] : bulk.inside[v.value - boundary];
  }

  /// The elements that reach into a box, ascending.
  std::vector<std::uint32_t> elementsIn(const Box3& where, const OutlinedPatch& patch) const {
    std::vector<std::uint32_t> found;
    for (std::size_t run = 0; run < patch.boxes.size(); ++run) {
      if (!where.meets(patch.boxes[run])) continue;
      const std::size_t begin = run * OutlinedPatch::kRun;
      const std::size_t end = std::min(begin + OutlinedPatch::kRun, bulk.elements.size());
      for (std::size_t i = begin; i < end; ++i) {
        Box3 box;
        for (const VertexId v : bulk.elements[i].vertices()) box.add(position(v));
        if (box.meets(where)) found.push_back(static_cast<std::uint32_t>(i));
      }
    }
    return found;
  }
};

/// Some elements of one or two faces as a mesh.
class PartialMesh {
 public:
  /// Adds a face. Its vertices on boundaries are those that the other face has there.
  void add(const LoadedFace& face, const std::vector<std::uint32_t>& elements) {
    constexpr std::uint32_t kNone = 0xffffffffu;
    const std::size_t boundary = face.part.boundary.size();
    std::vector<std::uint32_t> placeOf(boundary + face.bulk.inside.size(), kNone);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> added;  // shared vertices
    const auto place = [&](VertexId v) {
      std::uint32_t& known = placeOf[v.value];
      if (known != kNone) return known;
      if (v.value < boundary) {
        const std::uint32_t id = face.part.boundary[v.value];
        const auto other = std::ranges::lower_bound(shared_, id, {}, &Shared::first);
        if (other != shared_.end() && other->first == id) return known = other->second;
        added.emplace_back(id, static_cast<std::uint32_t>(mesh_.vertices.size()));
      }
      known = static_cast<std::uint32_t>(mesh_.vertices.size());
      mesh_.vertices.push_back(face.position(v));
      return known;
    };
    for (const std::uint32_t e : elements) {
      Element element = face.bulk.elements[e];
      for (VertexId& v : element.corners)
        if (!v.isNone()) v = VertexId(place(v));
      mesh_.elements.push_back(element);
      mesh_.face.push_back(face.part.face);
      ids_.push_back(e);
    }
    shared_.insert(shared_.end(), added.begin(), added.end());
    std::ranges::sort(shared_);
  }

  const ModelMesh& mesh() const { return mesh_; }
  /// The number of an element in its face.
  std::size_t idOf(ElementId element) const { return ids_[element.value]; }

 private:
  using Shared = std::pair<std::uint32_t, std::uint32_t>;

  ModelMesh mesh_;
  std::vector<std::uint32_t> ids_;
  std::vector<Shared> shared_;  ///< vertices on boundaries, and where they are; ascending
};

std::vector<std::uint32_t> firstNumbers(std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

class SpooledSearch {
 public:
  SpooledSearch(const ModelMesh& mesh, const EvidenceOfParts& evidence, const Repeat& repeat)
      : mesh_(mesh), evidence_(evidence), repeat_(repeat) {}

  std::vector<Crossing> find() {
    for (std::size_t i = 0; i < evidence_.size(); ++i)
      if (!evidence_[i]->patch.boxes.empty()) faces_.push_back(i);
    findShells();
    findStarShapes();
    std::vector<Box3> boxes;
    for (const std::size_t face : faces_) boxes.push_back(patch(face).box);
    depth_ = depthFor(boxes);
    const auto pairs = nearPairs(std::move(boxes), depth_, [&](std::size_t i, std::size_t k) {
      if (i == k) return mayCrossItself(i);
      return shell_[i] == shell_[k] && !isStarShaped_[shell_[i]];
    });
    std::vector<std::vector<std::size_t>> others(faces_.size());
    for (const auto& [one, other] : pairs) others[one].push_back(other);
    std::vector<std::vector<Crossing>> found(faces_.size());
    repeat_(faces_.size(), [&](std::size_t i) { search(i, others[i], found[i]); });
    std::vector<Crossing> crossings;
    for (const auto& some : found) crossings.insert(crossings.end(), some.begin(), some.end());
    sortCrossings(crossings);
    return crossings;
  }

 private:
  const OutlinedPatch& patch(std::size_t part) const { return evidence_[part]->patch; }
  const SpooledPart& part(std::size_t i) const { return mesh_.spooled->parts()[i]; }

  /// Faces with a common vertex on segments are of one shell.
  void findShells() {
    constexpr std::uint32_t kNone = 0xffffffffu;
    std::vector<std::uint8_t> isOnSegment(mesh_.vertices.size(), 0);
    for (const EdgeSegment& segment : mesh_.segments)
      isOnSegment[segment.from.value] = isOnSegment[segment.to.value] = 1;
    DisjointSets shells(faces_.size());
    std::vector<std::uint32_t> faceAt(mesh_.vertices.size(), kNone);
    for (std::uint32_t i = 0; i < faces_.size(); ++i) {
      const SpooledPart& own = part(faces_[i]);
      for (std::size_t v = 0; v < own.boundary.size(); ++v) {
        if (!own.bulk->counts().isUsed[v] || !isOnSegment[own.boundary[v]]) continue;
        std::uint32_t& other = faceAt[own.boundary[v]];
        if (other != kNone) shells.join(i, other);
        other = i;
      }
    }
    for (std::uint32_t i = 0; i < faces_.size(); ++i) shell_.push_back(shells.of(i));
  }

  void findStarShapes() {
    std::map<std::size_t, std::vector<std::size_t>> shells;  // faces by shell
    for (std::size_t i = 0; i < faces_.size(); ++i) shells[shell_[i]].push_back(i);
    isStarShaped_.resize(faces_.size(), 0);
    isAlone_.resize(faces_.size(), 0);
    std::vector<std::size_t> first;
    for (const auto& [shell, all] : shells) {
      first.push_back(shell);
      if (all.size() == 1) isAlone_[all.front()] = 1;
    }
    repeat_(first.size(),
            [&](std::size_t i) { isStarShaped_[first[i]] = isStarShaped(shells.at(first[i])); });
  }

  bool isStarShaped(const std::vector<std::size_t>& shell) const {
    Point3 sum;
    std::size_t count = 0;
    for (const std::size_t i : shell) {
      count += part(faces_[i]).bulk->counts().elements;
      sum = sum + patch(faces_[i]).corners;
    }
    const Point3 centre = (1 / static_cast<double>(count)) * sum;
    // One element of each face is enough to reject most models that are not star-shaped.
    StarShape sample(centre), star(centre);
    for (const std::size_t i : shell) {
      const auto& c = evidence_[faces_[i]]->firstCorners;
      if (!sample.takes(c[0], c[1], c[2])) return false;
    }
    std::vector<OutlinedPatch::Side> sides;
    for (const std::size_t i : shell)
      for (const auto& [from, to] : patch(faces_[i]).sides)
        sides.emplace_back(part(faces_[i]).boundary[from], part(faces_[i]).boundary[to]);
    if (!areClosed(std::move(sides))) return false;
    for (const std::size_t i : shell) {
      const LoadedFace face(mesh_, faces_[i]);
      for (const Element& element : face.bulk.elements)
        if (!star.takes(element, [&](VertexId v) -> const Point3& { return face.position(v); }))
          return false;
    }
    return star.goesAroundOnce();
  }

  bool mayCrossItself(std::size_t i) const {
    const FaceEvidence& evidence = *evidence_[faces_[i]];
    return !isStarShaped_[shell_[i]] && !evidence.canBeDrawn &&
           (isAlone_[i] || !evidence.isStarShaped);
  }

  /// A face against itself and some later ones.
  void search(std::size_t i, const std::vector<std::size_t>& others,
              std::vector<Crossing>& found) const {
    if (others.empty()) return;
    const LoadedFace face(mesh_, faces_[i]);
    for (const std::size_t k : others) {
      if (k == i)
        searchItself(face, found);
      else
        searchPair(face, faces_[k], found);
    }
  }

  void searchItself(const LoadedFace& face, std::vector<Crossing>& found) const {
    const std::vector<std::uint32_t> all = firstNumbers(face.bulk.elements.size());
    PartialMesh own;
    own.add(face, all);
    ElementTree tree(own.mesh(), 0, all);
    tree.findFree([&](std::size_t first, std::size_t count, const std::uint32_t* places) {
      return canBeDrawn({own.mesh(), first, count, places});
    });
    std::vector<Crossing> some;
    addCrossings(own.mesh(), tree, tree, depth_, some);
    add(own, face.index, face.index, some, found);
  }

  void searchPair(const LoadedFace& face, std::size_t otherPart,
                  std::vector<Crossing>& found) const {
    const OutlinedPatch &patchOfFace = patch(face.index), &patchOfOther = patch(otherPart);
    const auto mine = face.elementsIn(ElementTree::grown(patchOfOther.box, depth_), patchOfFace);
    if (mine.empty()) return;
    const LoadedFace other(mesh_, otherPart);
    const auto its = other.elementsIn(ElementTree::grown(patchOfFace.box, depth_), patchOfOther);
    if (its.empty()) return;
    PartialMesh both;
    both.add(face, mine);
    both.add(other, its);
    const ElementTree one(both.mesh(), 0, firstNumbers(mine.size()));
    const ElementTree another(both.mesh(), mine.size(), firstNumbers(its.size()));
    std::vector<Crossing> some;
    addCrossings(both.mesh(), one, another, depth_, some);
    add(both, face.index, otherPart, some, found);
  }

  void add(const PartialMesh& partial, std::size_t one, std::size_t other,
           const std::vector<Crossing>& some, std::vector<Crossing>& found) const {
    const SpooledMesh& whole = *mesh_.spooled;
    for (Crossing crossing : some) {
      const auto& [low, high] = crossing.elements;
      crossing.elements = {ElementId(whole.firstElement(one) + partial.idOf(low)),
                           ElementId(whole.firstElement(other) + partial.idOf(high))};
      found.push_back(crossing);
    }
  }

  const ModelMesh& mesh_;
  const EvidenceOfParts& evidence_;
  const Repeat& repeat_;
  std::vector<std::size_t> faces_;          ///< parts with elements
  std::vector<std::size_t> shell_;          ///< by face: the one that stands for its shell
  std::vector<std::uint8_t> isStarShaped_;  ///< by the face that stands for a shell
  std::vector<std::uint8_t> isAlone_;       ///< by face: whether its shell has no other
  double depth_ = 0;
};

}  // namespace

std::vector<Crossing> spooledCrossings(const ModelMesh& mesh, const EvidenceOfParts& evidence,
                                       const Repeat& repeat) {
  return SpooledSearch(mesh, evidence, repeat).find();
}

}  // namespace af2::geometry
