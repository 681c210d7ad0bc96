#include "geometry/occ/edges/narrow_strips.h"

#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/base/parallel.h"
#include "geometry/base/box_tree.h"
#include "geometry/occ/edges/edge_on_face.h"
#include "geometry/occ/sizes/sizing.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

namespace {

/// Segments along a strip are at most this many times longer than the strip is wide.
constexpr double kMaxOfWidth = 1.5;
/// Strips that would need segments shorter than this share of the size are not changed. The share
/// is smaller if turns have a minimum number of elements, because the mesh is then fine in places
/// anyway.
constexpr double kMinShare = 0.15, kMinShareWithTurns = 0.1;

/// The edges of one face against each other.
class FaceStrips {
 public:
  FaceStrips(const ModelShape& model, int face, const std::vector<Ends>& ends,
             const std::vector<KnottedEdge>& edges, double leastShare)
      : model_(model),
        face_(face),
        forward_(TopoDS::Face(model.face(face).Oriented(TopAbs_FORWARD))),
        ends_(ends),
        edges_(edges),
        leastShare_(leastShare) {
    for (const EdgeUse& use : model.edgesOfFaces[static_cast<std::size_t>(face) - 1]) {
      const auto index = static_cast<std::uint32_t>(use.id - 1);
      if (!edges_[index].knots.empty()) uses_.push_back({index, use.edge});
    }
  }

  std::vector<StripLimit> limits() {
    std::vector<Box3> boxes;
    for (const Use& use : uses_) boxes.push_back(edges_[use.edge].box);
    const BoxTree tree(boxes);
    std::vector<std::uint32_t> near;
    for (Use& use : uses_) {
      const KnottedEdge& edge = edges_[use.edge];
      const Point3 reach{edge.reach, edge.reach, edge.reach};
      near.clear();
      tree.forEachIn({edge.box.low - reach, edge.box.high + reach}, [&](std::uint32_t i) {
        if (mayFace(use.edge, uses_[i].edge)) near.push_back(uses_[i].edge);
      });
      if (!near.empty()) look(use, near);
    }
    return std::move(limits_);
  }

 private:
  struct Use {
    std::uint32_t edge;
    TopoDS_Edge oriented;             ///< as in the face
    std::optional<bool> isSeam = {};  ///< looked up when it matters
  };
  /// The other side of a strip.
  struct Side {
    double width;
    Point3 direction;
  };

  bool isEndOf(std::uint32_t point, std::uint32_t edge) const {
    return point == ends_[edge].first || point == ends_[edge].last;
  }

  bool mayFace(std::uint32_t a, std::uint32_t b) const {
    if (a == b) return edges_[a].isBent;
    if (!isEndOf(ends_[a].first, b) && !isEndOf(ends_[a].last, b)) return true;
    return !(edges_[a].isStraight && edges_[b].isStraight) && !areWedge(a, b);
  }

  void look(Use& use, const std::vector<std::uint32_t>& near) {
    const KnottedEdge& edge = edges_[use.edge];
    for (std::uint32_t k = 0; k < edge.knots.size(); ++k) {
      const Knot& knot = edge.knots[k];
      const double most = knot.size / kMaxOfWidth;
      double width = most;
      for (const std::uint32_t other : near) {
        const std::optional<Side> side = across(use.edge, k, other, width);
        if (side && isInside(use, knot, side->direction)) width = side->width;
      }
      if (width < most && kMaxOfWidth * width > leastShare_ * knot.size)
        limits_.push_back({use.edge, knot.piece, knot.first, knot.last, kMaxOfWidth * width});
    }
  }

