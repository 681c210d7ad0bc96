#include "geometry/occ/assembly/imprint.h"

#include <BRep_Builder.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <map>
#include <set>

#include "engine/base/error.h"
#include "geometry/occ/assembly/fused_parts.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

namespace {

/// Puts the fused parts together to a model, with the names and groups of the old one.
class Assembler {
 public:
  Assembler(const ModelShape& model, const std::vector<ModelPart>& parts, const FusedParts& fused)
      : model_(model), parts_(parts), fused_(fused) {}

  ReadShape assemble(double tolerance) const {
    ReadShape read;
    read.shape = compound();
    read.unit = model_.unit;
    read.fileUnit = model_.fileUnit;
    read.notes = model_.notes;
    read.lostFaces = model_.lostFaces;
    read.healing = model_.healing;
    giveNames(read);
    giveGroups(read);
    const std::size_t interfaces = giveInterfaces(read);
    read.imprinting = Imprinting{tolerance, parts_.size(), interfaces, fused_.changes, ""};
    return read;
  }

 private:
  TopoDS_Shape compound() const {
    const BRep_Builder builder;
    TopoDS_Compound all;
    builder.MakeCompound(all);
    for (const bool isSolid : {true, false})
      for (const FusedPart& part : fused_.parts)
        for (const TopoDS_Shape& shape : part.shapes)
          if (part.isSolid == isSolid) builder.Add(all, shape);
    return all;
  }

  const std::vector<TopoDS_Shape>& piecesOf(int face) const {
    return fused_.facePieces[static_cast<std::size_t>(face) - 1];
  }

  /// Where several faces became one, the name of the first one that has a name counts.
  void giveNames(ReadShape& read) const {
    TopTools_IndexedMapOfShape pieces;
    std::vector<std::string> names;
    for (int face = 1; face <= model_.faces.Extent(); ++face)
      for (const TopoDS_Shape& piece : piecesOf(face)) {
        const auto index = static_cast<std::size_t>(pieces.Add(piece));
        if (names.size() < index) names.resize(index);
        if (names[index - 1].empty())
          names[index - 1] = model_.faceNames[static_cast<std::size_t>(face) - 1];
      }
    read.nameOf = [pieces, names](const TopoDS_Face& face) {
      const int index = pieces.FindIndex(face);
      return index > 0 ? names[static_cast<std::size_t>(index) - 1] : std::string();
    };
  }

  void giveGroups(ReadShape& read) const {
    for (const FaceGroup& group : model_.groups) {
      if (group.kind == GroupKind::Solid || group.kind == GroupKind::Interface) continue;
      ShapeGroup kept{group.name, group.kind, {}};
      // A part that has lost an overlap is bounded there by faces that were none of its own.
      std::set<int> rest(group.faces.begin(), group.faces.end());
      if (group.kind == GroupKind::Part)
        for (std::size_t i = 0; i < parts_.size(); ++i) {
          if (!std::ranges::includes(group.faces, parts_[i].faces)) continue;
          for (const int face : parts_[i].faces) rest.erase(face);
          kept.shapes.insert(kept.shapes.end(), fused_.parts[i].shapes.begin(),
                             fused_.parts[i].shapes.end());
        }
      for (const int face : rest)
        for (const TopoDS_Shape& piece : piecesOf(face)) kept.shapes.push_back(piece);
      read.groups.push_back(std::move(kept));
    }
    for (std::size_t i = parts_.size(); i < fused_.parts.size(); ++i)
      read.groups.push_back({fused_.parts[i].name, GroupKind::Part, fused_.parts[i].shapes});
  }

  /// Faces that two parts share.
  std::size_t giveInterfaces(ReadShape& read) const {
    TopTools_IndexedMapOfShape faces;
    std::vector<std::set<std::size_t>> partsOfFaces;
    for (std::size_t i = 0; i < fused_.parts.size(); ++i)
      for (const TopoDS_Shape& shape : fused_.parts[i].shapes) {
        TopTools_IndexedMapOfShape own;
        TopExp::MapShapes(shape, TopAbs_FACE, own);
        for (int k = 1; k <= own.Extent(); ++k) {
          const auto index = static_cast<std::size_t>(faces.Add(own(k)));
          partsOfFaces.resize(static_cast<std::size_t>(faces.Extent()));
          partsOfFaces[index - 1].insert(i);
        }
      }
    std::map<std::pair<std::size_t, std::size_t>, std::vector<TopoDS_Shape>> interfaces;
    for (std::size_t face = 0; face < partsOfFaces.size(); ++face)
      for (auto one = partsOfFaces[face].begin(); one != partsOfFaces[face].end(); ++one)
        for (auto other = std::next(one); other != partsOfFaces[face].end(); ++other)
          interfaces[{*one, *other}].push_back(faces(static_cast<int>(face) + 1));
    for (const auto& [pair, shared] : interfaces)
      read.groups.push_back({fused_.parts[pair.first].name + "|" + fused_.parts[pair.second].name,
                             GroupKind::Interface, shared});
    return interfaces.size();
  }

  const ModelShape& model_;
  const std::vector<ModelPart>& parts_;
  const FusedParts& fused_;
};

/// The model as it was, with the reason.
Model notImprinted(const ModelShape& model, double tolerance, std::size_t parts,
                   const std::string& reason) {
  const auto same = std::make_shared<ModelShape>(model);
  same->imprinting = Imprinting{tolerance, parts, 0, {}, reason};
  return Model(same);
}

}  // namespace

Model imprintModel(const Model& model, const ImprintOptions& options) {
  if (options.tolerance < 0)
    throw InputError("the tolerance for imprinting is negative; it must be 0 or more");
  const ModelShape& shape = model.shape();
  const double tolerance =
      options.tolerance > 0 ? options.tolerance : usualFuseTolerance(model.diagonal());
  const std::vector<ModelPart> parts = partsOf(shape);
  if (parts.size() < 2) {
    const auto same = std::make_shared<ModelShape>(shape);
    same->imprinting = Imprinting{tolerance, parts.size(), 0, {}, ""};
    return Model(same);
  }
  const FuseOptions fuse{tolerance, options.onlyEqual ? BOPAlgo_GlueFull : BOPAlgo_GlueOff,
                         options.seconds, options.stop};
  try {
    const FusedParts fused = fuseParts(shape, parts, options.overlaps, fuse);
    return Model(makeModelShape(Assembler(shape, parts, fused).assemble(tolerance)));
  } catch (const GeometryError& failure) {
    return notImprinted(shape, tolerance, parts.size(), failure.what());
  } catch (const Standard_Failure& failure) {
    return notImprinted(shape, tolerance, parts.size(),
                        std::string("OpenCASCADE failed (") + failure.DynamicType()->Name() + ")");
  }
}

}  // namespace af2::geometry
