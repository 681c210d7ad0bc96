#include "geometry/occ/base/outward_shell.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IntCurvesFace_Intersector.hxx>
#include <NCollection_DataMap.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <gp_Dir.hxx>
#include <gp_Lin.hxx>
#include <optional>
#include <vector>

#include "geometry/base/disjoint_sets.h"

namespace af2::geometry {
namespace {

constexpr std::size_t kFacesPerAxis = 3;  // through whose middles lines are drawn
constexpr std::size_t kMostLines = 3;
constexpr double kLeastCosine = 0.1;  // of the angle between a line and the normal of a face
constexpr double kLeastStep = 1e-4;   // between places along a line, of the size of the shell

using Numbers = std::array<double, 3>;

struct BoxedFace {
  TopoDS_Face face;
  Numbers min, max;
  int work = 1;  ///< of an intersection with a line, that with a plane being 1

  double extent(std::size_t axis) const { return max[axis] - min[axis]; }
};

/// How a face uses an edge for the first time.
struct Use {
  std::uint32_t face;
  TopAbs_Orientation orientation;
  bool isUsedTwice = false;
};

bool isClosedPiece(const std::vector<TopoDS_Face>& faces) {
  NCollection_DataMap<TopoDS_Shape, Use, TopTools_ShapeMapHasher> uses;
  DisjointSets pieces(faces.size());
  std::size_t open = 0;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    for (TopExp_Explorer it(faces[f], TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      const TopAbs_Orientation orientation = edge.Orientation();
      if (orientation != TopAbs_FORWARD && orientation != TopAbs_REVERSED) return false;
      if (BRep_Tool::Degenerated(edge)) continue;
      Use* const first = uses.ChangeSeek(edge);
      if (!first) {
        uses.Bind(edge, {f, orientation});
        ++open;
        continue;
      }
      if (first->isUsedTwice || first->orientation == orientation) return false;
      first->isUsedTwice = true;
      pieces.join(first->face, f);
      --open;
    }
  }
  for (std::uint32_t f = 1; f < faces.size(); ++f)
    if (pieces.of(f) != 0) return false;
  return open == 0;
}

std::optional<BoxedFace> boxed(const TopoDS_Face& face) {
  constexpr int kQuadric = 2, kOther = 20;
  Bnd_Box box;
  BRepBndLib::Add(face, box, false);
  if (box.IsVoid() || box.IsOpen()) return std::nullopt;
  BoxedFace boxed{face, {}, {}};
  box.Get(boxed.min[0], boxed.min[1], boxed.min[2], boxed.max[0], boxed.max[1], boxed.max[2]);
  const GeomAbs_SurfaceType type = BRepAdaptor_Surface(face, false).GetType();
  if (type != GeomAbs_Plane) boxed.work = type <= GeomAbs_Sphere ? kQuadric : kOther;
  return boxed;
}

/// A line along an axis or against it.
struct Line {
  std::size_t axis;
  bool isAlong;
  Numbers through;
  int work = 0;

  bool mayMeet(const BoxedFace& face) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (k != axis && (through[k] < face.min[k] || through[k] > face.max[k])) return false;
    return true;
  }
  /// Where the box of a face begins and ends along the line.
  double beginOf(const BoxedFace& face) const { return isAlong ? face.min[axis] : -face.max[axis]; }
  double endOf(const BoxedFace& face) const { return isAlong ? face.max[axis] : -face.min[axis]; }
  gp_Lin ray() const {
    Numbers direction{};
    direction[axis] = isAlong ? 1 : -1;
    return {{through[0], through[1], through[2]}, {direction[0], direction[1], direction[2]}};
  }
  double placeOf(double parameter) const {
    return (isAlong ? through[axis] : -through[axis]) + parameter;
  }
};

/// Those that a line may meet, in the order in which their boxes begin.
std::vector<const BoxedFace*> facesAlong(const Line& line, const std::vector<BoxedFace>& faces) {
  std::vector<const BoxedFace*> along;
  for (const BoxedFace& face : faces)
    if (line.mayMeet(face)) along.push_back(&face);
  std::ranges::stable_sort(along, {}, [&](const BoxedFace* face) { return line.beginOf(*face); });
  return along;
}

/// What it takes to find the first passage, if the first face has it.
int workOf(const Line& line, const std::vector<BoxedFace>& faces) {
  const auto along = facesAlong(line, faces);
  int work = 0;
  for (const BoxedFace* face : along)
    if (line.beginOf(*face) <= line.endOf(*along.front())) work += face->work;
  return work;
}

/// Lines through the faces that look largest, those first that take the least work. They are a
/// little beside the middle, where many a face has a vertex, an edge or a pole.
std::vector<Line> linesThrough(const std::vector<BoxedFace>& faces) {
  constexpr Numbers kBeside{0.5137, 0.4821, 0.5291};
  std::vector<Line> lines;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::vector<const BoxedFace*> largest;
    for (const BoxedFace& face : faces) largest.push_back(&face);
    const auto areaOf = [&](const BoxedFace* face) { return face->extent(u) * face->extent(v); };
    const std::size_t count = std::min(kFacesPerAxis, largest.size());
    std::ranges::partial_sort(largest, largest.begin() + static_cast<std::ptrdiff_t>(count),
                              std::greater(), areaOf);
    for (std::size_t i = 0; i < count; ++i) {
      Line line{axis, true, {}};
      for (std::size_t k = 0; k < 3; ++k)
        line.through[k] = largest[i]->min[k] + kBeside[k] * largest[i]->extent(k);
      for (const bool isAlong : {true, false}) {
        line.isAlong = isAlong;
        line.work = workOf(line, faces);
        lines.push_back(line);
      }
    }
  }
  std::ranges::stable_sort(lines, {}, &Line::work);
  lines.resize(std::min(lines.size(), kMostLines));
  return lines;
}

