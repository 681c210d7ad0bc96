#include "geometry/occ/read/crossed_faces.h"

#include <Adaptor3d_HSurfaceTool.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_BoundSortBox.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_Line.hxx>
#include <IntCurveSurface_HInter.hxx>
#include <IntCurveSurface_ThePolygonOfHInter.hxx>
#include <IntCurveSurface_ThePolyhedronOfHInter.hxx>
#include <IntCurveSurface_ThePolyhedronToolOfHInter.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "geometry/occ/model/turned_faces.h"

namespace af2::geometry {
namespace {

constexpr double kTolerance = 1e-7;

using Chord = std::array<gp_Pnt, 2>;

Bnd_Box boxOf(const TopoDS_Face& face) {
  Bnd_Box box;
  BRepBndLib::Add(face, box);
  return box;
}

double areaOf(const TopoDS_Face& face) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(face, properties);
  return std::abs(properties.Mass());
}

/// Short chords between points inside a face, in rows across it.
std::vector<Chord> chordsOf(const TopoDS_Face& face) {
  constexpr int kRows = 6, kSteps = 18;
  const BRepAdaptor_Surface surface(face);
  const BRepTopAdaptor_FClass2d inside(face, kTolerance);
  double u1, u2, v1, v2;
  BRepTools::UVBounds(face, u1, u2, v1, v2);
  std::vector<Chord> chords;
  const auto addRow = [&](const auto& at) {
    std::optional<gp_Pnt> before;
    for (int step = 0; step <= kSteps; ++step) {
      const gp_Pnt2d uv = at(static_cast<double>(step) / kSteps);
      const bool isInside = inside.Perform(uv) == TopAbs_IN;
      const gp_Pnt here = isInside ? surface.Value(uv.X(), uv.Y()) : gp_Pnt();
      if (isInside && before) chords.push_back({*before, here});
      before = isInside ? std::optional(here) : std::nullopt;
    }
  };
  for (int row = 0; row < kRows; ++row) {
    const double r = (row + 0.5) / kRows;
    addRow([&](double t) { return gp_Pnt2d(u1 + r * (u2 - u1), v1 + t * (v2 - v1)); });
    addRow([&](double t) { return gp_Pnt2d(u1 + t * (u2 - u1), v1 + r * (v2 - v1)); });
  }
  return chords;
}

/// A surface as a polyhedron with the boxes of its triangles, made once. OpenCASCADE makes one for
/// each line that it intersects with a surface.
class Drawn {
 public:
  explicit Drawn(const Handle(BRepAdaptor_Surface) & surface)
      : surface_(surface),
        polyhedron_(surface, stepsOf(Adaptor3d_HSurfaceTool::NbSamplesU(surface)),
                    stepsOf(Adaptor3d_HSurfaceTool::NbSamplesV(surface)),
                    surface->FirstUParameter(), surface->FirstVParameter(),
                    surface->LastUParameter(), surface->LastVParameter()) {
    boxes_.Initialize(IntCurveSurface_ThePolyhedronToolOfHInter::Bounding(polyhedron_),
                      IntCurveSurface_ThePolyhedronToolOfHInter::ComponentsBounding(polyhedron_));
  }

  void intersect(const Handle(GeomAdaptor_Curve) & curve, IntCurveSurface_HInter& meets) {
    meets.Perform(curve, IntCurveSurface_ThePolygonOfHInter(curve, 2), surface_, polyhedron_,
                  boxes_);
  }

 private:
  static int stepsOf(int samples) {
    constexpr int kMost = 40;
    return std::min(samples, kMost);
  }

  Handle(BRepAdaptor_Surface) surface_;
  IntCurveSurface_ThePolyhedronOfHInter polyhedron_;
  Bnd_BoundSortBox boxes_;
};

/// Counts what passes through a face, but for what may only touch it at its boundary.
///
/// IntCurvesFace_Intersector is not used, because it fails next to edges without a curve, such as
/// poles.
class Crossed {
 public:
  explicit Crossed(const TopoDS_Face& face)
      : face_(face),
        surface_(new BRepAdaptor_Surface(face)),
        within_(face, kTolerance),
        margin_(kMargin * std::sqrt(areaOf(face))) {}

  /// Stops at `most`.
  int by(const std::vector<Chord>& chords, int most) {
    int count = 0;
    for (const auto& [from, to] : chords) {
      if (count >= most) return most;
      const double length = from.Distance(to);
      if (length < kTolerance) continue;
      const Handle(Geom_Line) line = new Geom_Line(from, gp_Vec(from, to));
      IntCurveSurface_HInter meets;
      intersect(new GeomAdaptor_Curve(line, 0, length), meets);
      for (int i = 1; meets.IsDone() && i <= meets.NbPoints(); ++i)
        count += isInside(meets.Point(i)) ? 1 : 0;
    }
    return std::min(count, most);
  }

 private:
  static constexpr double kMargin = 0.02;  // of the extent of the face

