#include "geometry/occ/sizes/face_sampler.h"

#include <BRepTools.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/base/error.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/sizes/face_size.h"
#include "geometry/occ/sizes/sizing.h"
#include "geometry/occ/surfaces/parameter_outline.h"
#include "geometry/sizes/uncovered_sources.h"

namespace af2::geometry {
namespace {

/// Cells along each parameter of a face: about one for each wanted edge, within these bounds.
constexpr int kFewestCells = 4, kMaxCells = 48;

/// Sizes above this share of the size of the face need not be spread.
constexpr double kSmall = 0.9;

/// Away from what faces want inside, sizes grow by this share of what they may. In the open, where
/// elements follow nothing but their sizes, their shapes are the better the more gently these grow.
constexpr double kShareOfGrowth = 2.0 / 3;

/// Samples one face on cells of its parameters, and more densely where sizes change too fast.
class FaceSampler {
 public:
  FaceSampler(const ModelShape& model, int face, const CadSizes& sizes)
      : id_(face),
        face_(TopoDS::Face(model.face(face).Oriented(TopAbs_FORWARD))),
        sizes_(sizes),
        wanted_(wantedOnFace(sizes, face)),
        surface_(model.surface(face)),
        sources_(growthInside(sizes)) {}

  /// All sources, or those that matter to `uncovered`.
  std::vector<SizeSource> sources(bool areAll) {
    areAll_ = areAll;
    if (!sizes_.function && !mayBeSmall()) return {};
    BRepTools::UVBounds(face_, box_.u1, box_.u2, box_.v1, box_.v2);
    std::vector<Cell> cells = firstCells();
    for (std::size_t samples = 0; !cells.empty() && samples < kMaxSamples;) {
      samples += cells.size();
      takePoints(cells);
      findSizes();
      addSources();
      cells = partsOfUneven(cells);
    }
    roughShare_ = shareOf(cells);
    if (isTooRough()) return {};  // rougher than shorter edges could make good
    return sources_.take();
  }

  /// Whether sizes changed faster than could be sampled, and not at some spot alone, such as a
  /// corner where the surface turns over.
  bool isTooRough() const {
    constexpr double kSpot = 0.003;  // of the parameters
    return roughShare_ > kSpot && !spreadsAll(sizes_);
  }

 private:
  struct Cell {
    double u, v, du, dv;  // its middle, and half its width
  };

  /// Where a surface is bent alike everywhere, one place tells.
  bool mayBeSmall() const {
    if (surface_.isPlane()) return false;
    return !surface_.isBentAlike() || limitOn(wanted_, {}) < kSmall * wanted_;
  }

  static constexpr int kPointsPerCell = 5;
  static constexpr std::size_t kMaxSamples = 20000;

  std::vector<Cell> firstCells() {
    const double u1 = box_.u1, u2 = box_.u2, v1 = box_.v1, v2 = box_.v2;
    for (const double bound : {u1, u2, v1, v2})
      if (Precision::IsInfinite(bound)) return {};
    if (!(u2 > u1 && v2 > v1)) return {};
    const auto lengthAlong = [&](bool alongU) {
      constexpr int kChords = 8;
      const auto at = [&](double s, double t) {
        return positionAt(u1 + s * (u2 - u1), v1 + t * (v2 - v1));
      };
      double longest = 0;
      for (const double across : {0.0, 0.5, 1.0}) {
        double sum = 0;
        for (int i = 0; i < kChords; ++i) {
          const double s = double(i) / kChords, t = double(i + 1) / kChords;
          sum += alongU ? distance(at(s, across), at(t, across))
                        : distance(at(across, s), at(across, t));
        }
        longest = std::max(longest, sum);
      }
      return longest;
    };
    const int m = cellsFor(lengthAlong(true)), n = cellsFor(lengthAlong(false));
    const double du = (u2 - u1) / m / 2, dv = (v2 - v1) / n / 2;
    std::vector<Cell> cells;
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < n; ++j)
        cells.push_back({u1 + (2 * i + 1) * du, v1 + (2 * j + 1) * dv, du, dv});
    return cells;
  }

  /// How much of the parameters the cells take up.
  double shareOf(const std::vector<Cell>& cells) const {
    double sum = 0;
    for (const Cell& cell : cells) sum += 4 * cell.du * cell.dv;
    return cells.empty() ? 0 : sum / ((box_.u2 - box_.u1) * (box_.v2 - box_.v1));
  }

