#include "geometry/planar/loops.h"

#include <algorithm>
#include <map>

#include "engine/base/error.h"
#include "engine/base/place_text.h"
#include "engine/base/predicates.h"
#include "engine/rule/free_zone.h"
#include "geometry/base/disjoint_sets.h"
#include "geometry/planar/clean_segments.h"

namespace af2::geometry {

namespace {

/// Half-edge 2 p runs along piece p, 2 p + 1 against it.
using HalfEdge = int;
HalfEdge twin(HalfEdge h) { return h ^ 1; }
DirectedPiece directed(HalfEdge h) { return {h / 2, (h & 1) != 0}; }

/// The subdivision of the plane by the pieces: its cycles of half-edges, each with its face on the
/// left, and how they nest.
class Subdivision {
 public:
  explicit Subdivision(PlanarRegions& result) : result_(result) {
    sortAroundPoints();
    followCycles();
    findOuterCycles();
    nest();
  }

  /// Bounded faces, by their outer cycle; ordered by their leftmost, then lowest point.
  std::vector<std::size_t> faces() const {
    std::vector<std::size_t> faces;
    for (std::size_t c = 0; c < cycles_.size(); ++c)
      if (!cycles_[c].isOutside) faces.push_back(c);
    std::stable_sort(faces.begin(), faces.end(), [&](std::size_t a, std::size_t b) {
      return before(leftmost(cycles_[a]), leftmost(cycles_[b]));
    });
    return faces;
  }

  /// The face in which a point lies, if it is bounded.
  std::size_t faceAround(Point2 p) const { return smallestAround(p, kNoComponent); }
  static constexpr std::size_t kNoFace = ~std::size_t{0};

  /// Points that no segment uses.
  std::vector<int> isolatedPoints() const {
    std::vector<int> points;
    for (std::size_t i = 0; i < leaving_.size(); ++i)
      if (leaving_[i].empty()) points.push_back(static_cast<int>(i));
    return points;
  }

  PlanarRegion region(std::size_t face) const {
    PlanarRegion region;
    addLoop(cycles_[face], region);
    for (const Cycle& cycle : cycles_)
      if (cycle.isOutside && cycle.around == face) addLoop(cycle, region);
    return region;
  }

 private:
  static constexpr int kNoComponent = -1;

  struct Cycle {
    std::vector<HalfEdge> edges;
    int component = 0;
    bool isOutside = false;        ///< goes around its component from outside
    std::size_t around = kNoFace;  ///< if outside: the face in which the component lies
    double area = 0;
    Box2 box;
  };

  int startOf(HalfEdge h) const { return result_.start(directed(h)); }
  int endOf(HalfEdge h) const { return startOf(twin(h)); }
  Point2 point(int i) const { return result_.points[static_cast<std::size_t>(i)]; }

  /// Half-edges that leave each point, counter-clockwise, starting from straight down.
  void sortAroundPoints() {
    leaving_.resize(result_.points.size());
    for (HalfEdge h = 0; h < static_cast<int>(2 * result_.pieces.size()); ++h)
      leaving_[static_cast<std::size_t>(startOf(h))].push_back(h);
    for (auto& around : leaving_)
      std::sort(around.begin(), around.end(),
                [&](HalfEdge g, HalfEdge h) { return turnsBefore(g, h); });
    position_.resize(2 * result_.pieces.size());
    for (const auto& around : leaving_)
      for (std::size_t i = 0; i < around.size(); ++i)
        position_[static_cast<std::size_t>(around[i])] = i;
  }

  bool turnsBefore(HalfEdge g, HalfEdge h) const {
    const Point2 centre = point(startOf(g)), p = point(endOf(g)), q = point(endOf(h));
    // The right half-plane first, with straight down at its start and straight up at its end.
    const auto isLeft = [&](Point2 r) { return r.x < centre.x; };
    if (isLeft(p) != isLeft(q)) return isLeft(q);
    const auto isDown = [&](Point2 r) { return r.x == centre.x && r.y < centre.y; };
    if (isDown(p) != isDown(q)) return isDown(p);
    return orientation(centre, p, q) == Turn::Left;
  }

