// Models of surfaces that a Python class gives.
#include <af2/geometry/domain_defects.h>

#include <algorithm>

#include "python/bindings/called_surface.h"
#include "python/bindings/model.h"

namespace af2::python {
namespace {

using Loops = std::vector<std::vector<Point2>>;

/// The faces and curves of a run, from loops in the parameters.
class SurfaceDomain {
 public:
  SurfaceDomain(std::shared_ptr<const CalledSurface> surface, std::string name)
      : surface_(std::move(surface)) {
    model_.name = std::move(name);
  }

  std::shared_ptr<const geometry::DomainModel> make(const Loops& loops) {
    geometry::DomainFace face;
    face.surfaceType = "python";
    face.surface = surface_;
    face.nearest = [surface = surface_](const Point3& p) { return surface->nearest(p); };
    for (const std::vector<Point2>& loop : loops) addLoop(loop, face);
    face.area = areaOf(loops);
    measure();
    model_.faces.push_back(std::move(face));
    return std::make_shared<const geometry::DomainModel>(std::move(model_));
  }

 private:
  void addLoop(const std::vector<Point2>& loop, geometry::DomainFace& face) {
    const std::size_t first = model_.corners.size();
    for (const Point3& corner : surface_->positions(loop)) model_.corners.push_back(corner);
    std::vector<geometry::CurveUse>& uses = face.loops.emplace_back();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t next = (i + 1) % loop.size();
      uses.push_back({model_.curves.size(), false});
      addCurve(first + i, first + next, loop[i], loop[next]);
    }
  }

  /// Straight in the parameters.
  void addCurve(std::size_t first, std::size_t last, Point2 from, Point2 to) {
    constexpr int kKnots = 32;
    geometry::DomainCurve curve;
    curve.id = static_cast<int>(model_.curves.size()) + 1;
    curve.first = first;
    curve.last = last;
    for (int k = 0; k <= kKnots; ++k) curve.knots.push_back(k / double{kKnots});
    curve.pointAt = [surface = surface_, from, to](double t) {
      return surface->positions({from + t * (to - from)}).front();
    };
    model_.curves.push_back(std::move(curve));
  }

  /// By a grid over the loops, for the check of the mesh and the expected number of elements.
  double areaOf(const Loops& loops) const;

  void measure() {
    Point3 low = model_.corners.front(), high = low;
    for (const geometry::DomainCurve& curve : model_.curves)
      for (const double knot : curve.knots) {
        const Point3 p = curve.pointAt(knot);
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
    model_.diagonal = distance(low, high);
  }

  std::shared_ptr<const CalledSurface> surface_;
  geometry::DomainModel model_;
};

bool isInside(const Loops& loops, Point2 p) {
  bool isIn = false;
  for (const std::vector<Point2>& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point2 a = loop[i], b = loop[(i + 1) % loop.size()];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
        isIn = !isIn;
    }
  return isIn;
}

double SurfaceDomain::areaOf(const Loops& loops) const {
  constexpr int kCells = 200;  // each way; cells count if their middle is inside
  Point2 low = loops.front().front(), high = low;
  for (const auto& loop : loops)
    for (const Point2 p : loop) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  const Point2 cell = (1.0 / kCells) * (high - low);
  std::vector<Point2> nodes;
  for (int i = 0; i <= kCells; ++i)
    for (int j = 0; j <= kCells; ++j) nodes.push_back(low + Point2{i * cell.x, j * cell.y});
  const std::vector<Point3> at = surface_->positions(nodes);
  double area = 0;
  for (int i = 0; i < kCells; ++i)
    for (int j = 0; j < kCells; ++j) {
      if (!isInside(loops, low + Point2{(i + 0.5) * cell.x, (j + 0.5) * cell.y})) continue;
      const auto node = static_cast<std::size_t>(i * (kCells + 1) + j);
      area += 0.5 *
              length(cross(at[node + kCells + 2] - at[node], at[node + 1] - at[node + kCells + 1]));
    }
  return area;
}

class SurfaceModel final : public MeshableModel {
 public:
  SurfaceModel(GivenSurface given, Loops loops, std::string name)
      : given_(new GivenSurface(std::move(given)),
               [](GivenSurface* owned) {
                 const py::gil_scoped_acquire gil;
                 delete owned;
               }),
        loops_(std::move(loops)),
        name_(std::move(name)) {}

  const char* kind() const override { return "surface"; }

  Meshed mesh(const Request& request, const AF2Algorithm& algorithm) const override {
    return meshedDomain(domain(request.call), request, algorithm);
  }
  Parts parts(double, const std::shared_ptr<Call>& call) const override {
    return partsOf(*domain(call));
  }
  std::vector<geometry::Defect> defects(double size,
                                        const std::shared_ptr<Call>& call) const override {
    const auto model = domain(call);
    return geometry::findDefects(*model, size > 0 ? size : model->diagonal / 100);
  }

 private:
  std::shared_ptr<const geometry::DomainModel> domain(const std::shared_ptr<Call>& call) const {
    std::shared_ptr<const CalledSurface> surface;
    {
      const py::gil_scoped_acquire gil;
      surface = std::make_shared<const CalledSurface>(*given_, call);
    }
    return SurfaceDomain(std::move(surface), name_).make(loops_);
  }

  std::shared_ptr<const GivenSurface> given_;
  Loops loops_;
  std::string name_;
};

}  // namespace

ModelPointer surfaceFrom(const py::dict& from) {
  const auto range = [&](const char* key) {
    const auto [low, high] = from[key].cast<std::pair<double, double>>();
    return Range{low, high};
  };
  Loops loops;
  for (const auto& loop : from["loops"].cast<py::list>()) loops.push_back(points2(loop, "loops"));
  return std::make_shared<const SurfaceModel>(
      GivenSurface{from["evaluate"], from["normal"], from["chart"], range("u"), range("v")},
      std::move(loops), from["name"].cast<std::string>());
}

}  // namespace af2::python
