// Sizes that faces want inside, spread through space so that what is near knows of them.
#include <Standard_Failure.hxx>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <utility>

#include "engine/base/constants.h"
#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "geometry/occ/sizes/face_sampler.h"
#include "geometry/occ/sizes/face_size.h"
#include "geometry/occ/sizes/sizing.h"

namespace af2::geometry {
namespace {

/// The options for gentle curvature, set so that a turn gets as many elements as asked for.
void setTurns(CadSizes& sizes) {
  constexpr double kCurvedShare = 0.9;
  if (sizes.elementsPerTurn == 0) return;
  sizes.curvedShare = kCurvedShare;
  sizes.edgeTurn = sizes.faceTurn = 2 * std::numbers::pi / sizes.elementsPerTurn;
  const double least = sizes.minSize > 0 ? 0 : leastForLimits(1, 0);
  sizes.edgeLeast = sizes.faceLeast = sizes.bentFaceLeast = least;
}

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

std::vector<SampledFace> sampleFaces(const ModelShape& model, const std::vector<int>& faces,
                                     const CadSizes& sizes, int threads,
                                     const std::stop_token& stop) {
  std::vector<SampledFace> byFace(faces.size());
  forEachInParallel(byFace.size(), threads, [&](std::size_t i) {
    if (!stop.stop_requested()) byFace[i] = sampledFace(model, faces[i], sizes, false);
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
  return sampledFace(model, face, sizes, true).sources;
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
