#include "geometry/occ/model/turned_faces.h"

#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace af2::geometry {

namespace {

/// An edge of a face in its parameters.
struct FaceSide {
  TopoDS_Edge edge;
  Handle(Geom2d_Curve) curve;
  double first = 0, last = 0;
  bool isPole = false;

  double u() const { return (curve->Value(first).X() + curve->Value(last).X()) / 2; }
};

/// The edges of the only wire of a face; empty if there are more, or one has no curve.
std::vector<FaceSide> sidesOf(const TopoDS_Face& face) {
  std::vector<FaceSide> sides;
  int wires = 0;
  for (TopoDS_Iterator wire(face); wire.More(); wire.Next()) {
    if (++wires > 1) return {};
    for (TopExp_Explorer it(wire.Value(), TopAbs_EDGE); it.More(); it.Next()) {
      FaceSide side{TopoDS::Edge(it.Current()), {}};
      side.curve = BRep_Tool::CurveOnSurface(side.edge, face, side.first, side.last);
      side.isPole = BRep_Tool::Degenerated(side.edge);
      if (side.curve.IsNull()) return {};
      sides.push_back(side);
    }
  }
  return sides;
}

/// The u at which the loop goes up or down between its poles. Two of them, or the loop is another.
std::vector<double> columnsOf(const std::vector<FaceSide>& sides, double period) {
  constexpr double kSame = 1e-3;  // of the period
  std::vector<double> columns;
  for (const FaceSide& side : sides) {
    if (!side.isPole) continue;
    for (const double parameter : {side.first, side.last}) {
      const double u = side.curve->Value(parameter).X();
      const auto isSame = [&](double other) { return std::abs(u - other) < kSame * period; };
      if (std::ranges::none_of(columns, isSame)) columns.push_back(u);
    }
  }
  std::ranges::sort(columns);
  return columns;
}

/// A loop that runs from pole to pole at one u, and back at another.
struct Lune {
  double low = 0, high = 0;
};

std::optional<Lune> luneOf(const std::vector<FaceSide>& sides, double period) {
  const auto isPole = [](const FaceSide& side) { return side.isPole; };
  if (std::ranges::count_if(sides, isPole) != 2) return std::nullopt;
  const std::vector<double> columns = columnsOf(sides, period);
  constexpr double kMax = 0.999;  // of the period: else the columns are the two sides of a seam
  if (columns.size() != 2 || columns[1] - columns[0] > kMax * period) return std::nullopt;
  return Lune{columns[0], columns[1]};
}

/// The column at the higher u moves by a period to the other side of the lower one.
void addSide(const FaceSide& side, const Lune& lune, double period, const TopoDS_Face& face,
             TopoDS_Wire& wire) {
  BRep_Builder builder;
  const double tolerance = BRep_Tool::Tolerance(side.edge);
  const TopAbs_Orientation turned = TopAbs::Reverse(side.edge.Orientation());
  TopoDS_Edge edge = side.edge;
  Handle(Geom2d_Curve) curve = Handle(Geom2d_Curve)::DownCast(side.curve->Copy());
  if (side.isPole) {
    // From the column where the loop comes to the pole to the other one, as the loop runs now.
    const gp_Pnt2d start = side.curve->Value(side.first), end = side.curve->Value(side.last);
    const auto moved = [&](double u) {
      return std::abs(u - lune.high) < std::abs(u - lune.low) ? u - period : u;
    };
    const double from = moved(start.X()), to = moved(end.X());
    edge = TopoDS::Edge(side.edge.EmptyCopied());
    for (TopoDS_Iterator vertex(side.edge.Oriented(TopAbs_FORWARD)); vertex.More(); vertex.Next())
      builder.Add(edge, vertex.Value());
    curve = new Geom2d_Line({from, start.Y()}, gp_Dir2d(to < from ? -1 : 1, 0));
    builder.UpdateEdge(edge, curve, face, tolerance);
    builder.Range(edge, face, 0, std::abs(to - from));
  } else {
    if (std::abs(side.u() - lune.high) < std::abs(side.u() - lune.low))
      curve->Translate(gp_Vec2d(-period, 0));
    builder.UpdateEdge(edge, curve, face, tolerance);
    builder.Range(edge, face, side.first, side.last);
  }
  builder.Add(wire, edge.Oriented(turned));
}

TopoDS_Shape withFaces(const TopoDS_Shell& shell, const Rests& rests) {
  BRep_Builder builder;
  TopoDS_Shell made;
  builder.MakeShell(made);
  int index = 0;
  for (TopoDS_Iterator it(shell.Oriented(TopAbs_FORWARD)); it.More(); it.Next(), ++index) {
    const auto found = rests.faces.find(index);
    builder.Add(made, found == rests.faces.end() ? it.Value() : found->second);
  }
  made.Closed(shell.Closed());
  return made.Oriented(rests.isShellForward ? TopAbs_FORWARD : TopAbs_REVERSED);
}

/// The rests for the faces whose orientation differs from that of most of the shell, whichever way
/// the shell as a whole is oriented.
Rests restsIn(const TopoDS_Shell& shell,
              const std::function<bool(const TopoDS_Face&)>& isAsInFile) {
  constexpr std::size_t kMany = 2;  // times as many as are turned
  std::vector<TopoDS_Face> faces;
  std::vector<int> as, turned;
  for (TopoDS_Iterator it(shell.Oriented(TopAbs_FORWARD)); it.More(); it.Next()) {
    faces.push_back(TopoDS::Face(it.Value()));
    (isAsInFile(faces.back()) ? as : turned).push_back(static_cast<int>(faces.size()) - 1);
  }
  Rests rests;
  rests.isShellForward = as.size() > turned.size();
  const std::vector<int>& odd = rests.isShellForward ? turned : as;
  if (odd.empty() || faces.size() < (kMany + 1) * odd.size()) return rests;
  for (const int index : odd)
    if (const TopoDS_Face rest = restOf(faces[static_cast<std::size_t>(index)]); !rest.IsNull())
      rests.faces.emplace(index, rest);
  return rests;
}

/// How many of the new faces are in a shape, wherever they are placed.
int replacedIn(const TopoDS_Shape& shape,
               const std::vector<std::pair<TopoDS_Face, TopoDS_Face>>& was) {
  TopTools_IndexedMapOfShape faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    faces.Add(it.Current().Located(TopLoc_Location()));
  return static_cast<int>(std::ranges::count_if(was, [&](const auto& pair) {
    return faces.Contains(pair.first.Located(TopLoc_Location()));
  }));
}

}  // namespace