/// Where a line goes through a face.
struct Passage {
  double at;
  bool isClear;  ///< inside the face, and not at a small angle
  bool isIntoShell;
};

void addPassages(const Line& line, const TopoDS_Face& face, double size,
                 std::vector<Passage>& passages) {
  const gp_Lin ray = line.ray();
  IntCurvesFace_Intersector hits(face, Precision::Confusion());
  hits.Perform(ray, -4 * size, 4 * size);
  if (!hits.IsDone()) throw Standard_Failure("line not intersected with face");
  const BRepAdaptor_Surface surface(face, false);
  for (int i = 1; i <= hits.NbPnt(); ++i) {
    gp_Pnt place;
    gp_Vec du, dv;
    surface.D1(hits.UParameter(i), hits.VParameter(i), place, du, dv);
    const gp_Vec normal = du.Crossed(dv);
    const double cosine = normal.Dot(gp_Vec(ray.Direction())) / normal.Magnitude();
    const bool isClear = hits.State(i) == TopAbs_IN && std::abs(cosine) > kLeastCosine;
    const bool looksAlong = (cosine > 0) == (face.Orientation() == TopAbs_FORWARD);
    passages.push_back({line.placeOf(hits.WParameter(i)), isClear, !looksAlong});
  }
}

/// Whether the line enters the shell where it first meets it; nothing if that is not clear.
std::optional<bool> isEntered(const Line& line, const std::vector<BoxedFace>& faces, double size) {
  const double step = kLeastStep * size;
  std::vector<Passage> passages;
  for (const BoxedFace* face : facesAlong(line, faces)) {
    if (!passages.empty() && line.beginOf(*face) > passages.front().at + step) break;
    addPassages(line, face->face, size, passages);
    std::ranges::sort(passages, {}, &Passage::at);
  }
  if (passages.empty() || !passages[0].isClear) return std::nullopt;
  if (passages.size() > 1 && passages[1].at < passages[0].at + step) return std::nullopt;
  return passages[0].isIntoShell;
}

double sizeOf(const std::vector<BoxedFace>& faces) {
  Bnd_Box whole;
  for (const auto& [face, min, max, work] : faces)
    whole.Update(min[0], min[1], min[2], max[0], max[1], max[2]);
  return std::sqrt(whole.SquareExtent());
}

}  // namespace

bool isOutwardShell(const TopoDS_Shell& shell) {
  try {
    std::vector<TopoDS_Face> faces;
    for (TopoDS_Iterator it(shell); it.More(); it.Next()) {
      const TopAbs_Orientation orientation = it.Value().Orientation();
      if (it.Value().ShapeType() != TopAbs_FACE) return false;
      if (orientation != TopAbs_FORWARD && orientation != TopAbs_REVERSED) return false;
      faces.push_back(TopoDS::Face(it.Value()));
    }
    if (faces.empty() || !isClosedPiece(faces)) return false;
    std::vector<BoxedFace> boxes;
    for (const TopoDS_Face& face : faces) {
      const auto box = boxed(face);
      if (!box) return false;
      boxes.push_back(*box);
    }
    const double size = sizeOf(boxes);
    for (const Line& line : linesThrough(boxes))
      if (const auto isOutward = isEntered(line, boxes, size)) return *isOutward;
  } catch (const Standard_Failure&) {  // left to OpenCASCADE, which has an answer to it
  }
  return false;
}

}  // namespace af2::geometry
