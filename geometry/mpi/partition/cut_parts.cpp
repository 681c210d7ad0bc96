#include "geometry/mpi/partition/cut_parts.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "geometry/formats/element_vertices.h"

namespace af2::mpi {

namespace {

using geometry::FaceElements;
using geometry::LineElement;
using geometry::MeshSlice;
using geometry::ModelMesh;

/// The number of a vertex among those of its owner.
struct Owned {
  std::int32_t owner = 0;
  std::uint64_t number = 0;
};

/// The parts at the vertices inside one face.
class InsideParts {
 public:
  void begin(std::uint32_t first) {
    first_ = first;
    partOf_.clear();
    several_.clear();
    begin_.assign(1, 0);
    parts_.clear();
  }
  void note(std::uint32_t v, std::int32_t part) {
    const std::size_t i = v - first_;
    if (i >= partOf_.size()) partOf_.resize(i + 1, kNone);
    if (partOf_[i] == kNone) partOf_[i] = part;
    if (partOf_[i] != part) several_.emplace_back(v, part);
  }
  void end() {
    const std::size_t noted = several_.size();
    for (std::size_t i = 0; i < noted; ++i)
      several_.emplace_back(several_[i].first, partOf_[several_[i].first - first_]);
    std::ranges::sort(several_);
    several_.erase(std::ranges::unique(several_).begin(), several_.end());
    for (std::size_t i = 0; i < several_.size(); ++i) {
      const auto [vertex, part] = several_[i];
      parts_.push_back(part);
      if (i + 1 < several_.size() && several_[i + 1].first == vertex) continue;
      partOf_[vertex - first_] = kSeveral - static_cast<std::int32_t>(begin_.size() - 1);
      begin_.push_back(parts_.size());
    }
  }

  std::uint32_t first() const { return first_; }
  std::uint32_t last() const { return first_ + static_cast<std::uint32_t>(partOf_.size()); }
  bool has(std::uint32_t v) const { return partOf_[v - first_] != kNone; }
  /// Ascending.
  std::span<const std::int32_t> at(std::uint32_t v) const {
    const std::int32_t& part = partOf_[v - first_];
    if (part >= 0) return std::span(&part, 1);
    const auto list = static_cast<std::size_t>(kSeveral - part);
    return std::span(parts_).subspan(begin_[list], begin_[list + 1] - begin_[list]);
  }

 private:
  static constexpr std::int32_t kNone = -1, kSeveral = -2;

  std::uint32_t first_ = 0;
  std::vector<std::int32_t> partOf_;  ///< by vertex; or kSeveral minus the number of a list
  std::vector<std::pair<std::uint32_t, std::int32_t>> several_;  ///< vertex and part
  std::vector<std::size_t> begin_;  ///< by list: where it begins in parts_
  std::vector<std::int32_t> parts_;
};

class PartCutter {
 public:
  PartCutter(const ModelMesh& mesh, const MeshDivision& division,
             std::span<const LineElement> lines, const TakePiece& take)
      : mesh_(mesh),
        division_(division),
        lines_(lines),
        take_(take),
        pieces_(static_cast<std::size_t>(division.parts)),
        wanted_(static_cast<std::size_t>(division.parts)),
        ownedVertices_(static_cast<std::size_t>(division.parts), 0),
        ownedElements_(static_cast<std::size_t>(division.parts), 0),
        lineOwners_(lines.size(), -1) {
    for (std::size_t i = 0; i < lines.size(); ++i)
      linesBySide_[std::minmax(lines[i].from, lines[i].to)].push_back(i);
  }

  std::vector<PartEnd> cut() {
    numberShared();
    forEachFaceOf(mesh_, [&](const MeshSlice& slice, const FaceElements& face, std::size_t f) {
      cutFace(slice, face, division_.faces[f]);
    });
    return ends();
  }

 private:
  static constexpr std::size_t kMostElements = 20'000;  ///< of a piece

  /// The lowest process wins: a rule that each can follow. A vertex without elements goes to the
  /// first.
  void numberShared() {
    shared_.reserve(division_.insideFrom);
    PartPiece unused;
    for (std::uint32_t v = 0; v < division_.insideFrom; ++v) {
      const auto parts = division_.partsAtVertex(v);
      shared_.push_back(numbered(parts.empty() ? 0 : parts.front()));
      if (parts.empty()) unused.vertices.push_back({mesh_.vertices[v], shared_[v].number, v, 0});
    }
    if (!unused.vertices.empty()) take_(0, std::move(unused));
  }

  Owned numbered(std::int32_t owner) {
    return {owner, ownedVertices_[static_cast<std::size_t>(owner)]++};
  }

  void cutFace(const MeshSlice& slice, const FaceElements& face,
               const MeshDivision::FacePatches& patches) {
    findOwners(slice, face, patches);
    findInside(slice, face);
    for (std::size_t i = 0; i < owners_.size(); ++i) {
      cutElement(slice, face.first - slice.firstElement + i, owners_[i]);
      for (const std::int32_t part : beside_)
        if (pieceOf(part).elements.size() >= kMostElements) finish(slice, face.face, part);
    }
    for (std::int32_t part = 0; part < division_.parts; ++part) finish(slice, face.face, part);
  }

  void findOwners(const MeshSlice& slice, const FaceElements& face,
                  const MeshDivision::FacePatches& patches) {
    owners_.clear();
    for (std::size_t e = face.first; e < face.last; ++e)
      owners_.push_back(division_.partOfPatch[patches.first + patches.tree.of(middleOf(
                                                                  slice, e - slice.firstElement))]);
  }