  /// The nearest place of `other` that faces the knot and is nearer than `most`.
  std::optional<Side> across(std::uint32_t edge, std::uint32_t k, std::uint32_t other,
                             double most) const {
    const KnottedEdge& line = edges_[other];
    const Knot& knot = edges_[edge].knots[k];
    if (line.box.distanceTo(knot.position) > most) return std::nullopt;
    const auto sideAt = [&](std::uint32_t i, double nearer) -> std::optional<Side> {
      if (line.knots[i].piece != line.knots[i + 1].piece) return std::nullopt;
      if (edge == other && isBeside(k, i + 1)) return std::nullopt;
      return acrossTo(line.knots[i].position, line.knots[i + 1].position, knot, line.blur, nearer);
    };
    const BoxTree* const segments = line.segments();
    if (!segments) return nearestAlong(line, knot, most, sideAt);
    const std::uint32_t nearest = segments->nearest(knot.position, most, [&](std::uint32_t i) {
      const std::optional<Side> side = sideAt(i, most);
      return side ? side->width : std::numeric_limits<double>::infinity();
    });
    return nearest == BoxTree::kNone ? std::nullopt : sideAt(nearest, most);
  }

  /// The same, from one segment to the next.
  template <class SideAt>
  static std::optional<Side> nearestAlong(const KnottedEdge& line, const Knot& knot, double most,
                                          SideAt&& sideAt) {
    std::optional<Side> nearest;
    const double perLongest = 1 / line.longest;
    std::uint32_t step = 1;
    for (std::uint32_t i = 0; i + 1 < line.knots.size(); i += step) {
      const Point3& from = line.knots[i].position;
      const double reach = line.longest + most;
      const double squared = dot(knot.position - from, knot.position - from);
      step = 1;
      if (squared > reach * reach) {  // on to what may be near enough
        const double segments = perLongest * (std::sqrt(squared) - reach);
        step += static_cast<std::uint32_t>(std::min(segments, double(line.knots.size())));
        continue;
      }
      const std::optional<Side> side = sideAt(i, most);
      if (!side) continue;
      most = side->width;
      nearest = side;
    }
    return nearest;
  }

  static std::optional<Side> acrossTo(const Point3& from, const Point3& to, const Knot& knot,
                                      double least, double most) {
    constexpr double kFacing = 0.5;  // most cosine between an edge and the way across
    const Point3 along = to - from;
    const double t = std::clamp(dot(knot.position - from, along) / dot(along, along), 0.0, 1.0);
    const Point3 way = from + t * along - knot.position;
    const double width = length(way);
    if (!(width < most) || width <= least) return std::nullopt;
    if (std::abs(dot(way, along)) > kFacing * width * length(along)) return std::nullopt;
    if (std::abs(dot(way, knot.tangent)) > kFacing * width) return std::nullopt;
    return Side{width, (1 / width) * way};
  }

  /// Whether a segment of the same edge is a neighbour of the knot.
  static bool isBeside(std::uint32_t k, std::uint32_t i) {
    constexpr std::uint32_t kNear = 3;
    return (i > k ? i - k : k + 1 - i) <= kNear;
  }

  /// Whether two edges part from a common end at a small angle. No division opens such a wedge, and
  /// where its sides touch at the tip, the element there is the worse the shorter it is.
  bool areWedge(std::uint32_t a, std::uint32_t b) const {
    constexpr double kSharp = 0.866;  // least cosine of the angle
    const auto awayFrom = [&](std::uint32_t edge, bool first) {
      const Knot &front = edges_[edge].knots.front(), &back = edges_[edge].knots.back();
      return first ? front.tangent : -1.0 * back.tangent;
    };
    for (const bool first : {true, false})
      for (const bool itsFirst : {true, false}) {
        const std::uint32_t end = first ? ends_[a].first : ends_[a].last;
        if (end != (itsFirst ? ends_[b].first : ends_[b].last)) continue;
        if (dot(awayFrom(a, first), awayFrom(b, itsFirst)) > kSharp) return true;
      }
    return false;
  }

