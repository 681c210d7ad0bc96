#include "geometry/occ/assembly/fused_parts.h"

#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "engine/base/error.h"
#include "geometry/base/disjoint_sets.h"
#include "geometry/occ/assembly/common_pieces.h"

namespace af2::geometry {

namespace {

/// Relative to the volume of a part.
constexpr double kVolumeKept = 1e-6;

std::string textOf(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", number);
  return text;
}

bool isInside(const TopoDS_Shape& face) {
  return face.Orientation() == TopAbs_INTERNAL || face.Orientation() == TopAbs_EXTERNAL;
}

/// Edges that the faces around a solid use an odd number of times; its shells are closed if there
/// are none.
std::size_t openEdges(const TopoDS_Shape& solid) {
  TopTools_IndexedMapOfShape edges;
  std::vector<int> uses;
  for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next()) {
    if (isInside(face.Current())) continue;
    for (TopExp_Explorer it(face.Current(), TopAbs_EDGE); it.More(); it.Next()) {
      if (BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) continue;
      const auto index = static_cast<std::size_t>(edges.Add(it.Current()));
      uses.resize(static_cast<std::size_t>(edges.Extent()));
      ++uses[index - 1];
    }
  }
  return static_cast<std::size_t>(std::ranges::count_if(uses, [](int n) { return n % 2 == 1; }));
}

struct VolumeChange {
  double before = 0, after = 0;
  bool isWithin(double slack) const {
    return std::abs(after - before) <= kVolumeKept * before + slack;
  }
};

double exactVolumeOf(const TopoDS_Shape& solid) {
  constexpr double kExact = 1e-7;
  GProp_GProps props;
  BRepGProp::VolumeProperties(solid, props, kExact);
  return std::abs(props.Mass());
}

/// The usual integration is not exact on splines, where it depends on how faces are split; the
/// exact one is slow.
VolumeChange volumeChange(const std::vector<TopoDS_Shape>& before,
                          const std::vector<TopoDS_Shape>& after) {
  const auto changeBy = [&](double (*volume)(const TopoDS_Shape&)) {
    VolumeChange change;
    for (const TopoDS_Shape& solid : before) change.before += volume(solid);
    for (const TopoDS_Shape& solid : after) change.after += volume(solid);
    return change;
  };
  const VolumeChange change = changeBy(volumeOf);
  return change.isWithin(0) ? change : changeBy(exactVolumeOf);
}

/// Without faces that lie inside it: these belong to sheets, and bound nothing.
std::vector<TopoDS_Shape> withoutFacesInside(const TopoDS_Shape& solid) {
  std::vector<TopoDS_Shape> faces;
  bool hasInner = false;
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
    hasInner = hasInner || isInside(it.Current());
    if (!isInside(it.Current())) faces.push_back(it.Current());
  }
  if (!hasInner) return {solid};
  return solidsBetween(faces);
}

class PartFuser {
 public:
  PartFuser(const ModelShape& model, const std::vector<ModelPart>& parts, Overlaps overlaps,
            const FuseOptions& options)
      : model_(model),
        parts_(parts),
        overlaps_(overlaps),
        tolerance_(options.tolerance),
        fuse_(fuseShapes(shapesOf(parts), options)) {}

  FusedParts fuse() {
    for (int face = 1; face <= model_.faces.Extent(); ++face)
      fused_.facePieces.push_back(fuse_->piecesOf(model_.faces(face)));
    for (std::size_t part = 0; part < parts_.size(); ++part) takePieces(part);
    if (overlaps_ == Overlaps::Refuse) refuseOverlaps();
    for (std::size_t piece = 0; piece < owners_.size(); ++piece) assign(piece);
    for (std::size_t part = 0; part < parts_.size(); ++part) join(part);
    tellOverlaps();
    return std::move(fused_);
  }

 private:
  using PartPair = std::pair<std::size_t, std::size_t>;

  static std::vector<TopoDS_Shape> shapesOf(const std::vector<ModelPart>& parts) {
    std::vector<TopoDS_Shape> shapes;
    for (const ModelPart& part : parts) shapes.push_back(part.shape);
    return shapes;
  }

  void takePieces(std::size_t part) {
    fused_.parts.push_back({parts_[part].name, parts_[part].isSolid, {}});
    if (!parts_[part].isSolid) return takeSheet(part);
    const std::vector<TopoDS_Shape> pieces = fuse_->piecesOf(parts_[part].shape);
    checkPieces(parts_[part], pieces);
    for (const TopoDS_Shape& piece : pieces) {
      const auto index = static_cast<std::size_t>(solids_.Add(piece));
      owners_.resize(static_cast<std::size_t>(solids_.Extent()));
      owners_[index - 1].push_back(part);
    }
  }

