#include "geometry/planar/clean_segments.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "engine/error.h"
#include "engine/predicates.h"

namespace af2::geometry {

namespace {

bool before(Point2 p, Point2 q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

/// Whether `p`, which is neither end, lies on the segment rs.
bool liesOn(Point2 p, Point2 r, Point2 s) {
  if (orientation(r, s, p) != Turn::Straight) return false;
  const auto [low, high] = before(r, s) ? std::pair(r, s) : std::pair(s, r);
  return before(low, p) && before(p, high);
}

class Cleaner {
 public:
  explicit Cleaner(const PlanarDomain& domain) : domain_(domain) {}

  PlanarRegions clean() {
    mergePoints();
    takeSegments();
    findMeetings();
    split();
    return std::move(result_);
  }

 private:
  void mergePoints() {
    std::vector<int> order(domain_.points.size());
    std::iota(order.begin(), order.end(), 0);
    const auto at = [&](int i) { return domain_.points[static_cast<std::size_t>(i)]; };
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return before(at(a), at(b)); });
    std::vector<int> first(order.size());  // by point: the first in the file at the same position
    for (std::size_t i = 0; i < order.size(); ++i) {
      const auto point = static_cast<std::size_t>(order[i]);
      const bool same = i > 0 && at(order[i - 1]) == at(order[i]);
      first[point] = same ? first[static_cast<std::size_t>(order[i - 1])] : order[i];
    }
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (first[i] == static_cast<int>(i)) {
        index_.push_back(static_cast<int>(result_.points.size()));
        result_.points.push_back(domain_.points[i]);
      } else {
        index_.push_back(index_[static_cast<std::size_t>(first[i])]);
      }
    }
  }

  /// Each pair of points once, none that is one point twice.
  void takeSegments() {
    std::map<std::pair<int, int>, int> seen;
    for (std::size_t i = 0; i < domain_.segments.size(); ++i) {
      const int from = index_[static_cast<std::size_t>(domain_.segments[i].from)];
      const int to = index_[static_cast<std::size_t>(domain_.segments[i].to)];
      if (from == to || !seen.emplace(std::minmax(from, to), 0).second) continue;
      segments_.push_back({from, to, static_cast<int>(i)});
    }
    splits_.resize(segments_.size());
  }

  Point2 point(int i) const { return result_.points[static_cast<std::size_t>(i)]; }
  double low(std::size_t i) const {
    return std::min(point(segments_[i].from).x, point(segments_[i].to).x);
  }
  double high(std::size_t i) const {
    return std::max(point(segments_[i].from).x, point(segments_[i].to).x);
  }

  /// Sweeps over x; segments whose ranges of x do not overlap are not compared.
  void findMeetings() {
    std::vector<std::size_t> order(segments_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return low(a) < low(b); });
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t k = i + 1; k < order.size() && low(order[k]) <= high(order[i]); ++k)
        meet(order[i], order[k]);
  }

  void meet(std::size_t i, std::size_t k) {
    const PlanarPiece &s = segments_[i], &t = segments_[k];
    const Point2 a = point(s.from), b = point(s.to), c = point(t.from), d = point(t.to);
    if (std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) return;
    bool touching = s.from == t.from || s.from == t.to || s.to == t.from || s.to == t.to;
    for (const int v : {t.from, t.to})
      if (liesOn(point(v), a, b)) splits_[i].push_back(v), touching = true;
    for (const int v : {s.from, s.to})
      if (liesOn(point(v), c, d)) splits_[k].push_back(v), touching = true;
    if (!touching && segmentsMeet(a, b, c, d)) refuseCrossing(s, t);
  }

  [[noreturn]] void refuseCrossing(const PlanarPiece& s, const PlanarPiece& t) const {
    const int first = domain_.segments[static_cast<std::size_t>(s.segment)].line;
    const int second = domain_.segments[static_cast<std::size_t>(t.segment)].line;
    throw InputError(domain_.name + ":" + std::to_string(std::max(first, second)) +
                     ": this segment crosses the one in line " +
                     std::to_string(std::min(first, second)) +
                     "; put a vertex where they cross and split both there");
  }

  void split() {
    std::map<std::pair<int, int>, int> seen;  // pieces of segments that lie on each other
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const bool forward = before(point(segments_[i].from), point(segments_[i].to));
      std::vector<int>& at = splits_[i];
      std::sort(at.begin(), at.end(), [&](int p, int q) {
        return forward ? before(point(p), point(q)) : before(point(q), point(p));
      });
      at.erase(std::unique(at.begin(), at.end()), at.end());
      at.push_back(segments_[i].to);
      int from = segments_[i].from;
      for (const int to : at) {
        if (seen.emplace(std::minmax(from, to), 0).second)
          result_.pieces.push_back({from, to, segments_[i].segment});
        from = to;
      }
    }
  }

  const PlanarDomain& domain_;
  std::vector<int> index_;  // by point of the domain: its index in the result
  std::vector<PlanarPiece> segments_;
  std::vector<std::vector<int>> splits_;  // by segment: points inside it
  PlanarRegions result_;
};

}  // namespace

PlanarRegions cleanSegments(const PlanarDomain& domain) { return Cleaner(domain).clean(); }

}  // namespace af2::geometry
