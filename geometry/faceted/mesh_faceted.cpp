#include "geometry/faceted/mesh_faceted.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/error.h"
#include "engine/stopwatch.h"
#include "geometry/curve_division.h"
#include "geometry/domain_mesh.h"
#include "geometry/domain_size.h"
#include "geometry/faceted/facet_surface.h"
#include "geometry/faceted/patches.h"

namespace af2::geometry {
namespace {

constexpr double kGentleLeast = 0.35;

class PatchSize final : public SizeField {
 public:
  PatchSize(const DomainSize& size, const FacetSurface& surface) : size_(size), surface_(surface) {}
  double sizeAt(const SurfacePoint& point) const override {
    return size_.limitedByTurn(size_.sizeAt(point), surface_.radiusAt(point.position),
                               kGentleLeast);
  }

 private:
  const DomainSize& size_;
  const FacetSurface& surface_;
};

class FacetedMesher {
 public:
  FacetedMesher(const Facets& facets, const AF2Algorithm& algorithm,
                const FacetedMeshingOptions& options)
      : options_(options),
        size_(options),
        model_(findPatches(facets, options.featureAngle * std::numbers::pi / 180)),
        mesh_(algorithm, options) {}

  ModelMesh mesh() {
    for (const Patch& patch : model_.patches) surfaces_.emplace_back(model_.facets, patch);
    const Stopwatch watch;
    divideCurves();
    const double edges = watch.seconds();
    for (std::size_t i = 0; i < model_.patches.size(); ++i) meshPatch(i);
    ModelMesh mesh = mesh_.finish(false);
    mesh.seconds.edges = edges;
    return mesh;
  }

 private:
  const Point3& facetVertex(std::uint32_t v) const { return model_.facets.vertices[v]; }

  /// By curve: the patches beside it.
  std::vector<std::vector<std::size_t>> patchesBeside() const {
    std::vector<std::vector<std::size_t>> beside(model_.curves.size());
    for (std::size_t p = 0; p < model_.patches.size(); ++p)
      for (const auto& loop : model_.patches[p].loops)
        for (const CurveUse& use : loop) beside[use.curve].push_back(p);
    return beside;
  }

  /// Samples at the vertices of the curve, and between them where these are far apart.
  struct Samples {
    std::vector<Point3> points;
    SampledCurve curve;
  };

  Samples sample(const FeatureCurve& curve, const std::vector<std::size_t>& patches) const {
    constexpr double kSamplesPerSize = 8, kMost = 1e6;
    Samples samples;
    samples.points.push_back(facetVertex(curve.front()));
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const Point3 &from = facetVertex(curve[i - 1]), &to = facetVertex(curve[i]);
      const double size = std::min(size_.at(from), size_.at(to));
      const double cells = std::max(1.0, std::ceil(kSamplesPerSize * distance(from, to) / size));
      if (cells > kMost)
        throw InputError(model_.facets.name +
                         ": a feature edge would need more than 100 thousand segments; ask for a "
                         "larger size");
      for (double k = 1; k <= cells; ++k)
        samples.points.push_back(k == cells ? to : from + (k / cells) * (to - from));
    }
    std::vector<double>& s = samples.curve.arcLength;
    for (const Point3& p : samples.points) {
      const Point3& before = samples.points[s.empty() ? 0 : s.size() - 1];
      s.push_back(s.empty() ? 0 : s.back() + distance(before, p));
      double radius = std::numeric_limits<double>::infinity();
      for (const std::size_t patch : patches)
        radius = std::min(radius, surfaces_[patch].radiusAt(p));
      samples.curve.sizes.push_back(size_.limitedByTurn(size_.at(p), radius, kGentleLeast));
    }
    limitByTurn(curve, samples);
    return samples;
  }

