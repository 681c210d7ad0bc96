#include "geometry/faceted/mesh_faceted.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "engine/error.h"
#include "engine/mesh_region.h"
#include "engine/stopwatch.h"
#include "geometry/append_face.h"
#include "geometry/curve_division.h"
#include "geometry/faceted/facet_surface.h"
#include "geometry/graded_size.h"
#include "geometry/sound_faces.h"

namespace af2::geometry {
namespace {

/// What the options want by position, and by the curvature of a patch.
class FacetedSize {
 public:
  explicit FacetedSize(const FacetedMeshingOptions& options) : options_(options) {
    if (!options.sources.isEmpty()) sources_ = sizeFrom(options.sources, options.growth);
  }

  double at(const Point3& position) const {
    double size = options_.size;
    if (options_.function) size = std::min(size, options_.function.at(position));
    if (sources_) size = std::min(size, sources_.at(position));
    return size;
  }

  /// `size`, or less where the surface or a curve turns within `radius`.
  double limited(double size, double radius) const {
    constexpr double kGentleTurn = std::numbers::pi / 4, kGentleLeast = 0.35;
    const bool isAsked = options_.elementsPerTurn > 0;
    const double turn = isAsked ? 2 * std::numbers::pi / options_.elementsPerTurn : kGentleTurn;
    const double least =
        isAsked ? leastForLimits(options_.size, options_.minSize) : kGentleLeast * options_.size;
    return std::clamp(std::min(size, std::max(turn * radius, least)), options_.minSize,
                      options_.maxSize);
  }

 private:
  const FacetedMeshingOptions& options_;
  PositionSize sources_;
};

class PatchSize final : public SizeField {
 public:
  PatchSize(const FacetedSize& size, const FacetSurface& surface)
      : size_(size), surface_(surface) {}
  double sizeAt(const SurfacePoint& point) const override {
    return size_.limited(size_.at(point.position), surface_.radiusAt(point.position));
  }

 private:
  const FacetedSize& size_;
  const FacetSurface& surface_;
};

class FacetedMesher {
 public:
  FacetedMesher(const Facets& facets, const AF2Algorithm& algorithm,
                const FacetedMeshingOptions& options)
      : algorithm_(algorithm),
        options_(options),
        size_(options),
        model_(findPatches(facets, options.featureAngle * std::numbers::pi / 180)) {}

  ModelMesh mesh() {
    for (const AF2Rule& rule : algorithm_.rules().rules()) mesh_.ruleNames.push_back(rule.name());
    for (const Patch& patch : model_.patches) surfaces_.emplace_back(model_.facets, patch);
    const Stopwatch edges;
    divideCurves();
    mesh_.seconds.edges = edges.seconds();
    for (std::size_t i = 0; i < model_.patches.size(); ++i) meshPatch(i);
    addSegments();
    mesh_.wantedSizes.resize(mesh_.vertices.size(), kFar);
    const auto oneByOne = [](std::size_t count, const auto& work) {
      for (std::size_t i = 0; i < count; ++i) work(i);
    };
    mesh_.findings = keepSoundFaces(mesh_, elementCrossings(mesh_, oneByOne));
    return std::move(mesh_);
  }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();

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
      samples.curve.sizes.push_back(size_.limited(size_.at(p), radius));
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
      samples.curve.sizes[sample] = size_.limited(samples.curve.sizes[sample], radius);
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
    for (std::size_t c = 0; c < curves.size(); ++c) {
      const std::vector<double> count = segmentsAlong(curves[c].arcLength, curves[c].sizes);
      std::vector<VertexId> along{cornerAt(model_.curves[c].front())};
      for (const CurvePlace& place : equalShares(count, wholeSegments(count.back(), least[c])))
        along.push_back(addVertex(place.between(samples[c].points)));
      along.push_back(cornerAt(model_.curves[c].back()));
      divided_.push_back(std::move(along));
    }
  }

  VertexId addVertex(const Point3& position) {
    mesh_.vertices.push_back(position);
    return VertexId(mesh_.vertices.size() - 1);
  }
  VertexId cornerAt(std::uint32_t v) {
    if (corners_[v].isNone()) corners_[v] = addVertex(facetVertex(v));
    return corners_[v];
  }

  void meshPatch(std::size_t index) {
    const Stopwatch watch;
    FaceReport report;
    report.id = static_cast<int>(index) + 1;
    report.surfaceType = "facets";
    report.area = surfaces_[index].area();
    if (options_.stop.stop_requested())
      report.status = FaceStatus::Cancelled;
    else
      fillPatch(index, report);
    report.seconds = watch.seconds();
    mesh_.seconds.surface += report.seconds;
    mesh_.faces.push_back(std::move(report));
  }

