#include "geometry/planar/mesh_planar.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "engine/error.h"
#include "engine/plane_chart.h"
#include "engine/stopwatch.h"
#include "geometry/curve_division.h"
#include "geometry/domain_mesh.h"
#include "geometry/domain_size.h"
#include "geometry/laid_out.h"
#include "geometry/planar/loops.h"

namespace af2::geometry {

namespace {

constexpr Point3 kUp{0, 0, 1};

Point3 inSpace(Point2 p) { return {p.x, p.y, 0}; }

/// The size of a region that may have one of its own.
class RegionSize final : public SizeField {
 public:
  RegionSize(const SizeField& size, double largest) : size_(size), largest_(largest) {}
  double sizeAt(const SurfacePoint& point) const override {
    return std::min(largest_, size_.sizeAt(point));
  }

 private:
  const SizeField& size_;
  double largest_;
};

class PlanarMesher {
 public:
  PlanarMesher(const PlanarDomain& domain, const AF2Algorithm& algorithm,
               const PlanarMeshingOptions& options)
      : options_(options),
        size_(options),
        domain_(domain),
        regions_(findRegions(domain)),
        mesh_(algorithm, options) {
    takeDomains();
  }

  ModelMesh mesh() {
    const Stopwatch watch;
    for (std::size_t i = 0; i < regions_.regions.size(); ++i) findUses(i);
    numberPoints();
    for (std::size_t i = 0; i < regions_.pieces.size(); ++i)
      mesh_.addCurve(uses_[i].count > 0 ? divided(i) : DividedCurve());
    const double edges = watch.seconds();
    for (std::size_t i = 0; i < regions_.regions.size(); ++i) meshRegion(i);
    ModelMesh mesh = mesh_.finish(true);
    mesh.seconds.edges = edges;
    return mesh;
  }

 private:
  /// Regions that the file puts outside are left out; those that it gives a name or a number are
  /// in a group, and several may be in the same.
  void takeDomains() {
    std::vector<PlanarRegion> kept;
    std::map<int, std::vector<int>> faces;  // by domain
    for (PlanarRegion& region : regions_.regions) {
      const int domain = domainOf(region);
      if (domain == 0) continue;
      kept.push_back(std::move(region));
      domains_.push_back(domain);
      if (domain != PlanarDomain::kAnyDomain)
        faces[domain].push_back(static_cast<int>(kept.size()));
    }
    regions_.regions = std::move(kept);
    if (regions_.regions.empty()) throw InputError(domain_.name + ": all regions lie outside");
    addGroups(faces);
  }

  void addGroups(const std::map<int, std::vector<int>>& facesByDomain) {
    std::vector<FaceGroup> groups;
    for (const auto& [domain, faces] : facesByDomain) {
      const auto found = domain_.domainNames.find(domain);
      const std::string name =
          found == domain_.domainNames.end() ? "domain " + std::to_string(domain) : found->second;
      const auto group = std::ranges::find(groups, name, &FaceGroup::name);
      std::vector<int>& all =
          (group == groups.end() ? groups.emplace_back(FaceGroup{name, GroupKind::Part, {}})
                                 : *group)
              .faces;
      all.insert(all.end(), faces.begin(), faces.end());
    }
    for (FaceGroup& group : groups) {
      std::ranges::sort(group.faces);
      mesh_.addGroup(std::move(group));
    }
  }

  int domainOf(const PlanarRegion& region) const {
    int domain = region.domain;
    for (const auto& loop : region.loops) {
      for (const DirectedPiece d : loop) {
        const auto& segment = domain_.segments[static_cast<std::size_t>(
            regions_.pieces[static_cast<std::size_t>(d.piece)].segment)];
        const int here = d.reversed ? segment.right : segment.left;
        if (here == PlanarDomain::kAnyDomain) continue;
        if (domain == PlanarDomain::kAnyDomain) domain = here;
        if (here != domain)
          throw InputError(domain_.name + ":" + std::to_string(segment.line) +
                           ": beside this segment lies domain " + std::to_string(here) +
                           ", but other segments of the same region say " + std::to_string(domain));
      }
    }
    return domain;
  }

  void findUses(std::size_t region) {
    uses_.resize(regions_.pieces.size(), {0, std::numeric_limits<double>::infinity()});
    for (const auto& loop : regions_.regions[region].loops)
      for (const DirectedPiece d : loop) {
        PieceUse& use = uses_[static_cast<std::size_t>(d.piece)];
        ++use.count;
        use.largest = std::min(use.largest, sizeOfDomain(region));
      }
  }

  /// Points that no region uses are left out.
  void numberPoints() {
    ids_.resize(regions_.points.size());
    for (std::size_t i = 0; i < regions_.pieces.size(); ++i)
      if (uses_[i].count > 0)
        for (const int end : {regions_.pieces[i].from, regions_.pieces[i].to})
          ids_[static_cast<std::size_t>(end)] = VertexId(std::size_t{0});
    for (std::size_t i = 0; i < ids_.size(); ++i)
      if (!ids_[i].isNone()) ids_[i] = mesh_.addVertex(inSpace(regions_.points[i]));
  }