  /// With the face on the left: at the end, the half-edge next clockwise from the way back.
  HalfEdge next(HalfEdge h) const {
    const auto& around = leaving_[static_cast<std::size_t>(endOf(h))];
    const std::size_t i = position_[static_cast<std::size_t>(twin(h))];
    return around[(i + around.size() - 1) % around.size()];
  }

  void followCycles() {
    cycleOf_.assign(position_.size(), kNoFace);
    for (HalfEdge first = 0; first < static_cast<int>(position_.size()); ++first) {
      if (cycleOf_[static_cast<std::size_t>(first)] != kNoFace) continue;
      Cycle cycle;
      HalfEdge h = first;
      do {
        cycleOf_[static_cast<std::size_t>(h)] = cycles_.size();
        cycle.edges.push_back(h);
        h = next(h);
      } while (h != first);
      cycle.area = areaOf(cycle);
      cycle.box = boxOf(cycle);
      cycles_.push_back(std::move(cycle));
    }
  }

  double areaOf(const Cycle& cycle) const {
    const Point2 origin = point(startOf(cycle.edges.front()));
    double sum = 0;
    for (const HalfEdge h : cycle.edges)
      sum += cross(point(startOf(h)) - origin, point(endOf(h)) - origin);
    return sum / 2;
  }

