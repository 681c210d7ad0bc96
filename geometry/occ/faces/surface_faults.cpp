#include "geometry/occ/faces/surface_faults.h"

#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/base/elementary.h"
#include "engine/base/place_text.h"
#include "geometry/check/element_crossings.h"
#include "geometry/occ/surfaces/face_surface.h"
#include "geometry/occ/surfaces/general_surface.h"
#include "geometry/occ/surfaces/parameter_line.h"
#include "geometry/occ/surfaces/surface_breaks.h"

namespace af2::geometry {
namespace {

using Uv = std::array<double, 2>;

constexpr int kSteps = 64;  // along each parameter, beside the breaks

class FaultSearch {
 public:
  FaultSearch(const TopoDS_Face& face, double size)
      : face_(face), inside_(face, BRep_Tool::Tolerance(face)), size_(size) {
    BRepTools::UVBounds(face, box_.u1, box_.u2, box_.v1, box_.v2);
    const Handle(Geom_Surface) definition = BRep_Tool::Surface(face);
    surface_.emplace(definition, face.Orientation() == TopAbs_REVERSED, box_);
    const GeomAdaptor_Surface adaptor(definition);
    breaks_ = {breaksOf(adaptor, true, box_.u1, box_.u2),
               breaksOf(adaptor, false, box_.v1, box_.v2)};
  }

  std::optional<SurfaceFault> find() {
    if (!(box_.u1 < box_.u2 && box_.v1 < box_.v2)) return std::nullopt;
    if (const auto line = withoutArea()) return line;
    for (const bool isInU : {true, false})
      for (const double share : {0.5, 0.25, 0.75, 0.06, 0.94})
        if (const auto fold = foldOn(isInU, share)) return fold;
    for (const bool isInU : {true, false})
      if (const auto pinch = pinchAcross(isInU)) return pinch;
    return crossing();
  }

  /// Both parameters run along the same line everywhere.
  std::optional<SurfaceFault> withoutArea() const {
    constexpr int kPlaces = 5;
    constexpr double kSame = 1e-9;  // sine
    const auto at = [](double low, double high, int i) {
      return low + (high - low) * (i + 0.5) / kPlaces;
    };
    for (int i = 0; i < kPlaces; ++i)
      for (int k = 0; k < kPlaces; ++k) {
        const SurfaceFrame frame =
            surface_->frameAt(at(box_.u1, box_.u2, i), at(box_.v1, box_.v2, k));
        if (length(cross(frame.du, frame.dv)) > kSame * length(frame.du) * length(frame.dv))
          return std::nullopt;
      }
    const Point3 middle =
        surface_->frameAt((box_.u1 + box_.u2) / 2, (box_.v1 + box_.v2) / 2).position;
    return SurfaceFault{SurfaceFault::Kind::NoArea, middle, {}};
  }

 private:
  double low(bool isInU) const { return isInU ? box_.u1 : box_.v1; }
  double high(bool isInU) const { return isInU ? box_.u2 : box_.v2; }
  bool isInside(const Uv& at) { return inside_.Perform({at[0], at[1]}) != TopAbs_OUT; }

  /// Parameters at which to look, ascending: pieces between breaks may be tiny, and faults close to
  /// the ends.
  std::vector<double> samples(bool isInU) const {
    constexpr int kHalvings = 4;
    std::vector<double> at = breaks_[isInU ? 0 : 1];
    const double from = low(isInU), to = high(isInU);
    for (int i = 0; i <= kSteps; ++i) at.push_back(from + (to - from) * i / kSteps);
    for (int k = 1; k <= kHalvings; ++k) {
      const double beside = std::ldexp((to - from) / kSteps, -k);
      at.insert(at.end(), {from + beside, to - beside});
    }
    std::erase_if(at, [&](double p) { return p < from || p > to; });
    std::ranges::sort(at);
    const auto same = std::ranges::unique(at);
    at.erase(same.begin(), same.end());
    return at;
  }