  /// The pieces of a sheet keep its orientation. Where pieces of several faces became one, it may
  /// be that of another face.
  static TopoDS_Shape turnedLike(const TopoDS_Shape& face, const TopoDS_Shape& piece) {
    return isTurned(piece, face) ? piece.Reversed() : piece;
  }

  void takeSheet(std::size_t part) {
    TopTools_IndexedMapOfShape own;
    for (const int face : parts_[part].faces)
      for (const TopoDS_Shape& piece : fused_.facePieces[static_cast<std::size_t>(face) - 1]) {
        if (own.Contains(piece)) continue;
        own.Add(piece);
        sheetFaces_.Add(piece);
        fused_.parts.back().shapes.push_back(turnedLike(model_.faces(face), piece));
      }
  }

  void checkPieces(const ModelPart& part, const std::vector<TopoDS_Shape>& pieces) const {
    if (pieces.empty()) throw GeometryError("the solid '" + part.name + "' vanished");
    checkVolume(part, pieces);
    if (openEdges(part.shape) > 0) return;
    for (const TopoDS_Shape& piece : pieces)
      if (openEdges(piece) > 0)
        throw GeometryError("a piece of the solid '" + part.name + "' is not closed");
  }

  /// What the tolerance can change of a volume.
  double slackOf(const std::vector<TopoDS_Shape>& solids) const {
    double area = 0;
    for (const TopoDS_Shape& solid : solids) {
      GProp_GProps surface;
      BRepGProp::SurfaceProperties(solid, surface);
      area += surface.Mass();
    }
    return tolerance_ * area;
  }

  void checkVolume(const ModelPart& part, const std::vector<TopoDS_Shape>& pieces) const {
    const VolumeChange change = volumeChange({part.shape}, pieces);
    if (!change.isWithin(slackOf({part.shape})))
      throw GeometryError("the volume of '" + part.name + "' would change from " +
                          textOf(change.before) + " to " + textOf(change.after));
  }

  std::map<PartPair, double> overlapVolumes() const {
    std::map<PartPair, double> volumes;
    for (std::size_t piece = 0; piece < owners_.size(); ++piece)
      for (std::size_t i = 0; i < owners_[piece].size(); ++i)
        for (std::size_t k = i + 1; k < owners_[piece].size(); ++k)
          volumes[{owners_[piece][i], owners_[piece][k]}] +=
              volumeOf(solids_(static_cast<int>(piece) + 1));
    return volumes;
  }

  void refuseOverlaps() const {
    const std::map<PartPair, double> volumes = overlapVolumes();
    if (volumes.empty()) return;
    constexpr std::size_t kMaxListed = 5;
    std::string text;
    std::size_t listed = 0;
    for (const auto& [pair, volume] : volumes) {
      if (++listed > kMaxListed) break;
      text += std::string(text.empty() ? "" : ", ") + "'" + parts_[pair.first].name + "' and '" +
              parts_[pair.second].name + "' (volume " + textOf(volume) + ")";
    }
    if (volumes.size() > kMaxListed)
      text += " and " + std::to_string(volumes.size() - kMaxListed) + " more pairs";
    throw InputError("solids overlap: " + text +
                     "; say which part keeps the common volume: the first one, the last one, or "
                     "none, so that it is cut out as a solid of its own (--overlap first, last or "
                     "cut)");
  }

  void assign(std::size_t piece) {
    const TopoDS_Shape& solid = solids_(static_cast<int>(piece) + 1);
    const std::vector<std::size_t>& owners = owners_[piece];
    if (owners.size() == 1 || overlaps_ == Overlaps::First)
      return fused_.parts[owners.front()].shapes.push_back(solid);
    if (overlaps_ == Overlaps::Last) return fused_.parts[owners.back()].shapes.push_back(solid);
    const std::size_t index = cut_.emplace(owners, fused_.parts.size()).first->second;
    if (index == fused_.parts.size()) fused_.parts.push_back({nameOf(owners), true, {}});
    fused_.parts[index].shapes.push_back(solid);
  }

  std::string nameOf(const std::vector<std::size_t>& owners) const {
    std::string name;
    for (const std::size_t part : owners) name += (name.empty() ? "" : "&") + parts_[part].name;
    return name;
  }