  /// Whether a direction leads from an edge into the face.
  bool isInside(Use& use, const Knot& knot, const Point3& direction) {
    if (!use.isSeam) use.isSeam = BRep_Tool::IsClosed(use.oriented, forward_);
    if (*use.isSeam) return true;
    if (!surface_) surface_.emplace(model_.surface(face_));
    const Point3 normal = normalOnEdge(*surface_, forward_, use.oriented, knot.parameter);
    const double side = dot(cross(normal, knot.tangent), direction);
    return use.oriented.Orientation() == TopAbs_REVERSED ? side < 0 : side > 0;
  }

  const ModelShape& model_;
  int face_;
  TopoDS_Face forward_;
  const std::vector<Ends>& ends_;
  const std::vector<KnottedEdge>& edges_;
  double leastShare_;  ///< of the size, that segments may have
  std::vector<Use> uses_;
  std::optional<FaceSurface> surface_;
  std::vector<StripLimit> limits_;
};

/// Of all edges, apart from those with sizes of their own.
std::vector<KnottedEdge> knottedEdges(const CadSizes& sizes, int threads,
                                      const std::vector<EdgeSamples>& samples) {
  constexpr std::size_t kAtOnce = 8;
  std::vector<KnottedEdge> edges(samples.size());
  forEachInRanges(samples.size(), kAtOnce, threads, [&](std::size_t i) {
    if (!sizes.edgeSizes.contains(static_cast<int>(i) + 1))
      edges[i] = knotted(samples[i], 1 / kMaxOfWidth);
  });
  return edges;
}

/// By face: whether any of its edges differs from what is known.
std::vector<bool> facesToLookAt(const ModelShape& model, const std::vector<KnottedEdge>& edges,
                                const std::vector<Ends>& ends, const KnownStrips* known) {
  const auto count = static_cast<std::size_t>(model.faces.Extent());
  if (!known || known->byFace.empty()) return std::vector<bool>(count, true);
  std::vector<bool> isKnown;
  for (std::size_t i = 0; i < edges.size(); ++i)
    isKnown.push_back(ends[i].first == known->ends[i].first &&
                      ends[i].last == known->ends[i].last && edges[i].isSameAs(known->edges[i]));
  std::vector<bool> differs;
  for (std::size_t i = 0; i < count; ++i)
    differs.push_back(std::ranges::any_of(model.edgesOfFaces[i], [&](const EdgeUse& use) {
      return !isKnown[static_cast<std::size_t>(use.id) - 1];
    }));
  return differs;
}

}  // namespace

void limitInStrips(const ModelShape& model, const CadSizes& sizes, const std::vector<Ends>& ends,
                   int threads, std::vector<EdgeSamples>& samples, const std::set<int>& without,
                   KnownStrips* known) {
  std::vector<KnottedEdge> edges = knottedEdges(sizes, threads, samples);
  const std::vector<bool> isLookedAt = facesToLookAt(model, edges, ends, known);
  const double leastShare = sizes.elementsPerTurn > 0 ? kMinShareWithTurns : kMinShare;
  std::vector<std::vector<StripLimit>> byFace(isLookedAt.size());
  forEachInParallel(byFace.size(), threads, [&](std::size_t i) {
    if (!isLookedAt[i]) {
      byFace[i] = known->byFace[i];
      return;
    }
    if (without.contains(static_cast<int>(i) + 1)) return;
    try {
      byFace[i] = FaceStrips(model, static_cast<int>(i) + 1, ends, edges, leastShare).limits();
    } catch (const std::exception&) {  // reported when the face is meshed
    } catch (const Standard_Failure&) {
    }
  });
  for (const std::vector<StripLimit>& limits : byFace)
    for (const StripLimit& limit : limits) {
      std::vector<double>& along = samples[limit.edge].pieces[limit.piece].sizes;
      for (std::size_t i = limit.first; i < limit.last; ++i)
        along[i] = std::min(along[i], bounded(sizes, limit.size));
    }
  if (known && known->byFace.empty()) *known = {std::move(edges), ends, std::move(byFace)};
}

}  // namespace af2::geometry