  Box2 boxOf(const Cycle& cycle) const {
    Box2 box{point(startOf(cycle.edges.front())), point(startOf(cycle.edges.front()))};
    for (const HalfEdge h : cycle.edges) {
      const Point2 p = point(startOf(h));
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
    return box;
  }

  Point2 leftmost(const Cycle& cycle) const {
    Point2 best = point(startOf(cycle.edges.front()));
    for (const HalfEdge h : cycle.edges)
      if (before(point(startOf(h)), best)) best = point(startOf(h));
    return best;
  }

  /// At the leftmost, then lowest point of a component all edges leave to the right; the outside is
  /// what comes after the last of them.
  void findOuterCycles() {
    DisjointSets components(result_.points.size());
    const auto componentOf = [&](int i) { return components.of(static_cast<std::uint32_t>(i)); };
    for (const PlanarPiece& piece : result_.pieces)
      components.join(static_cast<std::uint32_t>(piece.from), static_cast<std::uint32_t>(piece.to));
    for (Cycle& cycle : cycles_)
      cycle.component = static_cast<int>(componentOf(startOf(cycle.edges.front())));
    constexpr int kNoPoint = -1;
    std::vector<int> leftmost(result_.points.size(), kNoPoint);  // by component
    for (int v = 0; v < static_cast<int>(leaving_.size()); ++v) {
      if (leaving_[static_cast<std::size_t>(v)].empty()) continue;
      int& first = leftmost[componentOf(v)];
      if (first == kNoPoint || before(point(v), point(first))) first = v;
    }
    for (const int v : leftmost) {
      if (v == kNoPoint) continue;
      const HalfEdge last = leaving_[static_cast<std::size_t>(v)].back();
      cycles_[cycleOf_[static_cast<std::size_t>(last)]].isOutside = true;
    }
  }

  void nest() {
    for (Cycle& cycle : cycles_)
      if (cycle.isOutside)
        cycle.around = smallestAround(point(startOf(cycle.edges.front())), cycle.component);
  }

  /// The smallest bounded cycle around a point, among other components.
  std::size_t smallestAround(Point2 p, int component) const {
    std::size_t best = kNoFace;
    for (std::size_t c = 0; c < cycles_.size(); ++c) {
      const Cycle& cycle = cycles_[c];
      if (cycle.isOutside || cycle.component == component || !contains(cycle, p)) continue;
      if (best == kNoFace || cycle.area < cycles_[best].area) best = c;
    }
    return best;
  }

  /// Counts the edges that a ray to the right crosses. Exact.
  bool contains(const Cycle& cycle, Point2 p) const {
    const Box2& box = cycle.box;
    if (p.x < box.low.x || p.x > box.high.x || p.y < box.low.y || p.y > box.high.y) return false;
    bool inside = false;
    for (const HalfEdge h : cycle.edges) {
      const Point2 a = point(startOf(h)), b = point(endOf(h));
      if ((a.y > p.y) == (b.y > p.y)) continue;
      const Turn turn = orientation(a, b, p);
      if (b.y > a.y ? turn == Turn::Left : turn == Turn::Right) inside = !inside;
    }
    return inside;
  }

  void addLoop(const Cycle& cycle, PlanarRegion& region) const {
    std::vector<DirectedPiece> loop;
    for (const HalfEdge h : cycle.edges) loop.push_back(directed(h));
    region.loops.push_back(std::move(loop));
    region.area += cycle.area;
  }

  PlanarRegions& result_;
  std::vector<std::vector<HalfEdge>> leaving_;
  std::vector<std::size_t> position_;  // by half-edge: where it stands in leaving_
  std::vector<std::size_t> cycleOf_;
  std::vector<Cycle> cycles_;
};

std::string nameOf(const char* kind, std::size_t index, Point2 place) {
  return std::string(kind) + " point " + std::to_string(index + 1) + " at " + textOf(place);
}

std::vector<std::size_t> facesOfHoles(const PlanarDomain& domain, const Subdivision& plane,
                                      std::vector<std::string>& notes) {
  std::vector<std::size_t> faces;
  for (std::size_t i = 0; i < domain.holes.size(); ++i) {
    faces.push_back(plane.faceAround(domain.holes[i]));
    if (faces.back() == Subdivision::kNoFace)
      notes.push_back(nameOf("hole", i, domain.holes[i]) +
                      " is outside all outlines and has no effect");
  }
  return faces;
}

/// By face: the first that a point gives it.
std::map<std::size_t, int> domainsOfFaces(const PlanarDomain& domain, const Subdivision& plane,
                                          const std::vector<std::size_t>& holes,
                                          std::vector<std::string>& notes) {
  std::map<std::size_t, int> domains;
  for (std::size_t i = 0; i < domain.regionPoints.size(); ++i) {
    const PlanarDomain::RegionPoint& point = domain.regionPoints[i];
    const std::size_t face = plane.faceAround(point.inside);
    if (face == Subdivision::kNoFace || std::ranges::count(holes, face) > 0) {
      notes.push_back(nameOf("region", i, point.inside) + " is in no region and has no effect");
      continue;
    }
    if (domains.try_emplace(face, point.domain).first->second != point.domain)
      notes.push_back(nameOf("region", i, point.inside) +
                      " is in the same region as an earlier one, which is used");
  }
  return domains;
}

}  // namespace

PlanarRegions findRegions(const PlanarDomain& domain, double blur) {
  PlanarRegions result = cleanSegments(domain, blur);
  const Subdivision plane(result);
  const std::vector<std::size_t> faces = plane.faces();
  if (faces.empty())
    throw InputError(domain.name + ": its segments enclose nothing; each outline must be closed");
  const std::vector<std::size_t> holes = facesOfHoles(domain, plane, result.notes);
  const std::map<std::size_t, int> domains = domainsOfFaces(domain, plane, holes, result.notes);
  std::map<std::size_t, std::vector<int>> isolated;  // by face
  for (const int point : domain.keepsPoints ? plane.isolatedPoints() : std::vector<int>())
    isolated[plane.faceAround(result.points[static_cast<std::size_t>(point)])].push_back(point);
  for (const std::size_t face : faces) {
    if (std::find(holes.begin(), holes.end(), face) != holes.end()) continue;
    result.regions.push_back(plane.region(face));
    if (const auto found = isolated.find(face); found != isolated.end())
      result.regions.back().isolated = found->second;
    if (const auto found = domains.find(face); found != domains.end())
      result.regions.back().domain = found->second;
  }
  if (result.regions.empty())
    throw InputError(domain.name + ": every region that its segments enclose is a hole");
  return result;
}

}  // namespace af2::geometry
