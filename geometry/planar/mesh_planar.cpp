#include "geometry/planar/mesh_planar.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>

#include "engine/error.h"
#include "engine/mesh_region.h"
#include "engine/plane_chart.h"
#include "geometry/append_face.h"
#include "geometry/graded_size.h"
#include "geometry/narrow_places.h"
#include "geometry/planar/loops.h"
#include "geometry/second_order.h"
#include "geometry/sound_faces.h"

namespace af2::geometry {

namespace {

constexpr Point3 kUp{0, 0, 1};

SurfacePoint inPlane(Point2 p) { return {{p.x, p.y, 0}, kUp, p.x, p.y}; }

class PlanePoints final : public SurfaceEvaluator {
 public:
  SurfacePoint at(double u, double v) const override { return inPlane({u, v}); }
};

class DomainSize final : public SizeField {
 public:
  explicit DomainSize(const PlanarMeshingOptions& options) : options_(options) {
    if (!options.sources.isEmpty()) sources_ = sizeFrom(options.sources, options.growth);
  }
  /// Whether sizes differ from place to place.
  bool isVaried() const { return options_.function || sources_; }
  double sizeAt(const SurfacePoint& point) const override {
    double size = options_.size;
    if (options_.function) size = std::min(size, options_.function.at(point.position));
    if (sources_) size = std::min(size, sources_.at(point.position));
    return std::clamp(size, options_.minSize, options_.maxSize);
  }

 private:
  const PlanarMeshingOptions& options_;
  PositionSize sources_;
};

/// The size of a domain that has one of its own.
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
      : algorithm_(algorithm),
        options_(options),
        size_(options),
        domain_(domain),
        regions_(findRegions(domain)) {
    takeDomains();
  }

  ModelMesh mesh() {
    for (const AF2Rule& rule : algorithm_.rules().rules()) mesh_.ruleNames.push_back(rule.name());
    for (std::size_t i = 0; i < regions_.regions.size(); ++i) findUses(regions_.regions[i]);
    numberPoints();
    for (const PlanarPiece& piece : regions_.pieces) divide(piece);
    for (std::size_t i = 0; i < regions_.regions.size(); ++i) meshRegion(i);
    addSegments();
    for (const Point3& p : mesh_.vertices)
      mesh_.wantedSizes.push_back(size_.sizeAt(inPlane({p.x, p.y})));
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
      const double largest = sizeOfDomain(static_cast<std::size_t>(mesh_.face[e]) - 1);
      for (const VertexId v : mesh_.elements[e].vertices())
        mesh_.wantedSizes[v.value] = std::min(mesh_.wantedSizes[v.value], largest);
    }
    mesh_.findings = keepSoundFaces(mesh_);
    if (options_.order == 2) makeSecondOrder(mesh_, straightMiddles());
    return std::move(mesh_);
  }

 private:
  std::vector<SideMiddles> straightMiddles() const {
    std::vector<SideMiddles> middles;
    for (const Element& element : mesh_.elements) {
      const auto corners = element.vertices();
      SideMiddles& own = middles.emplace_back();
      for (std::size_t i = 0; i < corners.size(); ++i)
        own[i] = 0.5 * (mesh_.vertices[corners[i].value] +
                        mesh_.vertices[corners[(i + 1) % corners.size()].value]);
    }
    return middles;
  }

  /// Where the file numbers the domains beside its segments, regions outside are left out, and each
  /// domain is a group.
  void takeDomains() {
    std::vector<PlanarRegion> kept;
    std::map<int, FaceGroup> groups;
    for (PlanarRegion& region : regions_.regions) {
      const int domain = domainOf(region);
      if (domain == 0) continue;
      kept.push_back(std::move(region));
      domains_.push_back(domain);
      if (domain == PlanarDomain::kAnyDomain) continue;
      const auto name = domain_.domainNames.find(domain);
      FaceGroup& group = groups[domain];
      group.name =
          name == domain_.domainNames.end() ? "domain " + std::to_string(domain) : name->second;
      group.faces.push_back(static_cast<int>(kept.size()));
    }
    regions_.regions = std::move(kept);
    if (regions_.regions.empty()) throw InputError(domain_.name + ": all regions lie outside");
    for (auto& [domain, group] : groups) mesh_.groups.push_back(std::move(group));
  }

  int domainOf(const PlanarRegion& region) const {
    int domain = PlanarDomain::kAnyDomain;
    for (const auto& loop : region.loops) {
      for (const DirectedPiece d : loop) {
        const auto& segment = domain_.segments[static_cast<std::size_t>(
            regions_.pieces[static_cast<std::size_t>(d.piece)].segment)];
        const int here = d.reversed ? segment.right : segment.left;
        if (domain == PlanarDomain::kAnyDomain) domain = here;
        if (here != domain)
          throw InputError(domain_.name + ":" + std::to_string(segment.line) +
                           ": beside this segment lies domain " + std::to_string(here) +
                           ", but other segments of the same region say " + std::to_string(domain));
      }
    }
    return domain;
  }

