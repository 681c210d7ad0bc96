#include "geometry/retry/shared_diagonals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <optional>
#include <utility>

#include "engine/base/elementary.h"
#include "geometry/retry/retry_limits.h"

namespace af2::geometry {

namespace {

/// Two points of the boundary, the lower one first.
using Ends = std::pair<std::uint32_t, std::uint32_t>;

/// A side of an element between two vertices of the boundary.
struct CommonSide {
  Ends ends;
  std::size_t face = 0;
  auto operator<=>(const CommonSide&) const = default;
};

/// Two adjacent triangles, and those that result from swapping their common edge.
struct Swap {
  std::size_t face = 0, first = 0, second = 0;
  std::array<VertexId, 3> newFirst, newSecond;
  double angle = 0;  ///< the least of the new ones
};

class SharedDiagonals {
 public:
  SharedDiagonals(const DividedEdges& divided, std::vector<FaceMesh>& meshes)
      : divided_(divided), meshes_(meshes) {}

  std::size_t split() {
    findSegments();
    for (std::size_t i = 0; i < meshes_.size(); ++i) addSides(i);
    std::ranges::sort(sides_);
    for (auto first = sides_.begin(); first != sides_.end();) {
      const Ends ends = first->ends;
      const auto isOther = [&](const CommonSide& side) { return side.ends != ends; };
      const auto last = std::find_if(first, sides_.end(), isOther);
      lookAt(ends, first, last);
      first = last;
    }
    return swaps_;
  }

 private:
  using SideAt = std::vector<CommonSide>::const_iterator;

  void findSegments() {
    for (const DividedEdge& edge : divided_.edges)
      for (std::size_t i = 1; i < edge.points.size(); ++i)
        segments_.push_back(std::minmax(edge.points[i - 1], edge.points[i]));
    std::ranges::sort(segments_);
  }
  bool isSegment(Ends ends) const { return std::ranges::binary_search(segments_, ends); }

  void addSides(std::size_t face) {
    const FaceMesh& mesh = meshes_[face];
    if (!mesh.bulk) return addSides(face, mesh.elements);
    const FaceBulk bulk = mesh.bulk->loadShape();
    addSides(face, bulk.elements);
  }

  void addSides(std::size_t face, const std::vector<Element>& elements) {
    const FaceMesh& mesh = meshes_[face];
    for (const Element& element : elements) {
      const auto c = element.vertices();
      for (std::size_t i = 0; i < c.size(); ++i) {
        const VertexId from = c[i], to = c[(i + 1) % c.size()];
        if (std::max(from, to).value < mesh.boundary.size())
          sides_.push_back({std::minmax(mesh.boundary[from.value], mesh.boundary[to.value]), face});
      }
    }
  }

  /// At a segment, every edge inside a face is superfluous; elsewhere, all except one are.
  void lookAt(Ends ends, SideAt first, SideAt last) {
    if (last - first <= 2) return;
    const bool isBoundary = isSegment(ends);
    std::vector<std::size_t> faces;
    for (SideAt side = first; side + 1 < last; ++side) {  // inside a face it has two of them
      const std::size_t face = side->face;
      if ((side + 1)->face != face || (!faces.empty() && faces.back() == face)) continue;
      if (!isBoundary || !runsAlong(face, ends)) faces.push_back(face);
    }
    const std::size_t most = isBoundary ? 0 : 1;
    while (faces.size() > most) {
      const std::optional<Swap> best = bestSwap(faces, ends);
      if (!best) return;
      apply(*best);
      std::erase(faces, best->face);
    }
  }

  std::optional<Swap> bestSwap(const std::vector<std::size_t>& faces, Ends ends) {
    std::optional<Swap> best;
    for (const std::size_t face : faces) {
      const std::optional<Swap> swap = swapIn(face, ends);
      if (swap && (!best || swap->angle > best->angle)) best = swap;
    }
    return best;
  }

  /// Whether a segment is one of the boundary of a face, as at a seam.
  bool runsAlong(std::size_t face, Ends ends) const {
    return std::ranges::any_of(meshes_[face].uses, [&](const SegmentUse& use) {
      const auto& points = divided_.edges[static_cast<std::size_t>(use.edge) - 1].points;
      return Ends(std::minmax(points[use.segment], points[use.segment + 1])) == ends;
    });
  }

  void apply(const Swap& swap) {
    ++swaps_;
    FaceMesh& mesh = meshes_[swap.face];
    const auto set = [&](std::size_t element, const std::array<VertexId, 3>& corners) {
      for (std::size_t i = 0; i < 3; ++i) mesh.elements[element].corners[i] = corners[i];
    };
    set(swap.first, swap.newFirst);
    set(swap.second, swap.newSecond);
  }