  /// Removes the walls between pieces of a solid that other solids have left there. Walls that are
  /// sheets stay.
  void join(std::size_t part) {
    FusedPart& fused = fused_.parts[part];
    if (!fused.isSolid || fused.shapes.empty()) return;
    std::vector<TopoDS_Shape> joined;
    for (const std::vector<TopoDS_Shape>& cluster : clustersOf(fused.shapes))
      for (const TopoDS_Shape& solid : cluster.size() == 1 ? cluster : joinedSolids(cluster))
        for (const TopoDS_Shape& clean : withoutFacesInside(solid)) joined.push_back(clean);
    fused.shapes = std::move(joined);
  }

  std::vector<TopoDS_Shape> joinedSolids(const std::vector<TopoDS_Shape>& pieces) const {
    std::vector<TopoDS_Shape> solids = solidsBetween(outerFaces(pieces));
    const VolumeChange change = volumeChange(pieces, solids);
    if (!change.isWithin(slackOf(pieces)))
      throw GeometryError("pieces of a solid have the volume " + textOf(change.before) + ", but " +
                          textOf(change.after) + " after they are joined");
    return solids;
  }

  std::vector<std::vector<TopoDS_Shape>> clustersOf(const std::vector<TopoDS_Shape>& pieces) const {
    DisjointSets sets(pieces.size());
    TopTools_IndexedMapOfShape faces;
    std::vector<std::uint32_t> pieceOf;
    for (std::uint32_t i = 0; i < pieces.size(); ++i)
      for (TopExp_Explorer it(pieces[i], TopAbs_FACE); it.More(); it.Next()) {
        const TopoDS_Shape& face = it.Current();
        if (isInside(face) || sheetFaces_.Contains(face)) continue;
        const auto index = static_cast<std::size_t>(faces.Add(face));
        if (index > pieceOf.size())
          pieceOf.push_back(i);
        else
          sets.join(i, pieceOf[index - 1]);
      }
    std::map<std::uint32_t, std::vector<TopoDS_Shape>> clusters;
    for (std::uint32_t i = 0; i < pieces.size(); ++i) clusters[sets.of(i)].push_back(pieces[i]);
    std::vector<std::vector<TopoDS_Shape>> result;
    for (auto& [first, cluster] : clusters) result.push_back(std::move(cluster));
    return result;
  }

  /// Those that only one of the pieces has.
  static std::vector<TopoDS_Shape> outerFaces(const std::vector<TopoDS_Shape>& pieces) {
    TopTools_IndexedMapOfShape faces;
    std::vector<int> uses;
    for (const TopoDS_Shape& piece : pieces)
      for (TopExp_Explorer it(piece, TopAbs_FACE); it.More(); it.Next()) {
        if (isInside(it.Current())) continue;
        const auto index = static_cast<std::size_t>(faces.Add(it.Current()));
        uses.resize(static_cast<std::size_t>(faces.Extent()));
        ++uses[index - 1];
      }
    std::vector<TopoDS_Shape> outer;
    for (int i = 1; i <= faces.Extent(); ++i)
      if (uses[static_cast<std::size_t>(i) - 1] == 1) outer.push_back(faces(i));
    return outer;
  }

  void tellOverlaps() {
    for (const auto& [pair, volume] : overlapVolumes()) {
      const std::string& one = parts_[pair.first].name;
      const std::string& other = parts_[pair.second].name;
      fused_.changes.push_back(
          "overlap of '" + one + "' and '" + other + "' (volume " + textOf(volume) + ") " +
          (overlaps_ == Overlaps::Cut
               ? std::string("is a solid of its own")
               : "given to '" + (overlaps_ == Overlaps::First ? one : other) + "'"));
    }
    for (std::size_t part = 0; part < parts_.size(); ++part)
      if (parts_[part].isSolid && fused_.parts[part].shapes.empty())
        fused_.changes.push_back("nothing is left of '" + parts_[part].name +
                                 "': all its volume belongs to other parts");
  }

  const ModelShape& model_;
  const std::vector<ModelPart>& parts_;
  Overlaps overlaps_;
  double tolerance_;
  std::unique_ptr<GeneralFuse> fuse_;
  FusedParts fused_;
  TopTools_IndexedMapOfShape solids_;             // pieces of all solids
  std::vector<std::vector<std::size_t>> owners_;  // of each piece: parts, ascending
  TopTools_IndexedMapOfShape sheetFaces_;
  std::map<std::vector<std::size_t>, std::size_t> cut_;  // overlaps by their owners
};

}  // namespace

FusedParts fuseParts(const ModelShape& model, const std::vector<ModelPart>& parts,
                     Overlaps overlaps, const FuseOptions& options) {
  return PartFuser(model, parts, overlaps, options).fuse();
}

}  // namespace af2::geometry