  void findUses(const PlanarRegion& region) {
    uses_.resize(regions_.pieces.size(), 0);
    for (const auto& loop : region.loops)
      for (const DirectedPiece d : loop) ++uses_[static_cast<std::size_t>(d.piece)];
  }

  /// Points that no region uses are left out.
  void numberPoints() {
    ids_.resize(regions_.points.size());
    for (std::size_t i = 0; i < regions_.pieces.size(); ++i)
      if (uses_[i] > 0)
        for (const int end : {regions_.pieces[i].from, regions_.pieces[i].to})
          ids_[static_cast<std::size_t>(end)] = VertexId(std::size_t{0});
    for (std::size_t i = 0; i < ids_.size(); ++i)
      if (!ids_[i].isNone()) ids_[i] = addVertex(regions_.points[i]);
  }

  VertexId addVertex(Point2 p) {
    mesh_.vertices.push_back({p.x, p.y, 0});
    return VertexId(mesh_.vertices.size() - 1);
  }

  /// Equal shares of the wanted sizes along the piece, at least one segment.
  void divide(const PlanarPiece& piece) {
    std::vector<VertexId> along;
    if (uses_[divided_.size()] > 0) {
      const Point2 from = regions_.points[static_cast<std::size_t>(piece.from)];
      const Point2 to = regions_.points[static_cast<std::size_t>(piece.to)];
      along.push_back(ids_[static_cast<std::size_t>(piece.from)]);
      for (const double t : sharesBetween(from, to))
        along.push_back(addVertex(from + t * (to - from)));
      along.push_back(ids_[static_cast<std::size_t>(piece.to)]);
    }
    divided_.push_back(std::move(along));
  }

  /// How many segments of the wanted sizes fit up to the end of each of `cells` equal cells.
  std::vector<double> countAlong(Point2 from, Point2 to, std::size_t cells, bool& fine) const {
    constexpr double kMostOfSize = 0.25;  // length of a cell
    const double step = distance(from, to) / static_cast<double>(cells);
    std::vector<double> count{0};
    double before = size_.sizeAt(inPlane(from));
    fine = true;
    for (std::size_t i = 1; i <= cells; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(cells);
      const double here = size_.sizeAt(inPlane(from + t * (to - from)));
      count.push_back(count.back() + 2 * step / (before + here));
      fine = fine && step <= kMostOfSize * here;
      before = here;
    }
    return count;
  }

  std::vector<double> sharesBetween(Point2 from, Point2 to) const {
    constexpr double kMostSegments = 1e7, kSamplesPerSegment = 10, kDenser = 8;
    constexpr int kMostRounds = 4;
    if (options_.keepBoundary) return {};
    const double samplesPerSize = size_.isVaried() ? kSamplesPerSegment : 1;
    double cells = std::ceil(samplesPerSize * distance(from, to) / options_.size) + 1;
    if (!(cells < kMostSegments))
      throw InputError(
          "a segment of the domain would need more than 10 million pieces; ask for a "
          "larger size");
    bool fine = true;
    std::vector<double> count = countAlong(from, to, static_cast<std::size_t>(cells), fine);
    for (int round = 0; size_.isVaried() && !fine && round < kMostRounds; ++round) {
      cells *= kDenser;
      if (cells > kMostSegments) break;
      count = countAlong(from, to, static_cast<std::size_t>(cells), fine);
    }
    return equalShares(count);
  }

  /// Where along the cells each of the whole number of segments ends, but for the last.
  static std::vector<double> equalShares(const std::vector<double>& count) {
    const std::size_t cells = count.size() - 1;
    const auto pieces = static_cast<std::size_t>(std::max(1.0, std::floor(count.back() + 0.5)));
    std::vector<double> shares;
    std::size_t cell = 1;
    for (std::size_t k = 1; k < pieces; ++k) {
      const double target = count.back() * static_cast<double>(k) / static_cast<double>(pieces);
      while (cell < cells && count[cell] < target) ++cell;
      const double within = (target - count[cell - 1]) / (count[cell] - count[cell - 1]);
      shares.push_back((static_cast<double>(cell - 1) + within) / static_cast<double>(cells));
    }
    return shares;
  }

