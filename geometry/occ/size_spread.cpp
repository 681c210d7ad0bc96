// Sizes that faces want inside, spread through space so that what is near knows of them.
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/error.h"
#include "geometry/occ/parallel.h"
#include "geometry/occ/points.h"
#include "geometry/occ/sizing.h"

namespace af2::geometry {
namespace {

/// Cells along each parameter of a face: about one for each wanted edge, within these bounds.
constexpr int kFewestCells = 4, kMostCells = 48;

/// What wants nearly the size of its face need not be spread.
constexpr double kSmall = 0.9;

/// The options for gentle curvature, set so that a turn gets as many elements as asked for.
void setTurns(ModelSizes& sizes) {
  constexpr double kCurvedShare = 0.95;
  if (sizes.elementsPerTurn == 0) return;
  sizes.curvedShare = kCurvedShare;
  sizes.edgeTurn = sizes.faceTurn = 2 * std::numbers::pi / sizes.elementsPerTurn;
  const double least = sizes.minSize > 0 ? 0 : leastForLimits(1, 0);
  sizes.edgeLeast = sizes.faceLeast = sizes.bentFaceLeast = least;
}

/// Samples one face on cells of its parameters, and more densely where sizes change too fast.
class FaceSampler {
 public:
  FaceSampler(const ModelShape& model, int face, const ModelSizes& sizes)
      : face_(TopoDS::Face(model.face(face).Oriented(TopAbs_FORWARD))),
        sizes_(sizes),
        wanted_(wantedOnFace(sizes, face)),
        surface_(model.surface(face)) {}

  std::vector<SizeSource> sources() {
    if (!sizes_.function && (sizes_.elementsPerTurn == 0 || surface_.isPlane())) return {};
    trimming_.emplace(face_, Precision::PConfusion());
    std::vector<Cell> cells = firstCells();
    for (std::size_t samples = 0; !cells.empty() && samples < kMostSamples;) {
      samples += cells.size();
      takePoints(cells);
      findSizes();
      addSources();
      cells = partsOfUneven(cells);
    }
    return std::move(sources_);
  }

 private:
  struct Cell {
    double u, v, du, dv;  // its middle, and half its width
  };
  static constexpr int kPointsPerCell = 5;
  static constexpr std::size_t kMostSamples = 20000;

  std::vector<Cell> firstCells() {
    double u1, u2, v1, v2;
    BRepTools::UVBounds(face_, u1, u2, v1, v2);
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

  int cellsFor(double length) const {
    return static_cast<int>(
        std::clamp(std::ceil(length / wanted_), double(kFewestCells), double(kMostCells)));
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
    for (std::size_t i = 0; i < points_.size(); ++i) {
      double size = std::min(wanted_, limits_[i]);
      if (!surface_.isPlane()) size = limitByCurvature(sizes_, size, surface_, points_[i]);
      limits_[i] = bounded(sizes_, size);
    }
  }

  /// Only what lies on the face counts.
  void addSources() {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (limits_[i] >= kSmall * wanted_) continue;
      if (trimming_->Perform({points_[i].u, points_[i].v}) == TopAbs_OUT) continue;
      sources_.push_back({points_[i].position, limits_[i]});
    }
  }

  /// Quarters of the cells in which sizes change faster than they may, until these are small
  /// against the sizes.
  std::vector<Cell> partsOfUneven(const std::vector<Cell>& cells) const {
    std::vector<Cell> parts;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::size_t first = i * kPointsPerCell;
      const auto [least, most] = std::minmax_element(
          limits_.begin() + static_cast<std::ptrdiff_t>(first),
          limits_.begin() + static_cast<std::ptrdiff_t>(first) + kPointsPerCell);
      const double across =
          std::max(distance(points_[first + 1].position, points_[first + 4].position),
                   distance(points_[first + 2].position, points_[first + 3].position));
      if (*most - *least <= sizes_.growth * across || across < *least) continue;
      const Cell& c = cells[i];
      for (const int s : {-1, 1})
        for (const int t : {-1, 1})
          parts.push_back({c.u + s * c.du / 2, c.v + t * c.dv / 2, c.du / 2, c.dv / 2});
    }
    return parts;
  }

  TopoDS_Face face_;
  const ModelSizes& sizes_;
  double wanted_;
  FaceSurface surface_;
  std::optional<BRepTopAdaptor_FClass2d> trimming_;
  std::vector<SurfacePoint> points_;
  std::vector<double> limits_;  // by point
  std::vector<SizeSource> sources_;
};

std::vector<SizeSource> sampleFaces(const ModelShape& model, const ModelSizes& sizes, int threads,
                                    const std::stop_token& stop) {
  std::vector<std::vector<SizeSource>> byFace(static_cast<std::size_t>(model.faces.Extent()));
  forEachInParallel(byFace.size(), threads, [&](std::size_t i) {
    if (stop.stop_requested()) return;
    try {
      byFace[i] = FaceSampler(model, static_cast<int>(i) + 1, sizes).sources();
    } catch (const GeometryError&) {  // reported when the face is meshed
    } catch (const Standard_Failure&) {
    }
  });
  std::vector<SizeSource> all;
  for (const auto& sources : byFace) all.insert(all.end(), sources.begin(), sources.end());
  return all;
}

}  // namespace

ModelSizes spreadSizes(const ModelShape& model, ModelSizes sizes, int threads,
                       const std::stop_token& stop) {
  setTurns(sizes);
  SizeSources sources = std::move(sizes.sources);
  sizes.sources = {};
  for (SizeSource& point : sources.points) point.size = bounded(sizes, point.size);
  if (sizes.function || sizes.elementsPerTurn > 0) {
    const std::vector<SizeSource> sampled = sampleFaces(model, sizes, threads, stop);
    sources.points.insert(sources.points.end(), sampled.begin(), sampled.end());
  }
  if (sources.isEmpty()) return sizes;
  const PositionSize spread = sizeFrom(std::move(sources), sizes.growth);
  if (!sizes.function) {
    sizes.function = spread;
    return sizes;
  }
  sizes.function = [spread, own = sizes.function](std::span<const Point3> at,
                                                  std::span<double> result) {
    own.at(at, result);
    for (std::size_t i = 0; i < at.size(); ++i) result[i] = std::min(result[i], spread.at(at[i]));
  };
  return sizes;
}

}  // namespace af2::geometry
