#include "geometry/planar/mesh_planar.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "engine/base/error.h"
#include "engine/base/place_text.h"
#include "geometry/base/constants.h"
#include "geometry/charts/flat_surface.h"
#include "geometry/domain/domain_model.h"
#include "geometry/planar/loops.h"

namespace af2::geometry {

namespace {

Point3 inSpace(Point2 p) { return {p.x, p.y, 0}; }

/// Converts the regions between the pieces of a domain to faces between curves.
class ModelMaker {
 public:
  ModelMaker(const PlanarDomain& domain, const MeshingOptions& options, double blur)
      : domain_(domain), options_(options), regions_(findRegions(domain, blur)) {
    takeDomains();
  }

  DomainModel make() {
    model_.name = domain_.name;
    model_.isFlat = true;
    model_.isExact = domain_.curves.empty();
    model_.notes = regions_.notes;
    measure();
    findUses();
    numberPoints();
    makeCurves();
    for (std::size_t i = 0; i < regions_.regions.size(); ++i) addFace(i);
    addBoundaries();
    return std::move(model_);
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
    if (regions_.regions.empty()) throw InputError(domain_.name + ": all regions are outside");
    addGroups(faces);
  }

  void addGroups(const std::map<int, std::vector<int>>& facesByDomain) {
    std::vector<FaceGroup>& groups = model_.groups;
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
    for (FaceGroup& group : groups) std::ranges::sort(group.faces);
  }

  /// Of the edges that are there.
  void addBoundaries() {
    std::map<int, std::set<int>> edges;  // by marker
    for (std::size_t i = 0; i < regions_.pieces.size(); ++i)
      if (const auto& segment = segmentOf(regions_.pieces[i]); isUsed_[i] && segment.marker != 0)
        edges[segment.marker].insert(segment.edge);
    for (const auto& [marker, ids] : edges) {
      const auto name = domain_.markerNames.find(marker);
      model_.boundaries.push_back({marker,
                                   name == domain_.markerNames.end() ? "" : name->second,
                                   {ids.begin(), ids.end()}});
    }
  }

  const PlanarPiece& pieceAt(int piece) const {
    return regions_.pieces[static_cast<std::size_t>(piece)];
  }
  const PlanarDomain::Segment& segmentOf(const PlanarPiece& piece) const {
    return domain_.segments[static_cast<std::size_t>(piece.segment)];
  }
  Point2 point(int i) const { return regions_.points[static_cast<std::size_t>(i)]; }

  int domainOf(const PlanarRegion& region) const {
    int domain = region.domain;
    for (const auto& loop : region.loops) {
      for (const DirectedPiece d : loop) {
        const PlanarDomain::Segment& segment = segmentOf(pieceAt(d.piece));
        const int here = d.reversed ? segment.right : segment.left;
        if (here == PlanarDomain::kAnyDomain) continue;
        if (domain == PlanarDomain::kAnyDomain) domain = here;
        if (here != domain)
          throw InputError(domain_.name + ":" + std::to_string(segment.line) +
                           ": this segment borders on domain " + std::to_string(here) +
                           ", but other segments of the same region name domain " +
                           std::to_string(domain));
      }
    }
    return domain;
  }