  /// Where the curve turns from one piece to the next.
  void limitByTurn(const FeatureCurve& curve, Samples& samples) const {
    std::size_t sample = 0;
    for (std::size_t i = 1; i + 1 < curve.size(); ++i) {
      const Point3 &p = facetVertex(curve[i - 1]), &q = facetVertex(curve[i]),
                   &r = facetVertex(curve[i + 1]);
      while (samples.points[sample] != q) ++sample;
      const double turn = distance(unit(q - p), unit(r - q));
      if (turn == 0) continue;
      const double radius = (distance(p, q) + distance(q, r)) / 2 / turn;
      double& size = samples.curve.sizes[sample];
      size = size_.limitedByTurn(size, radius, kGentleLeast);
    }
  }

  void divideCurves() {
    const auto beside = patchesBeside();
    std::vector<Samples> samples;
    std::vector<SampledCurve> curves;
    std::vector<CurveEnds> ends;
    for (std::size_t c = 0; c < model_.curves.size(); ++c) {
      const FeatureCurve& curve = model_.curves[c];
      samples.push_back(sample(curve, beside[c]));
      ends.push_back({curve.front(), curve.back()});
      samples.back().curve.ends = ends.back();
      curves.push_back(std::move(samples.back().curve));
    }
    gradeTogether(curves, model_.facets.vertices.size(), options_.growth);
    const std::vector<std::size_t> least = leastSegments(ends);
    corners_.resize(model_.facets.vertices.size());
    for (std::size_t c = 0; c < curves.size(); ++c)
      divide(c, curves[c], samples[c].points, least[c]);
  }

  /// Every other one of twice as many shares ends at the middle of a segment.
  void divide(std::size_t index, const SampledCurve& curve, const std::vector<Point3>& points,
              std::size_t least) {
    const FeatureCurve& vertices = model_.curves[index];
    const std::vector<double> count = segmentsAlong(curve.arcLength, curve.sizes);
    DividedCurve divided;
    divided.edge = static_cast<int>(index) + 1;
    divided.vertices.push_back(cornerAt(vertices.front()));
    bool isMiddle = true;
    for (const CurvePlace& place : equalShares(count, 2 * wholeSegments(count.back(), least))) {
      const Point3 p = place.between(points);
      isMiddle ? divided.middles.push_back(p) : divided.vertices.push_back(mesh_.addVertex(p));
      isMiddle = !isMiddle;
    }
    divided.vertices.push_back(cornerAt(vertices.back()));
    mesh_.addCurve(std::move(divided));
  }

  VertexId cornerAt(std::uint32_t v) {
    if (corners_[v].isNone()) corners_[v] = mesh_.addVertex(facetVertex(v));
    return corners_[v];
  }

  void meshPatch(std::size_t index) {
    const FacetSurface& surface = surfaces_[index];
    DomainFace face;
    face.surfaceType = "facets";
    face.chart = "mean-normal";
    face.area = surface.area();
    face.loops = model_.patches[index].loops;
    face.wanted = std::make_shared<const PatchSize>(size_, surface);
    face.nearest = [&surface](const Point3& p) { return surface.nearest(p); };
    face.makeCharts = [&surface] {
      return std::make_unique<MeanNormalChartMaker<FacetSurface>>(surface);
    };
    mesh_.addFace(std::move(face));
  }

  const FacetedMeshingOptions& options_;
  DomainSize size_;
  PatchedFacets model_;
  std::vector<FacetSurface> surfaces_;  // by patch
  std::vector<VertexId> corners_;       // by vertex of the facets, if it ends a curve
  DomainMesh mesh_;
};

}  // namespace

ModelMesh meshFaceted(const Facets& facets, const AF2Algorithm& algorithm,
                      const FacetedMeshingOptions& options) {
  checkSize(options);
  if (!(options.featureAngle > 0 && options.featureAngle < 180))
    throw InputError("the feature angle must lie between 0 and 180 degrees");
  return meshOnceOrTwice(options, [&](const FacetedMeshingOptions& own) {
    return FacetedMesher(facets, algorithm, own).mesh();
  });
}

}  // namespace af2::geometry