  /// Where an element has a side; at its first corner.
  struct Place {
    std::size_t element = 0, corner = 0;
  };

  std::vector<Place> placesOf(const FaceMesh& mesh, Ends ends) const {
    std::vector<Place> places;
    for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
      const auto c = mesh.elements[k].vertices();
      for (std::size_t i = 0; i < c.size(); ++i) {
        const VertexId from = c[i], to = c[(i + 1) % c.size()];
        if (std::max(from, to).value >= mesh.boundary.size()) continue;
        if (Ends(std::minmax(mesh.boundary[from.value], mesh.boundary[to.value])) == ends)
          places.push_back({k, i});
      }
    }
    return places;
  }

  /// Nothing if no other diagonal is possible.
  std::optional<Swap> swapIn(std::size_t face, Ends ends) {
    loadBulk(meshes_[face]);
    const FaceMesh& mesh = meshes_[face];
    if (!mesh.middles.empty()) return std::nullopt;
    const std::vector<Place> places = placesOf(mesh, ends);
    if (places.size() != 2) return std::nullopt;
    const auto one = mesh.elements[places[0].element].vertices();
    const auto other = mesh.elements[places[1].element].vertices();
    if (one.size() != 3 || other.size() != 3) return std::nullopt;
    const VertexId a = one[places[0].corner], b = one[(places[0].corner + 1) % 3];
    if (other[places[1].corner] != b) return std::nullopt;
    const VertexId tip = one[(places[0].corner + 2) % 3];
    const VertexId beyond = other[(places[1].corner + 2) % 3];
    Swap swap{face, places[0].element, places[1].element, {a, beyond, tip}, {beyond, b, tip}, 0};
    swap.angle = leastAngle(mesh, swap, {a, b, tip});
    if (swap.angle < kMinSwappedAngle || areJoined(mesh, tip, beyond)) return std::nullopt;
    return swap;
  }

  Point3 at(const FaceMesh& mesh, VertexId v) const {
    return v.value < mesh.boundary.size() ? divided_.points[mesh.boundary[v.value]]
                                          : mesh.inside[v.value - mesh.boundary.size()];
  }

  Point3 normalOf(const FaceMesh& mesh, const std::array<VertexId, 3>& c) const {
    const Point3 origin = at(mesh, c[0]);
    return cross(at(mesh, c[1]) - origin, at(mesh, c[2]) - origin);
  }

  /// Of both new triangles; 0 if one of them folds over.
  double leastAngle(const FaceMesh& mesh, const Swap& swap,
                    const std::array<VertexId, 3>& before) const {
    const Point3 normal = normalOf(mesh, before);
    double least = 4;
    for (const auto& corners : {swap.newFirst, swap.newSecond}) {
      if (!(dot(normalOf(mesh, corners), normal) > 0)) return 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const Point3 a = at(mesh, corners[(i + 1) % 3]) - at(mesh, corners[i]);
        const Point3 b = at(mesh, corners[(i + 2) % 3]) - at(mesh, corners[i]);
        least = std::min(least, angleBetween(a, b));
      }
    }
    return least;
  }

  /// Whether there is an edge between two vertices already, in this face or in another one.
  bool areJoined(const FaceMesh& mesh, VertexId one, VertexId other) const {
    if (std::max(one, other).value < mesh.boundary.size()) {
      const Ends ends = std::minmax(mesh.boundary[one.value], mesh.boundary[other.value]);
      if (isSegment(ends) || std::ranges::binary_search(sides_, ends, {}, &CommonSide::ends))
        return true;
    }
    return std::ranges::any_of(mesh.elements, [&](const Element& element) {
      const auto c = element.vertices();
      return std::ranges::count(c, one) > 0 && std::ranges::count(c, other) > 0;
    });
  }

  const DividedEdges& divided_;
  std::vector<FaceMesh>& meshes_;
  std::vector<Ends> segments_;     // in order
  std::vector<CommonSide> sides_;  // in order
  std::size_t swaps_ = 0;
};

}  // namespace

std::size_t splitSharedDiagonals(const DividedEdges& divided, std::vector<FaceMesh>& meshes) {
  return SharedDiagonals(divided, meshes).split();
}

bool hasFindings(const MeshFaults& faults) { return !faults.findings.empty(); }

bool hasFewerFindings(const MeshFaults& before, const MeshFaults& after) {
  return after.findings.size() < before.findings.size() &&
         after.crossings.size() <= before.crossings.size();
}

}  // namespace af2::geometry
