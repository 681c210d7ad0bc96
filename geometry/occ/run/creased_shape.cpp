#include "geometry/occ/run/creased_shape.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Curve.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <optional>

#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/model/face_surfaces.h"
#include "geometry/occ/sizes/sizing.h"
#include "geometry/occ/surfaces/face_surface.h"
#include "geometry/occ/surfaces/pinches.h"

namespace af2::geometry {

namespace {

/// Nearer to a vertex than this share of the wanted size, an edge crosses a crease there.
constexpr double kAtVertex = 0.01;
/// A share of the parameter range that a face occupies.
constexpr double kExact = 1e-6;

/// Where a crease meets an edge of its face: how far along the crease, and at which vertex.
struct CreaseCrossing {
  double along;
  TopoDS_Vertex vertex;
};

/// Gives the model its new edges.
class Creasing {
 public:
  explicit Creasing(const ModelShape& model) : shape_(std::make_shared<ModelShape>(model)) {}

  void add(int face, FaceCells cells, double size) {
    face_ = face;
    size_ = size;
    forward_ = TopoDS::Face(shape_->face(face).Oriented(TopAbs_FORWARD));
    definition_ = BRep_Tool::Surface(forward_);
    cells_ = std::move(cells);
    corners_.clear();
    std::vector<CreaseEdge> edges;
    const BRepTopAdaptor_FClass2d inside(forward_, Precision::PConfusion());
    addAll(true, inside, edges);
    addAll(false, inside, edges);
    if (edges.empty() && !cells_.isOne()) return;
    reachFromEnds();
    shape_->cells[face] = cells_;
    if (!edges.empty()) shape_->creaseEdges[face] = std::move(edges);
  }

  std::shared_ptr<const ModelShape> result() {
    shape_->surfaces = std::make_shared<const FaceSurfaces>(shape_->surfaces,
                                                            shape_->faces.Extent(), shape_->cells);
    return shape_;
  }

 private:
  const std::vector<Stretch>& across(bool isAtU) const { return isAtU ? cells_.u : cells_.v; }

  void addAll(bool isAtU, const BRepTopAdaptor_FClass2d& inside, std::vector<CreaseEdge>& edges) {
    for (std::size_t k = 0; k + 1 < across(isAtU).size(); ++k) {
      const double at = across(isAtU)[k + 1].low;
      const std::vector<CreaseCrossing> crossings = crossingsWith(isAtU, k, at);
      for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        if (isSamePlace(isAtU, crossings[i], crossings[i + 1])) continue;
        const double middle = (crossings[i].along + crossings[i + 1].along) / 2;
        const gp_Pnt2d place = isAtU ? gp_Pnt2d(at, middle) : gp_Pnt2d(middle, at);
        if (inside.Perform(place) != TopAbs_IN) continue;
        edges.push_back({makeEdge(isAtU, at, crossings[i], crossings[i + 1]), isAtU, k});
        for (const CreaseCrossing& end : {crossings[i], crossings[i + 1]}) {
          reach(end.vertex, isAtU, end.along, at, across(isAtU)[k].calmHigh);
          reach(end.vertex, isAtU, end.along, at, across(isAtU)[k + 1].calmLow);
        }
      }
    }
  }

  /// Notes how far the turn at a vertex reaches from one parameter to another one.
  void reach(const TopoDS_Vertex& vertex, bool isAtU, double along, double from, double to) {
    const auto at = [&](double across) {
      return isAtU ? definition_->Value(across, along) : definition_->Value(along, across);
    };
    double& farthest = shape_->creaseReach[shape_->vertices.FindIndex(vertex)];
    farthest = std::max(farthest, at(from).Distance(at(to)));
  }

  /// A face may end in the middle of a turn.
  void reachFromEnds() {
    for (const EdgeUse& use : shape_->edgesOfFaces[static_cast<std::size_t>(face_) - 1]) {
      if (use.id > shape_->edgesOfFile) continue;
      double first, last;
      const TopoDS_Edge edge = TopoDS::Edge(use.edge.Oriented(TopAbs_FORWARD));
      const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(use.edge, forward_, first, last);
      if (curve.IsNull()) continue;
      reachFromEnd(TopExp::FirstVertex(edge), curve->Value(first));
      reachFromEnd(TopExp::LastVertex(edge), curve->Value(last));
    }
  }