  /// Places along a line, so dense that it is known where it turns.
  std::vector<ParameterLine::Place> followed(const ParameterLine& line, bool isInU) const {
    constexpr double kShortest = 2e-3;  // of the size
    std::vector<ParameterLine::Place> places;
    for (const double at : samples(isInU)) {
      if (places.empty())
        places.push_back(line.at(at));
      else
        follow(line, line.at(at), kShortest * size_, places);
    }
    return places;
  }

  struct Turn {
    Point3 place, axis;
    double along;  ///< its distance from the start of the line
  };

  /// The places at which a line turns back within a short distance.
  std::vector<Turn> turnsOn(const ParameterLine& line, bool isInU, double fixed) {
    constexpr double kShort = 0.1;  // of the size
    constexpr double kBack = -0.5;  // cosine
    const std::vector<ParameterLine::Place> places = followed(line, isInU);
    std::vector<Point3> ways;  // from each place to the next
    std::vector<double> along{0};
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      ways.push_back(places[i + 1].position - places[i].position);
      along.push_back(along.back() + length(ways.back()));
    }
    std::vector<Turn> turns;
    for (std::size_t i = 0; i + 1 < ways.size(); ++i) {
      Point3 axis{};
      for (std::size_t k = i; k + 1 < ways.size() && along[k + 1] - along[i + 1] <= kShort * size_;
           ++k) {
        if (!(length(ways[i]) > 0 && length(ways[k]) > 0 && length(ways[k + 1]) > 0)) break;
        axis = axis + cross(unit(ways[k]), unit(ways[k + 1]));
        if (dot(unit(ways[i]), unit(ways[k + 1])) > kBack || !(length(axis) > 0)) continue;
        const double at = places[k + 1].parameter;
        if (isInside(isInU ? Uv{at, fixed} : Uv{fixed, at}))
          turns.push_back({places[k + 1].position, unit(axis), along[k + 1]});
        i = k;
        break;
      }
    }
    return turns;
  }

  std::optional<SurfaceFault> foldOn(bool isInU, double share) {
    constexpr double kNear = 4;         // sizes
    constexpr double kOpposite = -0.5;  // cosine
    const double fixed = low(!isInU) + share * (high(!isInU) - low(!isInU));
    const ParameterLine line(*surface_, isInU, fixed);
    const std::vector<Turn> turns = turnsOn(line, isInU, fixed);
    for (std::size_t i = 0; i + 1 < turns.size(); ++i)
      if (turns[i + 1].along - turns[i].along <= kNear * size_ &&
          dot(turns[i].axis, turns[i + 1].axis) < kOpposite)
        return SurfaceFault{SurfaceFault::Kind::Fold, turns[i].place, turns[i + 1].place};
    return std::nullopt;
  }

  /// Along u at a fixed v, or the other way round, from side to side.
  double lengthAt(bool isInU, double fixed) const {
    return ParameterLine(*surface_, isInU, fixed).lengthBetween(low(isInU), high(isInU));
  }

  std::optional<SurfaceFault> pinchAcross(bool isInU) {
    constexpr int kNarrowings = 80;
    constexpr double kNone = 1e-4, kWide = 0.02;  // of the size
    const std::vector<double> at = samples(!isInU);
    std::vector<double> lengths;
    for (const double fixed : at) lengths.push_back(lengthAt(isInU, fixed));
    for (std::size_t i = 1; i + 1 < at.size(); ++i) {
      if (lengths[i] > lengths[i - 1] || lengths[i] > lengths[i + 1]) continue;
      if (std::min(lengths[i - 1], lengths[i + 1]) < kWide * size_) continue;
      double from = at[i - 1], to = at[i + 1];
      for (int k = 0; k < kNarrowings; ++k) {  // the least length is between them
        const double a = from + (to - from) / 3, b = to - (to - from) / 3;
        if (lengthAt(isInU, a) < lengthAt(isInU, b))
          to = b;
        else
          from = a;
      }
      const double fixed = (from + to) / 2, middle = (low(isInU) + high(isInU)) / 2;
      if (lengthAt(isInU, fixed) > kNone * size_) continue;
      if (!isInside(isInU ? Uv{middle, fixed} : Uv{fixed, middle})) continue;
      return SurfaceFault{SurfaceFault::Kind::Pinch,
                          ParameterLine(*surface_, isInU, fixed).at(middle).position,
                          {}};
    }
    return std::nullopt;
  }

