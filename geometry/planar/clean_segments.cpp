#include "geometry/planar/clean_segments.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "engine/base/error.h"
#include "engine/base/predicates.h"
#include "geometry/base/box_tree.h"

namespace af2::geometry {

namespace {

/// Whether `p`, which is neither end, lies on the segment rs, exactly.
bool liesExactlyOn(Point2 p, Point2 r, Point2 s) {
  if (orientation(r, s, p) != Turn::Straight) return false;
  const auto [low, high] = before(r, s) ? std::pair(r, s) : std::pair(s, r);
  return before(low, p) && before(p, high);
}

/// Whether `p` lies beside the segment rs by no more than `blur`, and not beyond its ends.
bool liesNear(Point2 p, Point2 r, Point2 s, double blur) {
  const Point2 d = s - r;
  const double along = dot(p - r, d), whole = dot(d, d);
  return along > 0 && along < whole && std::abs(cross(d, p - r)) <= blur * std::sqrt(whole);
}

Box3 boxAround(Point2 p, Point2 q, double margin) {
  return {{std::min(p.x, q.x) - margin, std::min(p.y, q.y) - margin, 0},
          {std::max(p.x, q.x) + margin, std::max(p.y, q.y) + margin, 0}};
}

class Cleaner {
 public:
  Cleaner(const PlanarDomain& domain, double blur) : domain_(domain), blur_(blur) {}

  PlanarRegions clean() {
    checkDomain();
    mergePoints();
    takeSegments();
    findMeetings();
    if (domain_.keepsPoints) findLoosePoints();
    split();
    return std::move(result_);
  }

 private:
  /// The readers of files report these faults with the line; but a calling program may pass any
  /// data.
  void checkDomain() const {
    const auto isFinite = [](Point2 p) { return std::isfinite(p.x) && std::isfinite(p.y); };
    const auto require = [&](bool isSo, std::size_t index, const char* fault) {
      if (!isSo) throw InputError(domain_.name + ": " + fault + std::to_string(index + 1));
    };
    for (std::size_t i = 0; i < domain_.points.size(); ++i)
      require(isFinite(domain_.points[i]), i,
              "a coordinate is not a finite number: that of point ");
    for (std::size_t i = 0; i < domain_.segments.size(); ++i)
      for (const int end : {domain_.segments[i].from, domain_.segments[i].to})
        require(end >= 0 && std::cmp_less(end, domain_.points.size()), i,
                "there is no such point: at an end of segment ");
    for (std::size_t i = 0; i < domain_.holes.size(); ++i)
      require(isFinite(domain_.holes[i]), i, "a coordinate is not a finite number: that of hole ");
    for (std::size_t i = 0; i < domain_.regionPoints.size(); ++i)
      require(isFinite(domain_.regionPoints[i].inside), i,
              "a coordinate is not a finite number: that of region ");
  }

  void mergePoints() {
    std::vector<Box3> boxes;
    for (const Point2 p : domain_.points) boxes.push_back(boxAround(p, p, 0));
    const BoxTree tree(boxes);
    std::vector<int> first(domain_.points.size(), kNone);  // by point: the first that it is
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (first[i] != kNone) continue;
      const Point2 p = domain_.points[i];
      tree.forEachIn(boxAround(p, p, blur_), [&](std::uint32_t other) {
        const Point2 q = domain_.points[other];
        if ((q == p || distance(q, p) <= blur_) && first[other] == kNone)
          first[other] = static_cast<int>(i);
      });
    }
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (first[i] == static_cast<int>(i)) {
        index_.push_back(static_cast<int>(result_.points.size()));
        result_.points.push_back(domain_.points[i]);
        result_.isBlurred.push_back(false);
      } else {
        index_.push_back(index_[static_cast<std::size_t>(first[i])]);
        if (domain_.points[i] != result_.points[static_cast<std::size_t>(index_.back())])
          result_.isBlurred[static_cast<std::size_t>(index_.back())] = true;
      }
    }
  }

  using PieceOfPoints = std::map<std::pair<int, int>, std::size_t>;

  /// Of pieces between the same points the first counts that is marked as part of a boundary, or
  /// else the first. Knows by `seen` which there are in `pieces`.
  void addOnce(PlanarPiece piece, std::vector<PlanarPiece>& pieces, PieceOfPoints& seen) {
    const auto [known, isNew] = seen.emplace(std::minmax(piece.from, piece.to), pieces.size());
    if (isNew) {
      pieces.push_back(piece);
      return;
    }
    PlanarPiece& first = pieces[known->second];
    const PlanarDomain::Segment &old = segmentOf(first), &other = segmentOf(piece);
    if (other.marker == 0 || other.marker == old.marker) return;
    if (old.marker == 0)
      first = piece;
    else
      result_.notes.push_back("line " + std::to_string(other.line) +
                              ": this segment coincides with that of line " +
                              std::to_string(old.line) + ", whose boundary marker is used");
  }

  const PlanarDomain::Segment& segmentOf(const PlanarPiece& piece) const {
    return domain_.segments[static_cast<std::size_t>(piece.segment)];
  }

