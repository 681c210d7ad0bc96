#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/error.h"
#include "geometry/occ/base/quick_repairs.h"
#include "geometry/occ/iges/closed_runs.h"
#include "geometry/occ/iges/lost_iges_faces.h"
#include "geometry/occ/iges/shifted_curves.h"
#include "geometry/occ/model/whole_surfaces.h"
#include "geometry/occ/read/reader_setting.h"
#include "geometry/occ/read/readers.h"

namespace af2::geometry {

namespace {

/// Edges that only one face has. Seams count as shared, and poles are none.
int freeEdges(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
  int count = 0;
  for (int i = 1; i <= faces.Extent(); ++i)
    if (faces(i).Extent() == 1 && !BRep_Tool::Degenerated(TopoDS::Edge(faces.FindKey(i)))) ++count;
  return count;
}

int countFaces(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  return faces.Extent();
}

/// Whether a face is no wider than the tolerance.
bool isNothing(const TopoDS_Shape& face, double tolerance) {
  if (!TopExp_Explorer(face, TopAbs_EDGE).More()) return false;  // its boundary is lost
  GProp_GProps area, boundary;
  BRepGProp::SurfaceProperties(face, area);
  BRepGProp::LinearProperties(face, boundary);
  return std::abs(area.Mass()) <= tolerance * boundary.Mass();
}

/// Adds the faces that sewing dropped because it could not use their boundary. Faces without width
/// may be dropped.
TopoDS_Shape withDropped(const BRepBuilderAPI_Sewing& sewing, double tolerance) {
  BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  builder.Add(all, sewing.SewedShape());
  bool hasDropped = false;
  for (int i = 1; i <= sewing.NbDeletedFaces(); ++i) {
    if (isNothing(sewing.DeletedFace(i), tolerance)) continue;
    builder.Add(all, sewing.DeletedFace(i));
    hasDropped = true;
  }
  return hasDropped ? TopoDS_Shape(all) : sewing.SewedShape();
}

/// Edges may be cut where another one ends next to them.
enum class Edges { Whole, Cut };

TopoDS_Shape sewnAt(const TopoDS_Shape& shape, double tolerance, Edges edges) {
  const bool all = true;
  BRepBuilderAPI_Sewing sewing(tolerance, all, all, edges == Edges::Cut);
  sewing.SetNonManifoldMode(false);
  sewing.Add(shape);
  sewing.Perform();
  return sewing.SewedShape().IsNull() ? TopoDS_Shape() : withDropped(sewing, tolerance);
}

/// Two sheets that were sewn to each other all around, because their distance is within the gap,
/// enclose nothing.
bool isThickerThan(double gap, const TopoDS_Shape& shape) {
  GProp_GProps volume, area;
  BRepGProp::VolumeProperties(shape, volume);
  BRepGProp::SurfaceProperties(shape, area);
  return std::abs(volume.Mass()) > 2 * gap * area.Mass();
}

/// The shape with neighbours sewn where that leaves fewer free edges. Nobody knows how exact the
/// file is: wider gaps are closed, too, if all edges find a neighbour then.
TopoDS_Shape sewn(const TopoDS_Shape& shape, double diagonal) {
  const int before = freeEdges(shape);
  if (before == 0) return shape;
  constexpr double kGap = 1e-4;  // mm
  const double gap = std::clamp(kGap, 1e-6 * diagonal, 1e-4 * diagonal);
  const TopoDS_Shape whole = sewnAt(shape, gap, Edges::Whole);
  if (!whole.IsNull() && freeEdges(whole) == 0) return whole;
  const TopoDS_Shape narrowly = sewnAt(shape, gap, Edges::Cut);
  const int left = narrowly.IsNull() ? before : freeEdges(narrowly);
  if (left == 0) return narrowly;
  for (const double wider : {1e-5, 1e-4, 1e-3}) {
    if (wider * diagonal <= gap) continue;
    const TopoDS_Shape closed = sewnAt(shape, wider * diagonal, Edges::Cut);
    const bool isClosed = !closed.IsNull() && freeEdges(closed) == 0;
    if (isClosed && countFaces(closed) == countFaces(shape) &&
        isThickerThan(wider * diagonal, closed))
      return closed;
  }
  return left < before ? narrowly : shape;
}

/// Everything directly in a group of the file, and in each group inside it.
void collectGroups(const TopoDS_Shape& shape, std::vector<TopoDS_Shape>& groups) {
  if (shape.ShapeType() != TopAbs_COMPOUND) return groups.push_back(shape);
  BRep_Builder builder;
  TopoDS_Compound direct;
  builder.MakeCompound(direct);
  for (TopoDS_Iterator it(shape); it.More(); it.Next()) {
    if (it.Value().ShapeType() == TopAbs_COMPOUND)
      collectGroups(it.Value(), groups);
    else
      builder.Add(direct, it.Value());
  }
  if (TopExp_Explorer(direct, TopAbs_FACE).More()) groups.push_back(direct);
}

/// Of the box around all edges: a face that has lost its own has no end. Without a box, that of a
/// model as large as a millimetre.
double diagonalOf(const TopoDS_Shape& shape) {
  Bnd_Box box;
  for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next())
    BRepBndLib::Add(it.Current(), box);
  return box.IsVoid() || box.IsOpen() ? 1 : std::sqrt(box.SquareExtent());
}

/// IGES gives each trimmed surface edges of its own; only sewn do neighbours share them. A group,
/// or a run of faces in one, that closes by itself is a part: sewn along with others, it would grow
/// together with those that it touches.
void sew(ReadShape& read) {
  const int before = freeEdges(read.shape);
  if (before == 0) return;
  const double diagonal = diagonalOf(read.shape);
  std::vector<TopoDS_Shape> groups;
  collectGroups(read.shape, groups);
  BRep_Builder builder;
  TopoDS_Compound all, open;
  builder.MakeCompound(all);
  builder.MakeCompound(open);
  constexpr double kSameEdge = 1e-5;  // of the diagonal
  for (const TopoDS_Shape& group : groups)
    for (const TopoDS_Shape& run : closedRuns(group, kSameEdge * diagonal)) {
      const TopoDS_Shape part = sewn(run, diagonal);
      freeEdges(part) == 0 ? builder.Add(all, part) : builder.Add(open, run);
    }
  if (TopExp_Explorer(open, TopAbs_FACE).More()) builder.Add(all, sewn(open, diagonal));
  const int after = freeEdges(all);
  if (after >= before) return;
  read.shape = all;
  read.notes.push_back("sewed neighbouring faces: " + std::to_string(before) +
                       " edges had only one face, now " + std::to_string(after));
}

/// Which curve of an edge the reader builds on: that in space, or that in the parameters.
constexpr const char *kAsFileSays = "Default", *kInParameters = "2DUse_Forced";

TopoDS_Shape transferred(IGESControl_Reader& reader, const std::filesystem::path& path,
                         const char* curves) {
  const ReaderSetting unit("xstep.cascade.unit", "MM");
  const WithoutSmoothEdges smooth;
  const ReaderSetting mode("read.surfacecurve.mode", curves);
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
    throw InputError(path.string() +
                     ": this IGES file is damaged or truncated; export the model again");
  reader.SetReadVisible(false);
  repairShapesQuickly();
  reader.TransferRoots();
  return reader.OneShape();
}

void replaceShiftedFaces(ReadShape& read, const std::filesystem::path& path) {
  const int count = replaceShifted(read.shape, [&] {
    IGESControl_Reader reader;
    return transferred(reader, path, kInParameters);
  });
  if (count > 0)
    read.notes.push_back(std::to_string(count) +
                         " faces had curves shifted by a period; read again from the curves in "
                         "their parameters");
}

}  // namespace

ReadShape readIges(const std::filesystem::path& path) {
  IGESControl_Reader reader;
  ReadShape result;
  result.shape = transferred(reader, path, kAsFileSays);
  result.unit = "mm";
  const IGESData_GlobalSection& global = reader.IGESModel()->GlobalSection();
  if (!global.UnitName().IsNull()) result.fileUnit = global.UnitName()->ToCString();
  result.lostFaces = lostIgesFaces(reader.WS());
  if (result.shape.IsNull()) return result;
  replaceShiftedFaces(result, path);
  giveWholeBoundaries(result);  // sewing drops what encloses nothing
  sew(result);
  return result;
}

}  // namespace af2::geometry