  /// Not all breaks of a surface with very many.
  std::vector<double> coarse(bool isInU) const {
    constexpr std::size_t kMost = 400;
    const std::vector<double> all = samples(isInU);
    const std::size_t step = (all.size() + kMost - 1) / kMost;
    std::vector<double> some;
    for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
    if (some.back() < all.back()) some.push_back(all.back());
    return some;
  }

  /// A coarse mesh of the surface inside the face, and the parameters of its vertices.
  ModelMesh coarseMesh() {
    const std::vector<double> us = coarse(true), vs = coarse(false);
    ModelMesh mesh;
    for (const double u : us)
      for (const double v : vs) {
        mesh.vertices.push_back(surface_->frameAt(u, v).position);
        parameters_.push_back({u, v});
      }
    const auto id = [&](std::size_t i, std::size_t k) { return VertexId(i * vs.size() + k); };
    const auto add = [&](VertexId a, VertexId b, VertexId c) {
      const auto at = [&](VertexId v) { return mesh.vertices[v.value]; };
      if (!(length(cross(at(b) - at(a), at(c) - at(a))) > 0)) return;
      Element element;
      element.corners = {a, b, c, VertexId()};
      mesh.elements.push_back(element);
      mesh.face.push_back(1);
    };
    for (std::size_t i = 0; i + 1 < us.size(); ++i)
      for (std::size_t k = 0; k + 1 < vs.size(); ++k) {
        if (!isInside({(us[i] + us[i + 1]) / 2, (vs[k] + vs[k + 1]) / 2})) continue;
        add(id(i, k), id(i + 1, k), id(i + 1, k + 1));
        add(id(i, k), id(i + 1, k + 1), id(i, k + 1));
      }
    return mesh;
  }

  Uv middleOf(const Element& element) const {
    Uv middle{};
    for (const VertexId v : element.vertices())
      for (std::size_t i = 0; i < 2; ++i) middle[i] += parameters_[v.value][i] / element.size();
    return middle;
  }

  std::optional<SurfaceFault> crossing() {
    constexpr std::size_t kTried = 40;
    const ModelMesh mesh = coarseMesh();
    const auto found = elementCrossings(mesh, kOneByOne);
    const std::size_t step = std::max<std::size_t>(found.size() / kTried, 1);
    for (std::size_t i = 0; i < found.size(); i += step) {
      if (found[i].isFold) continue;
      const auto middle = [&](int k) {
        return middleOf(mesh.elements[found[i].elements[static_cast<std::size_t>(k)].value]);
      };
      if (const auto place = commonPoint(middle(0), middle(1)))
        return SurfaceFault{SurfaceFault::Kind::Crossing, *place, {}};
    }
    return std::nullopt;
  }