  void fillPatch(std::size_t index, FaceReport& report) {
    const FacetSurface& surface = surfaces_[index];
    std::vector<VertexId> boundary;
    const FrontInput input = boundaryOf(index, boundary);
    const PatchSize wanted(size_, surface);
    const auto size = std::make_shared<const GradedSize>(wanted, input, options_.growth);
    const RegionTask task{
        input,
        [&] {
          return PieceTools{std::make_unique<MeanNormalChartMaker<FacetSurface>>(surface), size};
        },
        nullptr,
        {},
        options_.optimize};
    try {
      const RegionMesh meshed =
          meshRegion(algorithm_, task, {nullptr, options_.progress, options_.stop});
      judge(meshed, report);
      if (report.status == FaceStatus::Complete) add(meshed.result, boundary, wanted, report);
    } catch (const std::runtime_error& error) {  // of the surface or the boundary
      report.status = FaceStatus::Failed;
      report.reason = error.what();
    }
  }

  FrontInput boundaryOf(std::size_t index, std::vector<VertexId>& boundary) {
    localIds_.resize(mesh_.vertices.size());
    FrontInput input;
    for (const auto& loop : model_.patches[index].loops) {
      std::vector<BoundaryCorner> corners;
      for (const CurveUse& use : loop) {
        std::vector<VertexId> along = divided_[use.curve];
        if (use.reversed) std::reverse(along.begin(), along.end());
        along.pop_back();
        for (const VertexId id : along) corners.push_back(cornerOf(id, surfaces_[index], boundary));
      }
      input.loops.push_back(std::move(corners));
    }
    for (const VertexId id : boundary) localIds_[id.value] = VertexId();
    input.vertexCount = boundary.size();
    return input;
  }

  BoundaryCorner cornerOf(VertexId id, const FacetSurface& surface,
                          std::vector<VertexId>& boundary) {
    VertexId& local = localIds_[id.value];
    if (local.isNone()) {
      local = VertexId(boundary.size());
      boundary.push_back(id);
    }
    const Point3& position = mesh_.vertices[id.value];
    return {local, {position, surface.nearest(position).normal}};
  }

  static void judge(const RegionMesh& meshed, FaceReport& report) {
    const MeshingResult& result = meshed.result;
    if (result.outcome == Outcome::Complete && meshed.fault.empty()) return;
    report.status =
        result.outcome == Outcome::Cancelled ? FaceStatus::Cancelled : FaceStatus::Failed;
    report.reason = meshed.fault;
    if (result.outcome != Outcome::Stuck || result.stuck.empty()) return;
    const Point3& p = result.mesh.vertices[result.stuck.front().from.value].position;
    report.reason = "the front got stuck with " + std::to_string(result.stuck.size()) +
                    " edges left, the first at (" + std::to_string(p.x) + ", " +
                    std::to_string(p.y) + ", " + std::to_string(p.z) + ")";
  }

  void add(const MeshingResult& result, const std::vector<VertexId>& boundary,
           const SizeField& wanted, FaceReport& report) {
    mesh_.wantedSizes.resize(mesh_.vertices.size(), kFar);
    appendFace(mesh_, result, boundary, report);
    for (std::size_t i = 0; i < result.mesh.vertices.size(); ++i) {
      const double size = wanted.sizeAt(result.mesh.vertices[i]);
      if (i >= boundary.size()) {
        mesh_.wantedSizes.push_back(size);
        continue;
      }
      double& there = mesh_.wantedSizes[boundary[i].value];
      there = std::min(there, size);
    }
  }

  /// Counts only the patches that were meshed.
  void addSegments() {
    std::vector<int> uses(model_.curves.size(), 0);
    for (std::size_t i = 0; i < model_.patches.size(); ++i) {
      if (mesh_.faces[i].status != FaceStatus::Complete) continue;
      for (const auto& loop : model_.patches[i].loops)
        for (const CurveUse& use : loop) ++uses[use.curve];
    }
    for (std::size_t c = 0; c < divided_.size(); ++c)
      for (std::size_t i = 0; uses[c] > 0 && i + 1 < divided_[c].size(); ++i)
        mesh_.segments.push_back(
            {divided_[c][i], divided_[c][i + 1], static_cast<int>(c) + 1, uses[c]});
  }

  const AF2Algorithm& algorithm_;
  const FacetedMeshingOptions& options_;
  FacetedSize size_;
  PatchedFacets model_;
  std::vector<FacetSurface> surfaces_;          // by patch
  std::vector<VertexId> corners_;               // by vertex of the facets, if it ends a curve
  std::vector<std::vector<VertexId>> divided_;  // by curve, ends included
  std::vector<VertexId> localIds_;              // by vertex of the mesh, while a patch is read
  ModelMesh mesh_;
};

}  // namespace

ModelMesh meshFaceted(const Facets& facets, const AF2Algorithm& algorithm,
                      const FacetedMeshingOptions& options) {
  if (!(options.size > 0) || !std::isfinite(options.size))
    throw InputError("the size must be a positive number");
  if (!(options.featureAngle > 0 && options.featureAngle < 180))
    throw InputError("the feature angle must lie between 0 and 180 degrees");
  return FacetedMesher(facets, algorithm, options).mesh();
}

}  // namespace af2::geometry