  /// Finds the parts, the owners and the numbers of the vertices inside the face.
  void findInside(const MeshSlice& slice, const FaceElements& face) {
    const std::size_t first = face.first - slice.firstElement;
    std::uint32_t lowest = std::numeric_limits<std::uint32_t>::max();
    const auto forEachInside = [&](const auto& visit) {
      for (std::size_t i = 0; i < owners_.size(); ++i)
        forEachMshVertex(mesh_, slice, first + i, [&](VertexId v) {
          if (isInside(v.value)) visit(v.value, owners_[i]);
        });
    };
    forEachInside([&](std::uint32_t v, std::int32_t) { lowest = std::min(lowest, v); });
    inside_.begin(lowest);
    forEachInside([&](std::uint32_t v, std::int32_t owner) { inside_.note(v, owner); });
    inside_.end();
    insideOwned_.clear();
    for (std::uint32_t v = inside_.first(); v < inside_.last(); ++v)
      insideOwned_.push_back(inside_.has(v) ? numbered(inside_.at(v).front()) : Owned{});
  }

  bool isInside(std::uint32_t v) const { return v >= division_.insideFrom; }
  std::span<const std::int32_t> partsAt(std::uint32_t v) const {
    return isInside(v) ? inside_.at(v) : division_.partsAtVertex(v);
  }

  PartPiece& pieceOf(std::int32_t part) { return pieces_[static_cast<std::size_t>(part)]; }

  /// Gives an element to its owner and, as a ghost, to the others at its corners.
  void cutElement(const MeshSlice& slice, std::size_t e, std::int32_t owner) {
    const std::size_t id = slice.firstElement + e;
    const Element& element = slice.elements[e];
    const PieceElement piece{
        id, ownedElements_[static_cast<std::size_t>(owner)]++, element.corners,
        mesh_.midsides.empty() ? std::array<VertexId, 4>{} : mesh_.midsides[id], owner};
    beside_.assign(1, owner);
    for (const VertexId v : element.vertices())
      for (const std::int32_t part : partsAt(v.value))
        if (std::ranges::count(beside_, part) == 0) beside_.push_back(part);
    std::sort(beside_.begin() + 1, beside_.end());
    for (const std::int32_t part : beside_) {
      pieceOf(part).elements.push_back(piece);
      std::vector<std::uint32_t>& wanted = wanted_[static_cast<std::size_t>(part)];
      forEachMshVertex(mesh_, slice, e, [&](VertexId v) { wanted.push_back(v.value); });
    }
    PartPiece& own = pieceOf(owner);
    own.ghostCounts.push_back(static_cast<std::int32_t>(beside_.size()) - 1);
    own.ghostsOf.insert(own.ghostsOf.end(), beside_.begin() + 1, beside_.end());
    if (!lines_.empty()) takeLines(element, owner);
  }

  /// The owner of the first element beside a line gets it.
  void takeLines(const Element& element, std::int32_t owner) {
    const auto corners = element.vertices();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto found =
          linesBySide_.find(std::minmax(corners[i], corners[(i + 1) % corners.size()]));
      if (found == linesBySide_.end()) continue;
      for (const std::size_t line : found->second)
        if (lineOwners_[line] < 0) lineOwners_[line] = owner;
    }
  }

  void finish(const MeshSlice& slice, std::int32_t face, std::int32_t part) {
    PartPiece& piece = pieceOf(part);
    if (piece.elements.empty()) return;
    std::vector<std::uint32_t>& wanted = wanted_[static_cast<std::size_t>(part)];
    std::ranges::sort(wanted);
    wanted.erase(std::ranges::unique(wanted).begin(), wanted.end());
    for (const std::uint32_t v : wanted) {
      const Owned& owned = isInside(v) ? insideOwned_[v - inside_.first()] : shared_[v];
      piece.vertices.push_back({slice.position(VertexId(v)), owned.number, v, owned.owner});
    }
    wanted.clear();
    piece.face = face;
    take_(part, std::exchange(piece, {}));
  }

  std::vector<PartEnd> ends() const {
    std::vector<PartEnd> all(static_cast<std::size_t>(division_.parts));
    for (PartEnd& end : all) {
      end.vertices = ownedVertices_;
      end.elements = ownedElements_;
      end.allLines = lines_.size();
    }
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const LineElement& line = lines_[i];
      all[static_cast<std::size_t>(std::max(lineOwners_[i], 0))].lines.push_back(
          {line.from, line.to, line.middle, i, line.edge});
    }
    return all;
  }

  const ModelMesh& mesh_;
  const MeshDivision& division_;
  const std::span<const LineElement> lines_;
  const TakePiece& take_;
  std::vector<PartPiece> pieces_;                   ///< by part: of the present face
  std::vector<std::vector<std::uint32_t>> wanted_;  ///< by part: vertices of its elements there
  std::vector<std::uint64_t> ownedVertices_, ownedElements_;  ///< by part, so far
  std::vector<Owned> shared_;                                 ///< by vertex < insideFrom
  std::vector<std::int32_t> owners_;                          ///< by element of the present face
  InsideParts inside_;
  std::vector<Owned> insideOwned_;  ///< by vertex of inside_
  std::vector<std::int32_t> beside_;
  std::map<std::pair<VertexId, VertexId>, std::vector<std::size_t>> linesBySide_;
  std::vector<std::int32_t> lineOwners_;
};

}  // namespace

std::vector<PartEnd> cutParts(const ModelMesh& mesh, const MeshDivision& division,
                              std::span<const LineElement> lines, const TakePiece& take) {
  return PartCutter(mesh, division, lines, take).cut();
}

}  // namespace af2::mpi
