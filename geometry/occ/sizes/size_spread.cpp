// Sizes that faces want inside, spread through space so that what is near knows of them.
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "engine/base/constants.h"
#include "engine/base/error.h"
#include "geometry/base/parallel.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/sizes/face_size.h"
#include "geometry/occ/sizes/sizing.h"
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

double growthInside(const CadSizes& sizes) { return kShareOfGrowth * sizes.growth; }

/// The options for gentle curvature, set so that a turn gets as many elements as asked for.
void setTurns(CadSizes& sizes) {
  constexpr double kCurvedShare = 0.9;
  if (sizes.elementsPerTurn == 0) return;
  sizes.curvedShare = kCurvedShare;
  sizes.edgeTurn = sizes.faceTurn = 2 * std::numbers::pi / sizes.elementsPerTurn;
  const double least = sizes.minSize > 0 ? 0 : leastForLimits(1, 0);
  sizes.edgeLeast = sizes.faceLeast = sizes.bentFaceLeast = least;
}

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
    return roughShare_ > kSpot && !isAsked();
  }

 private:
  struct Cell {
    double u, v, du, dv;  // its middle, and half its width
  };
  /// Whether sizes inside faces were asked for.
  bool isAsked() const { return sizes_.function || sizes_.elementsPerTurn > 0; }

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
      if (!trimming_) trimming_.emplace(face_, Precision::PConfusion());
      if (trimming_->Perform({points_[i].u, points_[i].v}) == TopAbs_OUT) continue;
      sources_.add(source);
    }
  }

  /// Quarters of the cells in which sizes change faster than they may, until these are small
  /// against the sizes.
  std::vector<Cell> partsOfUneven(const std::vector<Cell>& cells) const {
    const double smallest = isAsked() ? 1 : 2;  // cell, in sizes
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
  SplineSurface::Box box_;                           // of the parameters
  std::optional<BRepTopAdaptor_FClass2d> trimming_;  // most faces do not need it
  std::vector<SurfacePoint> points_;
  std::vector<double> limits_;  // by point
  UncoveredSources sources_;
  bool areAll_ = true;
  double roughShare_ = 0;
};

/// Compares sizes on a face one element apart.
class UnevennessProbe {
 public:
  UnevennessProbe(const FaceSurface& surface, const CadSizes& sizes, int face)
      : surface_(surface), size_(sizes, face, surface) {}

  bool isUneven() {
    if (surface_.isBentAlike()) return false;
    takeSamples();
    constexpr double kMany = 300;  // small faces follow their edges
    if (!(elements_ > kMany)) return false;
    for (const Sample& sample : samples_) {
      compare(sample.size, sample.u + sample.size / length(sample.frame.du), sample.v);
      compare(sample.size, sample.u, sample.v + sample.size / length(sample.frame.dv));
    }
    constexpr double kMaxUneven = 0.05;
    return uneven_ > kMaxUneven * compared_;
  }

 private:
  struct Sample {
    double u, v, size;
    SurfaceFrame frame;
  };

  void takeSamples() {
    constexpr int kSamples = 5;  // along each parameter
    const SplineSurface::Box& box = surface_.box();
    const double cell = (box.u2 - box.u1) * (box.v2 - box.v1) / (kSamples * kSamples);
    for (int i = 0; i < kSamples; ++i)
      for (int k = 0; k < kSamples; ++k) {
        const double u = box.u1 + (i + 0.5) / kSamples * (box.u2 - box.u1);
        const double v = box.v1 + (k + 0.5) / kSamples * (box.v2 - box.v1);
        const SurfaceFrame frame = surface_.inOccParameters().frameAt(u, v);
        const double size = sizeAt(u, v);
        samples_.push_back({u, v, size, frame});
        elements_ += cell * length(cross(frame.du, frame.dv)) / (kUnitTriangle * size * size);
      }
  }

  double sizeAt(double u, double v) const {
    return size_.sizeAt({surface_.inOccParameters().frameAt(u, v).position, {}, u, v});
  }

  void compare(double size, double u, double v) {
    constexpr double kSteep = 0.6;
    const SplineSurface::Box& box = surface_.box();
    if (!(u < box.u2 && v < box.v2)) return;
    const double next = sizeAt(u, v);
    ++compared_;
    if (next < kSteep * size || size < kSteep * next) ++uneven_;
  }

  const FaceSurface& surface_;
  FaceSize size_;
  std::vector<Sample> samples_;
  double elements_ = 0;
  int compared_ = 0, uneven_ = 0;
};

struct SampledFace {
  std::vector<SizeSource> sources;
  bool isTooRough = false;
};