  int cellsFor(double length) const {
    return static_cast<int>(
        std::clamp(std::ceil(length / wanted_), double(kFewestCells), double(kMaxCells)));
  }
  Point3 positionAt(double u, double v) const {
    return surface_.inOccParameters().pointAt(u, v).position;
  }

  /// The middle and near the corners of each cell.
  void takePoints(const std::vector<Cell>& cells) {
    constexpr double kInside = 0.99;
    points_.clear();
    for (const Cell& c : cells) {
      for (const auto& [s, t] : {std::pair{0, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}) {
        const double u = c.u + kInside * s * c.du, v = c.v + kInside * t * c.dv;
        points_.push_back({positionAt(u, v), {}, u, v});
      }
    }
  }

  void findSizes() {
    limits_.assign(points_.size(), wanted_);
    if (sizes_.function) {
      std::vector<Point3> at;
      for (const SurfacePoint& p : points_) at.push_back(p.position);
      sizes_.function.at(at, limits_);
    }
    for (std::size_t i = 0; i < points_.size(); ++i)
      limits_[i] = limitOn(std::min(wanted_, limits_[i]), points_[i]);
  }

  double limitOn(double size, const SurfacePoint& point) const {
    double least = sizes_.minSize;
    if (!surface_.isPlane()) {
      const CurvedSize curved = curvedSizeAt(sizes_, id_, size, surface_, point);
      size = curved.limit;
      least = curved.least;
    }
    return std::clamp(size, least, sizes_.maxSize);
  }

  /// Only samples on the face count.
  void addSources() {
    sources_.sort();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (limits_[i] >= kSmall * wanted_) continue;
      const SizeSource source{points_[i].position, limits_[i]};
      if (!areAll_ && sources_.cover(source)) continue;
      if (!outline_) outline_.emplace(face_);
      if (!outline_->has(points_[i].u, points_[i].v)) continue;
      sources_.add(source);
    }
  }

  /// Quarters of the cells in which sizes change faster than they may, until these are small
  /// against the sizes.
  std::vector<Cell> partsOfUneven(const std::vector<Cell>& cells) const {
    const double smallest = spreadsAll(sizes_) ? 1 : 2;  // cell, in sizes
    std::vector<Cell> parts;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::size_t first = i * kPointsPerCell;
      const auto [least, most] = std::minmax_element(
          limits_.begin() + static_cast<std::ptrdiff_t>(first),
          limits_.begin() + static_cast<std::ptrdiff_t>(first) + kPointsPerCell);
      const double across =
          std::max(distance(points_[first + 1].position, points_[first + 4].position),
                   distance(points_[first + 2].position, points_[first + 3].position));
      if (*most - *least <= growthInside(sizes_) * across || across < smallest * *least) continue;
      const Cell& c = cells[i];
      for (const int s : {-1, 1})
        for (const int t : {-1, 1})
          parts.push_back({c.u + s * c.du / 2, c.v + t * c.dv / 2, c.du / 2, c.dv / 2});
    }
    return parts;
  }

  int id_;
  TopoDS_Face face_;
  const CadSizes& sizes_;
  double wanted_;
  FaceSurface surface_;
  SplineSurface::Box box_;                   // of the parameters
  std::optional<ParameterOutline> outline_;  // most faces do not need it
  std::vector<SurfacePoint> points_;
  std::vector<double> limits_;  // by point
  UncoveredSources sources_;
  bool areAll_ = true;
  double roughShare_ = 0;
};

}  // namespace

double growthInside(const CadSizes& sizes) { return kShareOfGrowth * sizes.growth; }

bool spreadsAll(const CadSizes& sizes) { return sizes.function || sizes.elementsPerTurn > 0; }

SampledFace sampledFace(const ModelShape& model, int face, const CadSizes& sizes, bool areAll) {
  try {
    FaceSampler sampler(model, face, sizes);
    std::vector<SizeSource> sources = sampler.sources(areAll);
    return {std::move(sources), sampler.isTooRough()};
  } catch (const GeometryError&) {  // reported when the face is meshed
  } catch (const Standard_Failure&) {
  }
  return {};
}

}  // namespace af2::geometry