  /// Equal shares of the wanted sizes along the piece, at least one segment.
  DividedCurve divided(std::size_t index) {
    const PlanarPiece& piece = regions_.pieces[index];
    const Point2 from = regions_.points[static_cast<std::size_t>(piece.from)];
    const Point2 to = regions_.points[static_cast<std::size_t>(piece.to)];
    std::vector<double> ends{0};
    if (!options_.keepBoundary) addShares(from, to, uses_[index].largest, ends);
    ends.push_back(1);
    DividedCurve curve;
    curve.edge = piece.segment + 1;
    curve.vertices.push_back(ids_[static_cast<std::size_t>(piece.from)]);
    const auto at = [&](double t) { return inSpace(from + t * (to - from)); };
    for (std::size_t i = 1; i < ends.size(); ++i) {
      curve.middles.push_back(at((ends[i - 1] + ends[i]) / 2));
      if (i + 1 < ends.size()) curve.vertices.push_back(mesh_.addVertex(at(ends[i])));
    }
    curve.vertices.push_back(ids_[static_cast<std::size_t>(piece.to)]);
    return curve;
  }

  /// Sizes at the ends of `cells` equal cells, none above `largest`.
  SampledCurve sampled(Point2 from, Point2 to, double largest, std::size_t cells) const {
    const double length = distance(from, to);
    SampledCurve curve;
    for (std::size_t i = 0; i <= cells; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(cells);
      curve.arcLength.push_back(t * length);
      curve.sizes.push_back(std::min(largest, size_.at(inSpace(from + t * (to - from)))));
    }
    return curve;
  }

  /// Whether no cell is long against the size at its end.
  static bool isFine(const SampledCurve& curve) {
    constexpr double kMostOfSize = 0.25;
    for (std::size_t i = 1; i < curve.sizes.size(); ++i)
      if (curve.arcLength[i] - curve.arcLength[i - 1] > kMostOfSize * curve.sizes[i]) return false;
    return true;
  }

  void addShares(Point2 from, Point2 to, double largest, std::vector<double>& ends) const {
    constexpr double kMostCells = 1e7, kSamplesPerSegment = 10, kDenser = 8;
    constexpr int kMostRounds = 4;
    const double samplesPerSize = size_.isVaried() ? kSamplesPerSegment : 1;
    double cells =
        std::ceil(samplesPerSize * distance(from, to) / std::min(largest, options_.size)) + 1;
    if (!(cells < kMostCells))
      throw InputError(
          "a segment of the domain would need more than 10 million pieces; ask for a "
          "larger size");
    SampledCurve curve = sampled(from, to, largest, static_cast<std::size_t>(cells));
    for (int round = 0; size_.isVaried() && !isFine(curve) && round < kMostRounds; ++round) {
      cells *= kDenser;
      if (cells > kMostCells) break;
      curve = sampled(from, to, largest, static_cast<std::size_t>(cells));
    }
    const std::vector<double> count = segmentsAlong(curve.arcLength, curve.sizes);
    for (const CurvePlace& place : equalShares(count, wholeSegments(count.back(), 1)))
      ends.push_back((static_cast<double>(place.cell) + place.within) /
                     static_cast<double>(count.size() - 1));
  }

  void meshRegion(std::size_t index) {
    const PlanarRegion& region = regions_.regions[index];
    DomainFace face;
    face.surfaceType = face.chart = "plane";
    face.area = region.area;
    for (const auto& loop : region.loops) {
      std::vector<CurveUse>& uses = face.loops.emplace_back();
      for (const DirectedPiece d : loop)
        uses.push_back({static_cast<std::size_t>(d.piece), d.reversed});
    }
    face.wanted = std::make_shared<const RegionSize>(size_, sizeOfDomain(index));
    face.nearest = [](const Point3& p) { return pointInPlane({p.x, p.y}); };
    face.makeCharts = [] { return std::make_unique<PlaneChartMaker>(kUp); };
    face.cuts = &plane_;
    mesh_.addFace(std::move(face));
  }

  double sizeOfDomain(std::size_t region) const {
    const auto own = domain_.domainSizes.find(domains_[region]);
    return own == domain_.domainSizes.end() ? std::numeric_limits<double>::infinity()
                                            : std::max(own->second, options_.minSize);
  }

  const PlanarMeshingOptions& options_;
  DomainSize size_;
  const PlanarDomain& domain_;
  std::vector<int> domains_;  // by region
  PlanarRegions regions_;
  /// How often regions run along a piece, and the largest size that these allow.
  struct PieceUse {
    int count = 0;
    double largest = 0;
  };
  std::vector<PieceUse> uses_;  // by piece
  std::vector<VertexId> ids_;   // by point
  PlanePoints plane_;
  DomainMesh mesh_;
};

}  // namespace

ModelMesh meshPlanar(const PlanarDomain& domain, const AF2Algorithm& algorithm,
                     const PlanarMeshingOptions& options) {
  checkSize(options);
  return meshOnceOrTwice(options, [&](const PlanarMeshingOptions& own) {
    return PlanarMesher(domain, algorithm, own).mesh();
  });
}

}  // namespace af2::geometry
