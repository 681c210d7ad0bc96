#include "geometry/occ/assembly/common_pieces.h"

#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <map>

#include "engine/base/error.h"
#include "geometry/occ/base/points.h"

namespace af2::geometry {

namespace {

/// The pieces of a part after the fuse.
struct Pieces {
  TopTools_IndexedMapOfShape solids, faces, edges, vertices;
};

class Comparison {
 public:
  Comparison(const ModelShape& model, const ModelPart& one, const ModelPart& other,
             const FuseOptions& options)
      : model_(model), parts_{&one, &other}, fuse_(fuseShapes({one.shape, other.shape}, options)) {
    for (std::size_t i : {0u, 1u}) pieces_[i] = piecesOf(*parts_[i]);
    findShared();
  }

  PartContact contact() {
    PartContact contact;
    addVolume(contact);
    addArea(contact);
    addLength(contact);
    if (contact.volume > 0 && contact.kind != ContactKind::Coincide)
      contact.kind = ContactKind::Overlap;
    if (contact.volume == 0 && contact.area == 0 && contact.length == 0) addPoint(contact);
    return contact;
  }

 private:
  Pieces piecesOf(const ModelPart& part) {
    Pieces pieces;
    std::vector<TopoDS_Shape> shapes;
    if (part.isSolid) {
      for (const TopoDS_Shape& solid : fuse_->piecesOf(part.shape)) shapes.push_back(solid);
    } else {
      for (const int face : part.faces)
        for (const TopoDS_Shape& piece : fuse_->piecesOf(model_.faces(face)))
          shapes.push_back(piece);
    }
    if (shapes.empty()) throw GeometryError("a part vanished");
    for (const TopoDS_Shape& shape : shapes) {
      TopExp::MapShapes(shape, TopAbs_SOLID, pieces.solids);
      for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
        if (it.Current().Orientation() == TopAbs_INTERNAL) continue;  // a sheet in a solid
        pieces.faces.Add(it.Current());
        TopExp::MapShapes(it.Current(), TopAbs_EDGE, pieces.edges);
        TopExp::MapShapes(it.Current(), TopAbs_VERTEX, pieces.vertices);
      }
    }
    return pieces;
  }

  /// What the parts share as the model has it: meshes match there.
  void findShared() {
    TopTools_IndexedMapOfShape inner[2];
    for (std::size_t i : {0u, 1u})
      for (const TopAbs_ShapeEnum type : {TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX})
        TopExp::MapShapes(parts_[i]->shape, type, inner[i]);
    for (int k = 1; k <= inner[0].Extent(); ++k)
      if (inner[1].Contains(inner[0](k)))
        for (const TopoDS_Shape& piece : fuse_->piecesOf(inner[0](k))) shared_.Add(piece);
  }

  /// Pieces of both parts that they do not share already.
  std::vector<TopoDS_Shape> common(TopTools_IndexedMapOfShape Pieces::*kind) const {
    std::vector<TopoDS_Shape> shapes;
    const TopTools_IndexedMapOfShape& own = pieces_[0].*kind;
    for (int i = 1; i <= own.Extent(); ++i)
      if ((pieces_[1].*kind).Contains(own(i)) && !shared_.Contains(own(i)))
        shapes.push_back(own(i));
    return shapes;
  }

  void addVolume(PartContact& contact) const {
    GProp_GProps all;
    const std::vector<TopoDS_Shape> solids = common(&Pieces::solids);
    for (const TopoDS_Shape& solid : solids) {
      GProp_GProps props;
      BRepGProp::VolumeProperties(solid, props);
      contact.volume += std::abs(props.Mass());
      all.Add(props);
    }
    if (solids.empty()) return;
    contact.place = toPoint(all.CentreOfMass());
    const auto count = static_cast<int>(solids.size());
    if (count == pieces_[0].solids.Extent() && count == pieces_[1].solids.Extent())
      contact.kind = ContactKind::Coincide;
  }

  void addArea(PartContact& contact) {
    GProp_GProps all;
    for (const TopoDS_Shape& face : common(&Pieces::faces)) {
      GProp_GProps props;
      BRepGProp::SurfaceProperties(face, props);
      contact.area += std::abs(props.Mass());
      all.Add(props);
      TopExp::MapShapes(face, TopAbs_EDGE, around_);
      TopExp::MapShapes(face, TopAbs_VERTEX, around_);
    }
    if (contact.area == 0) return;
    if (contact.volume == 0) contact.place = toPoint(all.CentreOfMass());
    findTwins(contact);
  }

  /// Faces that are one face after the fuse.
  void findTwins(PartContact& contact) {
    TopTools_IndexedMapOfShape whole;
    std::map<int, int> faceOf;  // by index of its only piece
    for (const int face : parts_[1]->faces)
      if (const auto pieces = fuse_->piecesOf(model_.faces(face)); pieces.size() == 1)
        faceOf[whole.Add(pieces.front())] = face;
    for (const int face : parts_[0]->faces) {
      const auto pieces = fuse_->piecesOf(model_.faces(face));
      if (pieces.size() != 1) continue;
      const int index = whole.FindIndex(pieces.front());
      if (index > 0 && faceOf[index] != face) contact.twins.emplace_back(face, faceOf[index]);
    }
  }

  void addLength(PartContact& contact) {
    GProp_GProps all;
    for (const TopoDS_Shape& edge : common(&Pieces::edges)) {
      if (around_.Contains(edge) || BRep_Tool::Degenerated(TopoDS::Edge(edge))) continue;
      GProp_GProps props;
      BRepGProp::LinearProperties(edge, props);
      contact.length += props.Mass();
      all.Add(props);
    }
    if (contact.length > 0 && contact.area == 0 && contact.volume == 0)
      contact.place = toPoint(all.CentreOfMass());
  }

  void addPoint(PartContact& contact) const {
    const std::vector<TopoDS_Shape> vertices = common(&Pieces::vertices);
    if (vertices.empty()) return;
    contact.isAtPoint = true;
    contact.place = toPoint(BRep_Tool::Pnt(TopoDS::Vertex(vertices.front())));
  }

  const ModelShape& model_;
  const ModelPart* parts_[2];
  std::unique_ptr<GeneralFuse> fuse_;
  Pieces pieces_[2];
  TopTools_IndexedMapOfShape shared_, around_;
};

}  // namespace

double volumeOf(const TopoDS_Shape& solid) {
  GProp_GProps props;
  BRepGProp::VolumeProperties(solid, props);
  return std::abs(props.Mass());
}

PartContact contactBetween(const ModelShape& model, const ModelPart& one, const ModelPart& other,
                           const FuseOptions& options) {
  try {
    return Comparison(model, one, other, options).contact();
  } catch (const Standard_Failure& failure) {
    throw GeometryError(failure.DynamicType()->Name());
  }
}

}  // namespace af2::geometry