  void meshRegion(std::size_t index) {
    const auto start = std::chrono::steady_clock::now();
    const PlanarRegion& region = regions_.regions[index];
    FaceReport report;
    report.id = static_cast<int>(index) + 1;
    report.surfaceType = "plane";
    report.area = region.area;
    std::vector<VertexId> boundary;
    const FrontInput input = boundaryOf(region, boundary);
    const RegionSize own(size_, sizeOfDomain(index));
    const auto size = std::make_shared<const GradedSize>(own, input, options_.growth);
    const PlanePoints plane;
    const RegionTask task{input,
                          [&] {
                            return PieceTools{std::make_unique<PlaneChartMaker>(kUp), size};
                          },
                          &plane,
                          {},
                          options_.optimize,
                          options_.threads};
    RegionMesh meshed =
        af2::meshRegion(algorithm_, task, {options_.observer, options_.progress, options_.stop});
    judge(meshed, report);
    if (report.status == FaceStatus::Complete) appendFace(mesh_, meshed.result, boundary, report);

    const auto end = std::chrono::steady_clock::now();
    report.seconds = std::chrono::duration<double>(end - start).count();
    const double optimizing =
        meshed.seconds > 0 ? report.seconds * meshed.optimizeSeconds / meshed.seconds : 0;
    mesh_.seconds.optimize += optimizing;
    mesh_.seconds.surface += report.seconds - optimizing;
    mesh_.faces.push_back(std::move(report));
  }

  double sizeOfDomain(std::size_t region) const {
    const auto own = domain_.domainSizes.find(domains_[region]);
    return own == domain_.domainSizes.end() ? std::numeric_limits<double>::infinity()
                                            : std::max(own->second, options_.minSize);
  }

  FrontInput boundaryOf(const PlanarRegion& region, std::vector<VertexId>& boundary) {
    localIds_.resize(mesh_.vertices.size());
    FrontInput input;
    for (const auto& loop : region.loops) {
      std::vector<BoundaryCorner> corners;
      for (const DirectedPiece d : loop) {
        std::vector<VertexId> along = divided_[static_cast<std::size_t>(d.piece)];
        if (d.reversed) std::reverse(along.begin(), along.end());
        along.pop_back();
        for (const VertexId id : along) corners.push_back(cornerOf(id, boundary));
      }
      input.loops.push_back(std::move(corners));
    }
    for (const VertexId id : boundary) localIds_[id.value] = VertexId();
    input.vertexCount = boundary.size();
    return input;
  }

  BoundaryCorner cornerOf(VertexId id, std::vector<VertexId>& boundary) {
    VertexId& local = localIds_[id.value];
    if (local.isNone()) {
      local = VertexId(boundary.size());
      boundary.push_back(id);
    }
    const Point3& p = mesh_.vertices[id.value];
    return {local, inPlane({p.x, p.y})};
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
                    std::to_string(p.y) + ")";
  }

  /// Counts only the faces that were meshed.
  void addSegments() {
    std::vector<int> uses(regions_.pieces.size(), 0);
    for (std::size_t i = 0; i < regions_.regions.size(); ++i) {
      if (mesh_.faces[i].status != FaceStatus::Complete) continue;
      for (const auto& loop : regions_.regions[i].loops)
        for (const DirectedPiece d : loop) ++uses[static_cast<std::size_t>(d.piece)];
    }
    for (std::size_t p = 0; p < divided_.size(); ++p)
      for (std::size_t i = 0; uses[p] > 0 && i + 1 < divided_[p].size(); ++i)
        mesh_.segments.push_back({divided_[p][i], divided_[p][i + 1],
                                  regions_.pieces[p].segment + 1, uses[p],
                                  0.5 * (mesh_.vertices[divided_[p][i].value] +
                                         mesh_.vertices[divided_[p][i + 1].value])});
  }

  const AF2Algorithm& algorithm_;
  const PlanarMeshingOptions& options_;
  DomainSize size_;
  const PlanarDomain& domain_;
  std::vector<int> domains_;  // by region
  PlanarRegions regions_;
  std::vector<int> uses_;                       // by piece
  std::vector<VertexId> ids_;                   // by point
  std::vector<VertexId> localIds_;              // by vertex of the mesh, while one region is read
  std::vector<std::vector<VertexId>> divided_;  // by piece, ends included; empty if unused
  ModelMesh mesh_;
};

}  // namespace

ModelMesh meshPlanar(const PlanarDomain& domain, const AF2Algorithm& algorithm,
                     const PlanarMeshingOptions& options) {
  if (!(options.size > 0) || !std::isfinite(options.size))
    throw InputError("the size must be a positive number");
  if (options.elementsAcross == 0) return PlanarMesher(domain, algorithm, options).mesh();
  PlanarMeshingOptions finer = options;
  finer.elementsAcross = 0;
  PlanarMeshingOptions first = finer;
  first.optimize = false;
  first.progress = {};
  first.observer = nullptr;
  const ModelMesh coarse = PlanarMesher(domain, algorithm, first).mesh();
  addSources(narrowPlaces(coarse, options.elementsAcross),
             leastForLimits(options.size, options.minSize), finer.sources);
  return PlanarMesher(domain, algorithm, finer).mesh();
}

}  // namespace af2::geometry