  void measure() {
    Point2 low = regions_.points[0], high = low;
    for (const Point2 p : regions_.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    model_.diagonal = distance(low, high);
  }

  /// Points that no region uses are left out.
  void findUses() {
    isUsed_.assign(regions_.pieces.size(), false);
    for (const PlanarRegion& region : regions_.regions)
      for (const auto& loop : region.loops)
        for (const DirectedPiece d : loop) isUsed_[static_cast<std::size_t>(d.piece)] = true;
  }

  void numberPoints() {
    corner_.assign(regions_.points.size(), kNone);
    degree_.assign(regions_.points.size(), 0);
    for (std::size_t i = 0; i < regions_.pieces.size(); ++i)
      if (isUsed_[i])
        for (const int end : {regions_.pieces[i].from, regions_.pieces[i].to})
          ++degree_[static_cast<std::size_t>(end)];
    std::vector<bool> isInside(regions_.points.size(), false);
    for (std::size_t i = 0; i < regions_.pieces.size(); ++i)
      if (i > 0 && continues(i)) isInside[static_cast<std::size_t>(regions_.pieces[i].from)] = true;
    std::vector<bool> isCorner(regions_.points.size(), false);
    for (std::size_t i = 0; i < isCorner.size(); ++i) isCorner[i] = degree_[i] > 0 && !isInside[i];
    for (const PlanarRegion& region : regions_.regions)
      for (const int p : region.isolated) isCorner[static_cast<std::size_t>(p)] = true;
    for (std::size_t i = 0; i < isCorner.size(); ++i) {
      if (!isCorner[i]) continue;
      corner_[i] = model_.corners.size();
      model_.corners.push_back(inSpace(regions_.points[i]));
    }
  }

  /// Whether a piece goes on along the curved edge of the piece before, and nothing else meets
  /// them.
  bool continues(std::size_t i) const {
    const PlanarPiece &before = regions_.pieces[i - 1], &piece = regions_.pieces[i];
    const int edge = segmentOf(piece).edge;
    return isUsed_[i - 1] && isUsed_[i] && before.to == piece.from &&
           degree_[static_cast<std::size_t>(piece.from)] == 2 && edge == segmentOf(before).edge &&
           domain_.curves.contains(edge);
  }

  void makeCurves() {
    curveOf_.assign(regions_.pieces.size(), kNone);
    for (std::size_t i = 0; i < regions_.pieces.size(); ++i) {
      if (!isUsed_[i]) continue;
      const PlanarPiece& piece = regions_.pieces[i];
      if (i > 0 && continues(i)) {
        model_.curves.back().knots.push_back(parameterAt(piece, piece.to));
        pieces_.back().last = i;
      } else {
        addCurve(piece);
        pieces_.push_back({i, i});
      }
      model_.curves.back().last = corner_[static_cast<std::size_t>(piece.to)];
      curveOf_[i] = model_.curves.size() - 1;
    }
  }

  void addCurve(const PlanarPiece& piece) {
    const PlanarDomain::Segment& segment = segmentOf(piece);
    DomainCurve curve;
    curve.id = segment.edge;
    curve.first = corner_[static_cast<std::size_t>(piece.from)];
    curve.isKept = options_.keepBoundary;
    curve.largest = std::max(segment.maxSize, options_.sizes.minSize);
    if (const auto bent = domain_.curves.find(segment.edge); bent != domain_.curves.end()) {
      curve.knots = {parameterAt(piece, piece.from), parameterAt(piece, piece.to)};
      curve.pointAt = [at = bent->second](double t) { return inSpace(at(t)); };
    } else {
      curve.knots = {0, 1};
      curve.pointAt = [from = point(piece.from), along = point(piece.to) - point(piece.from)](
                          double t) { return inSpace(from + t * along); };
    }
    model_.curves.push_back(std::move(curve));
  }

  /// Of the end of a piece on its curved edge.
  double parameterAt(const PlanarPiece& piece, int end) const {
    const PlanarDomain::Segment& segment = segmentOf(piece);
    const Point2 from = domain_.points[static_cast<std::size_t>(segment.from)];
    const Point2 along = domain_.points[static_cast<std::size_t>(segment.to)] - from;
    const double within = std::clamp(dot(point(end) - from, along) / dot(along, along), 0.0, 1.0);
    return segment.fromParameter + within * (segment.toParameter - segment.fromParameter);
  }

  void addFace(std::size_t index) {
    const PlanarRegion& region = regions_.regions[index];
    DomainFace face;
    face.surfaceType = "plane";
    face.area = region.area;
    for (const auto& loop : region.loops) addLoop(loop, face);
    for (const int p : region.isolated)
      face.isolated.push_back(corner_[static_cast<std::size_t>(p)]);
    face.largest = sizeOfDomain(index);
    face.surface = plane_;
    face.nearest = [plane = plane_](const Point3& p) { return plane->pointAt(p); };
    face.canBeCut = true;
    noteBlur(region, face);
    model_.faces.push_back(std::move(face));
  }

  /// Each curve once, at the piece with which the loop comes to it.
  void addLoop(const std::vector<DirectedPiece>& loop, DomainFace& face) const {
    std::vector<CurveUse>& uses = face.loops.emplace_back();
    for (const DirectedPiece d : loop) {
      const auto piece = static_cast<std::size_t>(d.piece);
      const std::size_t curve = curveOf_[piece];
      if (piece == (d.reversed ? pieces_[curve].last : pieces_[curve].first))
        uses.push_back({curve, d.reversed});
    }
  }

  void noteBlur(const PlanarRegion& region, DomainFace& face) const {
    std::vector<int> blurred;
    for (const auto& loop : region.loops)
      for (const DirectedPiece d : loop)
        if (const int p = regions_.start(d); regions_.isBlurred[static_cast<std::size_t>(p)])
          blurred.push_back(p);
    if (blurred.empty()) return;
    std::ranges::sort(blurred);
    blurred.erase(std::ranges::unique(blurred).begin(), blurred.end());
    face.notes.push_back(
        "points or segments were merged with others that are nearer than the mesh can show, "
        "at " +
        std::to_string(blurred.size()) + " places, the first at " + textOf(point(blurred.front())));
  }

  double sizeOfDomain(std::size_t region) const {
    const auto own = domain_.domainSizes.find(domains_[region]);
    return own == domain_.domainSizes.end() ? std::numeric_limits<double>::infinity()
                                            : std::max(own->second, options_.sizes.minSize);
  }

  static constexpr std::size_t kNone = ~std::size_t{0};

  /// The pieces of a curve are consecutive.
  struct PieceRange {
    std::size_t first, last;
  };

  const PlanarDomain& domain_;
  const MeshingOptions& options_;
  std::vector<int> domains_;  // by region
  PlanarRegions regions_;
  DomainModel model_;
  std::vector<bool> isUsed_;          // by piece
  std::vector<int> degree_;           // by point: pieces that end there
  std::vector<std::size_t> corner_;   // by point
  std::vector<std::size_t> curveOf_;  // by piece
  std::vector<PieceRange> pieces_;    // by curve
  std::shared_ptr<const FlatSurface> plane_ =
      std::make_shared<const FlatSurface>(Point3{}, Point3{1, 0, 0}, Point3{0, 1, 0});
};

/// The extent below which details are invisible in the mesh: a share of the smallest size that is
/// wanted at a point of the domain. Nothing, if its segments are to be edges of the mesh.
double blurOf(const PlanarDomain& domain, const MeshingOptions& options) {
  if (options.keepBoundary || domain.points.empty()) return 0;
  Point2 low = domain.points[0], high = low;
  for (const Point2 p : domain.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  double size = std::min(options.sizes.size, distance(low, high));
  const auto take = [&](double other) { size = std::min(size, other); };
  for (const auto& [face, own] : options.sizes.faceSizes) take(own);
  for (const auto& [edge, own] : options.sizes.edgeSizes) take(own);
  for (const auto& [part, own] : options.sizes.partSizes) take(own);
  for (const auto& [name, own] : options.sizes.edgeNames) take(own);
  for (const auto& [number, own] : domain.domainSizes) take(own);
  for (const PlanarDomain::Segment& segment : domain.segments) take(segment.maxSize);
  const DomainSize byPosition(options.sizes);
  for (const Point2 p : domain.points) take(byPosition.at(inSpace(p), size));
  return kUnseen * size;
}

}  // namespace

DomainModel planarModel(const PlanarDomain& domain, const MeshingOptions& options) {
  checkSizes(options.sizes);
  return ModelMaker(domain, options, blurOf(domain, options)).make();
}

ModelMesh meshPlanar(const PlanarDomain& domain, const AF2Algorithm& algorithm,
                     const MeshingOptions& options) {
  return meshDomain(planarModel(domain, options), algorithm, options);
}

}  // namespace af2::geometry