  /// The point at which two sheets of the surface meet: Newton's method, each step as short as
  /// possible, from two places that are not to come together.
  std::optional<Point3> commonPoint(Uv a, Uv b) {
    constexpr int kMostSteps = 30;
    constexpr double kApart = 0.5;   // of the distance in parameters at the start
    constexpr double kExact = 1e-9;  // of the size
    const auto apart = [&] {
      return length(
          Point2{(a[0] - b[0]) / (box_.u2 - box_.u1), (a[1] - b[1]) / (box_.v2 - box_.v1)});
    };
    const double atStart = apart();
    for (int step = 0; step < kMostSteps; ++step) {
      if (apart() < kApart * atStart || !surface_->has(a[0], a[1]) || !surface_->has(b[0], b[1]))
        return std::nullopt;
      const SurfaceFrame one = surface_->frameAt(a[0], a[1]), other = surface_->frameAt(b[0], b[1]);
      const Point3 gap = other.position - one.position;
      if (length(gap) <= kExact * size_)
        return isInside(a) && isInside(b) && doCross(one, other) ? std::optional(one.position)
                                                                 : std::nullopt;
      // J J^T x = gap, where J has the columns du, dv of one and -du, -dv of the other.
      const std::array columns{one.du, one.dv, -1 * other.du, -1 * other.dv};
      const auto row = [&](auto member) {
        Point3 sum{};
        for (const Point3& c : columns) sum = sum + c.*member * c;
        return sum;
      };
      const Point3 x = row(&Point3::x), y = row(&Point3::y), z = row(&Point3::z);
      const double determinant = dot(x, cross(y, z));
      if (determinant == 0) return std::nullopt;
      const Point3 solved =
          (1 / determinant) * (gap.x * cross(y, z) + gap.y * cross(z, x) + gap.z * cross(x, y));
      a = {a[0] + dot(columns[0], solved), a[1] + dot(columns[1], solved)};
      b = {b[0] + dot(columns[2], solved), b[1] + dot(columns[3], solved)};
    }
    return std::nullopt;
  }

  static bool doCross(const SurfaceFrame& one, const SurfaceFrame& other) {
    constexpr double kLeastSine = 1e-3;
    const Point3 a = cross(one.du, one.dv), b = cross(other.du, other.dv);
    return length(cross(a, b)) > kLeastSine * length(a) * length(b);
  }

  TopoDS_Face face_;
  BRepTopAdaptor_FClass2d inside_;
  double size_;
  SplineSurface::Box box_;
  std::optional<GeneralSurface> surface_;
  std::array<std::vector<double>, 2> breaks_;  // of u and v
  std::vector<Uv> parameters_;                 // by vertex of the coarse mesh
};

}  // namespace

std::optional<SurfaceFault> surfaceFault(const TopoDS_Face& face, double size) {
  if (BRep_Tool::Surface(face).IsNull()) return std::nullopt;
  try {
    return FaultSearch(face, size).find();
  } catch (const Standard_Failure&) {
    return std::nullopt;
  }
}

bool isLine(const TopoDS_Face& face) {
  if (BRep_Tool::Surface(face).IsNull()) return false;
  try {
    return FaultSearch(face, 0).withoutArea().has_value();
  } catch (const Standard_Failure&) {
    return false;
  }
}

std::optional<SurfaceFault> surfaceFault(const ModelShape& model, int face, double size) {
  constexpr double kShareOfModel = 0.05;  // with larger sizes, bends that can be seen are no folds
  try {
    if (BRep_Tool::Surface(model.face(face)).IsNull() || model.surface(face).isPlane())
      return std::nullopt;
  } catch (const Standard_Failure&) {  // reported when the face is meshed
    return std::nullopt;
  }
  return surfaceFault(model.face(face), std::min(size, kShareOfModel * model.diagonal));
}

std::string textOf(const SurfaceFault& fault) {
  if (fault.kind == SurfaceFault::Kind::Crossing)
    return "in the model itself its surface crosses itself at " + textOf(fault.place) +
           ": make the face anew";
  if (fault.kind == SurfaceFault::Kind::Pinch)
    return "in the model itself its surface shrinks to a point at " + textOf(fault.place) +
           " and goes on beyond it, as where a profile that is turned crosses its axis: make the " +
           "face anew without the part beyond";
  if (fault.kind == SurfaceFault::Kind::NoArea)
    return "in the model itself its surface is a line, without area, through " +
           textOf(fault.place) + ": delete the face";
  return "in the model itself its surface turns back at " + textOf(fault.place) +
         ", and back again at " + textOf(fault.other) + ": make the face anew without this fold";
}

}  // namespace af2::geometry