TopoDS_Face restOf(const TopoDS_Face& given) {
  const TopoDS_Face face = TopoDS::Face(given.Oriented(TopAbs_FORWARD));
  TopLoc_Location place;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face, place);
  if (surface.IsNull() || !surface->IsUPeriodic()) return {};
  const double period = surface->UPeriod();
  const std::vector<FaceSide> sides = sidesOf(face);
  const std::optional<Lune> lune = luneOf(sides, period);
  if (!lune) return {};
  BRep_Builder builder;
  TopoDS_Face rest;
  // A copy: other faces of the same surface may have the edges, too, with curves of their own.
  builder.MakeFace(rest, Handle(Geom_Surface)::DownCast(surface->Copy()), place,
                   BRep_Tool::Tolerance(face));
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (const FaceSide& side : sides) addSide(side, *lune, period, rest, wire);
  wire.Closed(true);
  builder.Add(rest, wire);
  return TopoDS::Face(rest.Oriented(TopAbs::Reverse(given.Orientation())));
}

int replaceByRests(ReadShape& read, const std::vector<TopoDS_Shell>& shells,
                   const std::function<Rests(const TopoDS_Shell&)>& choose) {
  BRepTools_ReShape replacing;
  replacing.ModeConsiderLocation() = true;  // shells are found wherever their part is placed
  std::vector<std::pair<TopoDS_Face, TopoDS_Face>> was;  // by the new face: that of the reader
  for (const TopoDS_Shell& shell : shells) {
    if (replacing.IsRecorded(shell)) continue;
    const Rests rests = choose(shell);
    if (rests.faces.empty()) continue;
    int index = 0;
    for (TopoDS_Iterator it(shell.Oriented(TopAbs_FORWARD)); it.More(); it.Next(), ++index) {
      const auto found = rests.faces.find(index);
      if (found == rests.faces.end()) continue;
      replacing.Replace(it.Value(), found->second);
      was.emplace_back(found->second, TopoDS::Face(it.Value()));
    }
    replacing.Replace(shell, withFaces(shell, rests));
  }
  if (was.empty()) return 0;
  read.shape = replacing.Apply(read.shape);
  for (ShapeGroup& group : read.groups)
    for (TopoDS_Shape& shape : group.shapes) shape = replacing.Apply(shape);
  if (read.nameOf)
    read.nameOf = [was, nameOf = read.nameOf](const TopoDS_Face& face) {
      const auto found =
          std::ranges::find_if(was, [&](const auto& pair) { return pair.first.IsPartner(face); });
      return nameOf(found == was.end() ? face : found->second);
    };
  return replacedIn(read.shape, was);
}

void turnBackFaces(ReadShape& read, const std::function<bool(const TopoDS_Face&)>& isAsInFile) {
  std::vector<TopoDS_Shell> shells;
  TopTools_IndexedMapOfShape solids;
  TopExp::MapShapes(read.shape, TopAbs_SOLID, solids);
  for (int i = 1; i <= solids.Extent(); ++i) {
    const TopoDS_Shape solid = solids(i).Located(TopLoc_Location()).Oriented(TopAbs_FORWARD);
    TopExp_Explorer it(solid, TopAbs_SHELL);
    if (!it.More()) continue;
    const TopoDS_Shell shell = TopoDS::Shell(it.Current().Located(TopLoc_Location()));
    it.Next();
    if (!it.More()) shells.push_back(shell);  // of several, it is unknown which faces inwards
  }
  const int count = replaceByRests(
      read, shells, [&](const TopoDS_Shell& shell) { return restsIn(shell, isAsInFile); });
  if (count == 0) return;
  read.notes.push_back(std::to_string(count) +
                       " faces between two poles were read as the rest of their surface, oriented "
                       "opposite to the file; corrected");
}

}  // namespace af2::geometry