  /// Each pair of points once, none that is one point twice.
  void takeSegments() {
    PieceOfPoints seen;
    for (std::size_t i = 0; i < domain_.segments.size(); ++i) {
      const int from = index_[static_cast<std::size_t>(domain_.segments[i].from)];
      const int to = index_[static_cast<std::size_t>(domain_.segments[i].to)];
      if (from != to) addOnce({from, to, static_cast<int>(i)}, segments_, seen);
    }
    splits_.resize(segments_.size());
  }

  Point2 point(int i) const { return result_.points[static_cast<std::size_t>(i)]; }
  Box3 boxOf(const PlanarPiece& piece, double margin) const {
    return boxAround(point(piece.from), point(piece.to), margin);
  }

  /// From left to right.
  void findMeetings() {
    const auto low = [&](std::size_t i) {
      return std::min(point(segments_[i].from).x, point(segments_[i].to).x);
    };
    std::vector<std::size_t> order(segments_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return low(a) < low(b); });
    std::vector<Box3> boxes;
    for (const std::size_t i : order) boxes.push_back(boxOf(segments_[i], 0));
    const BoxTree tree(boxes);
    std::vector<std::uint32_t> later;
    for (std::size_t i = 0; i < order.size(); ++i) {
      later.clear();
      tree.forEachIn(boxOf(segments_[order[i]], blur_), [&](std::uint32_t k) {
        if (k > i) later.push_back(k);
      });
      std::ranges::sort(later);
      for (const std::uint32_t k : later) meet(order[i], order[k]);
    }
  }

  void meet(std::size_t i, std::size_t k) {
    const PlanarPiece &s = segments_[i], &t = segments_[k];
    const Point2 a = point(s.from), b = point(s.to), c = point(t.from), d = point(t.to);
    bool touching = s.from == t.from || s.from == t.to || s.to == t.from || s.to == t.to;
    for (const int v : {t.from, t.to}) touching = splitAt(v, i) || touching;
    for (const int v : {s.from, s.to}) touching = splitAt(v, k) || touching;
    if (!touching && segmentsMeet(a, b, c, d)) refuseCrossing(s, t);
  }

  /// Whether a point lies on a segment, which then is split there.
  bool splitAt(int v, std::size_t i) {
    const PlanarPiece& s = segments_[i];
    if (v == s.from || v == s.to) return false;
    const Point2 p = point(v), a = point(s.from), b = point(s.to);
    const bool isExact = liesExactlyOn(p, a, b);
    if (!isExact && !(blur_ > 0 && liesNear(p, a, b, blur_))) return false;
    splits_[i].push_back(v);
    if (!isExact) result_.isBlurred[static_cast<std::size_t>(v)] = true;
    return true;
  }

  [[noreturn]] void refuseCrossing(const PlanarPiece& s, const PlanarPiece& t) const {
    const int first = segmentOf(s).line, second = segmentOf(t).line;
    throw InputError(domain_.name + ":" + std::to_string(std::max(first, second)) +
                     ": this segment crosses the one in line " +
                     std::to_string(std::min(first, second)) +
                     "; put a vertex where they cross and split both there");
  }

  /// Whether p comes before q along a segment. Points off the segment, within the blur, cannot be
  /// ordered exactly.
  bool isBetween(int p, int q, const PlanarPiece& segment) const {
    const Point2 from = point(segment.from), to = point(segment.to);
    if (blur_ > 0) {
      const double s = dot(point(p) - from, to - from), t = dot(point(q) - from, to - from);
      return s < t || (s == t && p < q);
    }
    return before(from, to) ? before(point(p), point(q)) : before(point(q), point(p));
  }

  /// Points that no segment uses may lie on one, too.
  void findLoosePoints() {
    std::vector<bool> isUsed(result_.points.size(), false);
    for (const PlanarPiece& s : segments_)
      for (const int v : {s.from, s.to}) isUsed[static_cast<std::size_t>(v)] = true;
    std::vector<Box3> boxes;
    for (const PlanarPiece& s : segments_) boxes.push_back(boxOf(s, 0));
    const BoxTree tree(boxes);
    for (std::size_t v = 0; v < isUsed.size(); ++v) {
      const Point2 p = result_.points[v];
      if (!isUsed[v])
        tree.forEachIn(boxAround(p, p, blur_),
                       [&](std::uint32_t i) { splitAt(static_cast<int>(v), i); });
    }
  }

  void split() {
    PieceOfPoints seen;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      std::vector<int>& at = splits_[i];
      std::sort(at.begin(), at.end(), [&](int p, int q) { return isBetween(p, q, segments_[i]); });
      at.erase(std::unique(at.begin(), at.end()), at.end());
      at.push_back(segments_[i].to);
      int from = segments_[i].from;
      for (const int to : at) {
        addOnce({from, to, segments_[i].segment}, result_.pieces, seen);
        from = to;
      }
    }
  }

  static constexpr int kNone = -1;

  const PlanarDomain& domain_;
  double blur_;
  std::vector<int> index_;  // by point of the domain: its index in the result
  std::vector<PlanarPiece> segments_;
  std::vector<std::vector<int>> splits_;  // by segment: points inside it
  PlanarRegions result_;
};

}  // namespace

PlanarRegions cleanSegments(const PlanarDomain& domain, double blur) {
  return Cleaner(domain, blur).clean();
}

}  // namespace af2::geometry