  void reachFromEnd(const TopoDS_Vertex& vertex, const gp_Pnt2d& place) {
    if (vertex.IsNull()) return;
    const auto look = [&](bool isAtU, double at, double along) {
      const Stretch &first = across(isAtU).front(), &last = across(isAtU).back();
      if (at < first.calmLow) reach(vertex, isAtU, along, at, first.calmLow);
      if (at > last.calmHigh) reach(vertex, isAtU, along, at, last.calmHigh);
    };
    look(true, place.X(), place.Y());
    look(false, place.Y(), place.X());
  }

  /// In order along the crease: with the edges of the face, and with creases in the other
  /// direction.
  std::vector<CreaseCrossing> crossingsWith(bool isAtU, std::size_t k, double at) {
    std::vector<CreaseCrossing> crossings;
    for (const EdgeUse& use : shape_->edgesOfFaces[static_cast<std::size_t>(face_) - 1])
      if (use.id <= shape_->edgesOfFile) addCrossings(use, isAtU, at, crossings);
    const std::vector<Stretch>& others = across(!isAtU);
    for (std::size_t other = 0; other + 1 < others.size(); ++other)
      crossings.push_back({others[other + 1].low, cornerOf(isAtU ? k : other, isAtU ? other : k)});
    std::ranges::stable_sort(crossings, {}, &CreaseCrossing::along);
    return crossings;
  }

  /// Where a crease at constant u crosses one at constant v.
  TopoDS_Vertex cornerOf(std::size_t inU, std::size_t inV) {
    TopoDS_Vertex& corner = corners_[{inU, inV}];
    if (corner.IsNull())
      corner = newVertex(definition_->Value(cells_.u[inU + 1].low, cells_.v[inV + 1].low),
                         Precision::Confusion());
    return corner;
  }

  TopoDS_Vertex newVertex(const gp_Pnt& place, double tolerance) {
    TopoDS_Vertex vertex;
    BRep_Builder().MakeVertex(vertex, place, tolerance);
    shape_->vertices.Add(vertex);
    return vertex;
  }

  void addCrossings(const EdgeUse& use, bool isAtU, double at,
                    std::vector<CreaseCrossing>& crossings) {
    double first, last;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(use.edge, forward_, first, last);
    if (curve.IsNull()) return;
    const Geom2dAdaptor_Curve adaptor(curve, first, last);
    const auto beside = [&](double t) {
      const gp_Pnt2d p = adaptor.Value(t);
      return (isAtU ? p.X() : p.Y()) - at;
    };
    const auto add = [&](double t) {
      const gp_Pnt2d p = adaptor.Value(t);
      crossings.push_back({isAtU ? p.Y() : p.X(), vertexAt(use, t, first, last)});
    };
    const std::vector<double> samples = samplesOf(adaptor);
    for (std::size_t i = 1; i < samples.size(); ++i) {
      const double a = i == 1 ? nearZero(beside(samples[0]), isAtU) : beside(samples[i - 1]);
      const bool isLast = i + 1 == samples.size();
      const double b = isLast ? nearZero(beside(samples[i]), isAtU) : beside(samples[i]);
      if (a == 0 && i == 1) add(samples[0]);
      if (b == 0)
        add(samples[i]);
      else if ((a < 0) != (b < 0) && a != 0)
        add(zeroBetween(beside, samples[i - 1], samples[i]));
    }
  }

  double rangeAcross(bool isAtU) const {
    return across(isAtU).back().high - across(isAtU).front().low;
  }

  /// The ends of edges at a crease may be off the crease by the precision of files.
  double nearZero(double beside, bool isAtU) const {
    return std::abs(beside) <= kExact * rangeAcross(isAtU) ? 0 : beside;
  }