  void intersect(const Handle(GeomAdaptor_Curve) & curve, IntCurveSurface_HInter& meets) {
    if (surface_->GetType() < GeomAbs_BezierSurface) return meets.Perform(curve, surface_);
    if (!drawn_) drawn_.emplace(surface_);
    drawn_->intersect(curve, meets);
  }

  bool isInside(const IntCurveSurface_IntersectionPoint& point) const {
    if (within_.Perform({point.U(), point.V()}) != TopAbs_IN) return false;
    const TopoDS_Shape vertex = BRepBuilderAPI_MakeVertex(point.Pnt()).Shape();
    const BRepExtrema_DistShapeShape distance(vertex, BRepTools::OuterWire(face_));
    return distance.IsDone() && distance.Value() > margin_;
  }

  TopoDS_Face face_;
  Handle(BRepAdaptor_Surface) surface_;
  BRepTopAdaptor_FClass2d within_;
  double margin_;
  std::optional<Drawn> drawn_;  ///< of a surface that is not elementary
};

/// The faces of a shell, with what is asked of them again and again.
class ShellFaces {
 public:
  explicit ShellFaces(const std::vector<TopoDS_Face>& faces)
      : faces_(faces), boxes_(faces.size()), chords_(faces.size()) {}

  std::size_t size() const { return faces_.size(); }
  const TopoDS_Face& face(std::size_t i) const { return faces_[i]; }
  const Bnd_Box& box(std::size_t i) {
    if (!boxes_[i]) boxes_[i] = boxOf(faces_[i]);
    return *boxes_[i];
  }
  const std::vector<Chord>& chords(std::size_t i) {
    if (!chords_[i]) chords_[i] = chordsOf(faces_[i]);
    return *chords_[i];
  }

 private:
  const std::vector<TopoDS_Face>& faces_;
  std::vector<std::optional<Bnd_Box>> boxes_;
  std::vector<std::optional<std::vector<Chord>>> chords_;
};

/// Whether several chords of other faces pass through a face and none through its rest.
bool isRestMeant(ShellFaces& faces, std::size_t index, const TopoDS_Face& rest) {
  constexpr int kSeveral = 3;
  Bnd_Box box = faces.box(index);
  box.Add(boxOf(rest));
  Crossed given(faces.face(index)), other(rest);
  int throughGiven = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (i == index || box.IsOut(faces.box(i))) continue;
    if (other.by(faces.chords(i), 1) > 0) return false;
    if (throughGiven < kSeveral) throughGiven += given.by(faces.chords(i), kSeveral - throughGiven);
  }
  return throughGiven >= kSeveral;
}

bool isClosed(const TopoDS_Shape& shell) {
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(shell, TopAbs_EDGE, TopAbs_FACE, faces);
  for (int i = 1; i <= faces.Extent(); ++i)
    if (faces(i).Extent() < 2 && !BRep_Tool::Degenerated(TopoDS::Edge(faces.FindKey(i))))
      return false;
  return true;
}

/// Whether a shell of these faces, with their present orientation, faces outwards.
bool looksOutwards(const std::vector<TopoDS_Face>& faces) {
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (const TopoDS_Face& face : faces) builder.Add(shell, face);
  GProp_GProps properties;  // each face by itself would be measured from a place of its own
  BRepGProp::VolumeProperties(shell, properties);
  return properties.Mass() > 0;
}

Rests crossedIn(const TopoDS_Shell& shell) {
  std::vector<TopoDS_Face> faces;
  for (TopoDS_Iterator it(shell.Oriented(TopAbs_FORWARD)); it.More(); it.Next())
    faces.push_back(TopoDS::Face(it.Value()));
  Rests rests;
  ShellFaces known(faces);
  std::vector<TopoDS_Face> meant = faces;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const TopoDS_Face rest = restOf(faces[i]);
    if (rest.IsNull()) continue;
    if (rests.faces.empty() && !isClosed(shell)) return {};
    if (!isRestMeant(known, i, rest)) continue;
    rests.faces.emplace(static_cast<int>(i), rest);
    meant[i] = rest;
  }
  if (!rests.faces.empty()) rests.isShellForward = looksOutwards(meant);
  return rests;
}

/// Nothing if OpenCASCADE cannot decide: the faces are then kept as read.
Rests restsIn(const TopoDS_Shell& shell) {
  try {
    return crossedIn(shell);
  } catch (const Standard_Failure&) {
    return {};
  }
}

}  // namespace

void turnBackCrossedFaces(ReadShape& read) {
  std::vector<TopoDS_Shell> shells;
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(read.shape, TopAbs_SHELL, found);
  for (int i = 1; i <= found.Extent(); ++i)
    shells.push_back(TopoDS::Shell(found(i).Located(TopLoc_Location())));
  const int count = replaceByRests(read, shells, restsIn);
  if (count == 0) return;
  read.notes.push_back(std::to_string(count) +
                       " faces between two poles were crossed by others; replaced by the rest of "
                       "their surface, which nothing crosses");
}

}  // namespace af2::geometry