SampledFace sampled(const ModelShape& model, int face, const CadSizes& sizes, bool areAll) {
  try {
    FaceSampler sampler(model, face, sizes);
    std::vector<SizeSource> sources = sampler.sources(areAll);
    return {std::move(sources), sampler.isTooRough()};
  } catch (const GeometryError&) {  // reported when the face is meshed
  } catch (const Standard_Failure&) {
  }
  return {};
}

std::vector<SampledFace> sampleFaces(const ModelShape& model, const std::vector<int>& faces,
                                     const CadSizes& sizes, int threads,
                                     const std::stop_token& stop) {
  std::vector<SampledFace> byFace(faces.size());
  forEachInParallel(byFace.size(), threads, [&](std::size_t i) {
    if (!stop.stop_requested()) byFace[i] = sampled(model, faces[i], sizes, false);
  });
  return byFace;
}

/// Takes note of the faces on which sizes change so fast that they cannot be sampled, and samples
/// these once more.
std::vector<SizeSource> sourcesInside(const ModelShape& model, const std::vector<int>& faces,
                                      CadSizes& sizes, int threads, const std::stop_token& stop) {
  std::vector<SampledFace> byFace = sampleFaces(model, faces, sizes, threads, stop);
  std::vector<std::size_t> rough;
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (byFace[i].isTooRough) rough.push_back(i);
  std::vector<int> again;
  for (const std::size_t i : rough) again.push_back(faces[i]);
  sizes.roughFaces.insert(again.begin(), again.end());
  std::vector<SampledFace> anew = sampleFaces(model, again, sizes, threads, stop);
  for (std::size_t k = 0; k < rough.size(); ++k) byFace[rough[k]] = std::move(anew[k]);
  std::vector<SizeSource> all;
  for (const SampledFace& face : byFace)
    all.insert(all.end(), face.sources.begin(), face.sources.end());
  return all;
}

/// Whether sizes inside all faces are to be known outside them.
bool spreadsAll(const CadSizes& sizes) { return sizes.function || sizes.elementsPerTurn > 0; }

struct SmallerOfBoth {
  PositionSize one, other;

  void operator()(std::span<const Point3> at, std::span<double> sizes) const {
    one.at(at, sizes);
    other.lower(at, sizes);
  }
  void lower(std::span<const Point3> at, std::span<double> sizes) const {
    one.lower(at, sizes);
    other.lower(at, sizes);
  }
};

/// The limits by position, in addition to all other limits.
void limitBySources(SizeSources sources, double growth, int threads, CadSizes& sizes) {
  if (sources.isEmpty()) return;
  const PositionSize grown = sizeFrom(std::move(sources), growth, threads);
  if (!sizes.function) {
    sizes.function = grown;
    return;
  }
  sizes.function = SmallerOfBoth{sizes.function, grown};
}

std::vector<int> allFaces(const ModelShape& model) {
  std::vector<int> faces(static_cast<std::size_t>(model.faces.Extent()));
  std::iota(faces.begin(), faces.end(), 1);
  return faces;
}

}  // namespace

std::vector<SizeSource> sizesInside(const ModelShape& model, int face, const CadSizes& sizes) {
  return sampled(model, face, sizes, true).sources;
}

std::vector<int> unevenFaces(const ModelShape& model, const CadSizes& sizes, int threads,
                             const std::stop_token& stop) {
  if (spreadsAll(sizes)) return {};
  std::vector<int> faces = allFaces(model);
  std::vector<std::uint8_t> isUneven(faces.size(), 0);
  forEachInParallel(faces.size(), threads, [&](std::size_t i) {
    if (stop.stop_requested()) return;
    try {
      isUneven[i] = UnevennessProbe(model.surface(faces[i]), sizes, faces[i]).isUneven();
    } catch (const GeometryError&) {  // reported when the face is meshed
    } catch (const Standard_Failure&) {
    }
  });
  std::erase_if(faces, [&](int face) { return !isUneven[static_cast<std::size_t>(face) - 1]; });
  return faces;
}

CadSizes spreadSizes(const ModelShape& model, CadSizes sizes, const std::vector<int>& uneven,
                     int threads, const std::stop_token& stop) {
  setTurns(sizes);
  SizeSources asked = std::exchange(sizes.sources, {}), inside;
  for (SizeSource& point : asked.points) point.size = bounded(sizes, point.size);
  inside.points =
      sourcesInside(model, spreadsAll(sizes) ? allFaces(model) : uneven, sizes, threads, stop);
  limitBySources(std::move(asked), sizes.growth, threads, sizes);
  limitBySources(std::move(inside), growthInside(sizes), threads, sizes);
  return sizes;
}

}  // namespace af2::geometry