  /// Edges that end at a crease both cross it there.
  bool isSamePlace(bool isAtU, const CreaseCrossing& one, const CreaseCrossing& other) const {
    return one.vertex.IsSame(other.vertex) &&
           std::abs(one.along - other.along) <= 10 * kExact * rangeAcross(!isAtU);
  }

  static std::vector<double> samplesOf(const Geom2dAdaptor_Curve& curve) {
    constexpr int kSteps = 24;
    const int count = curve.NbIntervals(GeomAbs_C1);
    TColStd_Array1OfReal bounds(1, count + 1);
    curve.Intervals(bounds, GeomAbs_C1);
    std::vector<double> samples{bounds(1)};
    for (int i = 1; i <= count; ++i)
      for (int k = 1; k <= kSteps; ++k)
        samples.push_back(k == kSteps ? bounds(i + 1)
                                      : bounds(i) + (bounds(i + 1) - bounds(i)) * k / kSteps);
    return samples;
  }

  template <class Function>
  static double zeroBetween(const Function& function, double low, double high) {
    constexpr int kHalvings = 60;
    const bool isNegative = function(low) < 0;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (low + high) / 2;
      ((function(middle) < 0) == isNegative ? low : high) = middle;
    }
    return (low + high) / 2;
  }

  /// The vertex at a place of an edge: one of its ends, one that another crease has there, or a new
  /// one.
  TopoDS_Vertex vertexAt(const EdgeUse& use, double t, double first, double last) {
    const TopoDS_Edge edge = TopoDS::Edge(use.edge.Oriented(TopAbs_FORWARD));
    const TopoDS_Vertex start = TopExp::FirstVertex(edge), end = TopExp::LastVertex(edge);
    if (BRep_Tool::Degenerated(edge)) return start;
    const BRepAdaptor_Curve curve(edge);
    const double from = curve.FirstParameter(), to = curve.LastParameter();
    const gp_Pnt place = curve.Value(from + (t - first) / (last - first) * (to - from));
    const double near = kAtVertex * size_;
    const auto isAt = [&](const TopoDS_Vertex& vertex) {
      return !vertex.IsNull() && BRep_Tool::Pnt(vertex).Distance(place) <=
                                     std::max(near, 2 * BRep_Tool::Tolerance(vertex));
    };
    const bool isNearStart = t - first < last - t;
    const TopoDS_Vertex& nearer = isNearStart ? start : end;
    const TopoDS_Vertex& farther = isNearStart ? end : start;
    if (isAt(nearer)) return nearer;
    if (isAt(farther)) return farther;
    std::vector<TopoDS_Vertex>& known = onEdges_[use.id];
    for (const TopoDS_Vertex& vertex : known)
      if (isAt(vertex)) return vertex;
    known.push_back(newVertex(place, BRep_Tool::Tolerance(edge)));
    return known.back();
  }

  bool isPinch(const Handle(Geom_Curve) & line, double from, double to) const {
    constexpr int kSamples = 16;
    const gp_Pnt start = line->Value(from);
    for (int i = 1; i <= kSamples; ++i)
      if (line->Value(from + (to - from) * i / kSamples).Distance(start) > kPinched * size_)
        return false;
    return true;
  }

  int makeEdge(bool isAtU, double at, const CreaseCrossing& from, const CreaseCrossing& to) {
    const BRep_Builder builder;
    const Handle(Geom_Curve) curve = isAtU ? definition_->UIso(at) : definition_->VIso(at);
    const Handle(Geom2d_Line) line = isAtU ? new Geom2d_Line(gp_Pnt2d(at, 0), gp_Dir2d(0, 1))
                                           : new Geom2d_Line(gp_Pnt2d(0, at), gp_Dir2d(1, 0));
    TopoDS_Edge edge;
    builder.MakeEdge(edge, curve, Precision::Confusion());
    builder.UpdateEdge(edge, line, forward_, Precision::Confusion());
    builder.Add(edge, from.vertex.Oriented(TopAbs_FORWARD));
    builder.Add(edge, to.vertex.Oriented(TopAbs_REVERSED));
    builder.Range(edge, from.along, to.along);
    builder.Degenerated(edge, isPinch(curve, from.along, to.along));
    const int id = shape_->edges.Add(edge);
    auto& uses = shape_->edgesOfFaces[static_cast<std::size_t>(face_) - 1];
    uses.push_back({id, edge});
    uses.push_back({id, TopoDS::Edge(edge.Reversed())});
    shape_->facesOfEdges.push_back({face_});
    return id;
  }

  std::shared_ptr<ModelShape> shape_;
  std::map<int, std::vector<TopoDS_Vertex>> onEdges_;  // new ones, by edge
  // What follows is of the face that is being added.
  int face_ = 0;
  double size_ = 0;
  TopoDS_Face forward_;
  Handle(Geom_Surface) definition_;
  FaceCells cells_;
  std::map<std::pair<std::size_t, std::size_t>, TopoDS_Vertex> corners_;
};

/// Where turns are asked for, elements are smaller than that only if the least size says so.
double sizeForCreases(const CadSizes& sizes, int face) {
  constexpr double kShareOfLeast = 20;
  const double wanted = wantedOnFace(sizes, face);
  if (sizes.elementsPerTurn == 0 || !(sizes.minSize > 0)) return wanted;
  return std::min(wanted, kShareOfLeast * sizes.minSize);
}

/// Whether elements somewhere on the creases of a face are to be so small that they see a tight
/// turn as it is.
bool isFineAtCreases(const CadSizes& sizes, const FaceSurface& surface, const FaceCells& cells,
                     double size) {
  constexpr double kFine = 0.1;  // of the size
  constexpr int kSamples = 16;
  if (!sizes.function) return false;
  const SplineSurface::Box& box = surface.box();
  const auto isFineAt = [&](double u, double v) {
    const Point3 place = surface.inOccParameters().frameAt(u, v).position;
    return sizes.function.at(place) < kFine * size;
  };
  for (int i = 0; i < kSamples; ++i) {
    const double share = (i + 0.5) / kSamples;
    for (const Stretch& u : cells.u)
      if (isFineAt(u.low, box.v1 + share * (box.v2 - box.v1))) return true;
    for (const Stretch& v : cells.v)
      if (isFineAt(box.u1 + share * (box.u2 - box.u1), v.low)) return true;
  }
  return false;
}

FaceCells cellsOfFace(const ModelShape& model, int face, const CadSizes& sizes) {
  const FaceSurface surface = model.surface(face);
  if (!surface.isGeneral()) return {};
  const Handle(Geom_Surface) definition = BRep_Tool::Surface(model.face(face));
  const double size = sizeForCreases(sizes, face);
  FaceCells cells = cellsOf(surface.inOccParameters(), definition, surface.box(), size);
  if (cells.count() > 0 && isFineAtCreases(sizes, surface, cells, size))
    return cellsOf(surface.inOccParameters(), definition, surface.box(), 0);
  return cells;
}

}  // namespace

std::shared_ptr<const ModelShape> withCreases(std::shared_ptr<const ModelShape> model,
                                              const std::vector<int>& faces, const CadSizes& sizes,
                                              int threads, const std::stop_token& stop) {
  std::vector<FaceCells> cells(faces.size());
  forEachInParallel(faces.size(), threads, [&](std::size_t i) {
    if (stop.stop_requested()) return;
    try {
      cells[i] = cellsOfFace(*model, faces[i], sizes);
    } catch (const GeometryError&) {  // reported when the face is meshed
    } catch (const Standard_Failure&) {
    }
  });
  std::optional<Creasing> creasing;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (cells[i].count() == 0) continue;
    if (!creasing) creasing.emplace(*model);
    try {
      creasing->add(faces[i], std::move(cells[i]), wantedOnFace(sizes, faces[i]));
    } catch (const Standard_Failure&) {  // stays as it is
    }
  }
  return creasing ? creasing->result() : model;
}

}  // namespace af2::geometry
