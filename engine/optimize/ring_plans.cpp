#include "engine/optimize/ring_plans.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "engine/base/elementary.h"
#include "engine/optimize/ring_outline.h"

namespace af2 {
namespace {

class Planner {
 public:
  Planner(const Ring& ring, int mostIrregular)
      : ring_(ring), count_(ring.points.size()), most_(mostIrregular) {
    double length = 0;
    for (std::size_t i = 0; i < count_; ++i)
      length += distance(ring.points[i], ring.points[(i + 1) % count_]);
    unit_ = length / static_cast<double>(count_);
  }

  /// With few changes of the corners first.
  std::vector<FillingPlan> plans() {
    if (withoutCut(ring_.corners, 0)) return std::move(found_);
    if (most_ >= 2) withCuts();
    for (std::size_t i = 0; i < count_ && most_ >= 1; ++i) {
      if (!ring_.mayChange[i]) continue;
      const std::vector<std::size_t> once = toggled(ring_.corners, i);
      withoutCut(once, 1);
      for (std::size_t j = i + 1; j < count_ && most_ >= 2; ++j)
        if (ring_.mayChange[j]) withoutCut(toggled(once, j), 2);
    }
    std::ranges::stable_sort(found_, {}, [](const FillingPlan& plan) {
      return std::tuple(plan.irregular, plan.badness);
    });
    return std::move(found_);
  }

 private:
  static std::vector<std::size_t> toggled(std::vector<std::size_t> corners, std::size_t place) {
    const auto at = std::ranges::lower_bound(corners, place);
    if (at != corners.end() && *at == place)
      corners.erase(at);
    else
      corners.insert(at, place);
    return corners;
  }

  bool withoutCut(const std::vector<std::size_t>& corners, int changes) {
    if (corners.size() < 3 || corners.size() > 5) return false;
    const Outline outline = RingSides(count_, corners).whole();
    FillingPlan plan;
    if (corners.size() == 4) {
      if (!isGrid(outline)) return false;
      plan.badness = badnessOfGrid(outline);
    } else {
      const auto lines = starLines(outline);
      if (!lines) return false;
      plan.badness = badnessOfStar(plan, outline, *lines);
    }
    plan.irregular = changes + (corners.size() == 4 ? 0 : 1);
    if (plan.irregular > most_) return false;
    plan.corners = corners;
    found_.push_back(std::move(plan));
    return true;
  }

  static bool makesStar(std::size_t corners) { return corners == 3 || corners == 5; }

  void withCuts() {
    const std::size_t k = ring_.corners.size();
    if (k != 2 && k != 4 && k != 6) return;
    for (std::size_t from = 0; from < k; ++from)
      for (std::size_t to = from + 1; to < k; ++to)
        if (makesStar(to - from + 2) && makesStar(k - (to - from) + 2)) cutBetween(from, to);
  }

  void cutBetween(std::size_t from, std::size_t to) {
    const RingSides sides(count_, ring_.corners);
    FillingPlan plan;
    plan.irregular = 2;
    plan.corners = ring_.corners;
    FillingPlan::Cut& cut = plan.cut.emplace();
    cut.from = from;
    cut.to = to;
    for (cut.fromAt = 1; cut.fromAt < sides.lengthOf(from); ++cut.fromAt)
      for (cut.toAt = 1; cut.toAt < sides.lengthOf(to); ++cut.toAt) {
        const auto [least, most] = lengthsOf(cut, sides);
        for (cut.length = least; cut.length <= most; cut.length += 2) consider(plan, sides);
      }
  }

  /// The least and the largest length of the cut; those between differ by an even number.
  std::pair<int, int> lengthsOf(const FillingPlan::Cut& cut, const RingSides& sides) const {
    const int after = sides.lengthOf(cut.from) - cut.fromAt,
              behind = sides.lengthOf(cut.to) - cut.toAt;
    if (cut.to - cut.from == 1) return {std::abs(after - cut.toAt) + 2, after + cut.toAt - 2};
    if (sides.count() - (cut.to - cut.from) == 1)
      return {std::abs(behind - cut.fromAt) + 2, behind + cut.fromAt - 2};
    int around = after + cut.toAt;
    for (std::size_t i = cut.from + 1; i < cut.to; ++i) around += sides.lengthOf(i);
    return {around % 2 == 0 ? 2 : 1, around};
  }

  void consider(FillingPlan& plan, const RingSides& sides) {
    const auto parts = sides.partsOf(*plan.cut);
    const auto one = starLines(parts[0]), other = starLines(parts[1]);
    if (!one || !other) return;
    plan.badness =
        badnessOf(cutPoint(plan, 0), cutPoint(plan, plan.cut->length), plan.cut->length) +
        badnessOfStar(plan, parts[0], *one) + badnessOfStar(plan, parts[1], *other);
    found_.push_back(plan);
  }

  Point2 cutPoint(const FillingPlan& plan, int at) const {
    const RingSides sides(count_, plan.corners);
    const FillingPlan::Cut& cut = *plan.cut;
    const Point2 from = ring_.points[sides.placeAt(cut.from, cut.fromAt)];
    const Point2 to = ring_.points[sides.placeAt(cut.to, cut.toAt)];
    return from + (1.0 * at / cut.length) * (to - from);
  }

  Point2 pointOf(const FillingPlan& plan, const Stretch& side, int at) const {
    switch (side.line) {
      case Stretch::Line::Cut:
        return cutPoint(plan, at);
      case Stretch::Line::CutBackwards:
        return cutPoint(plan, plan.cut->length - at);
      case Stretch::Line::Ring:
        break;
    }
    return ring_.points[(side.begin + static_cast<std::size_t>(at)) % count_];
  }

  double badnessOfStar(const FillingPlan& plan, const Outline& part, const StarLines& lines) const {
    const std::size_t k = part.size();
    std::array<Point2, Outline::kMaxSides> ends;
    Point2 centre;
    for (std::size_t i = 0; i < k; ++i) {
      ends[i] = pointOf(plan, part[i], lines[(i + k - 1) % k]);
      centre = centre + (1.0 / static_cast<double>(k)) * ends[i];
    }
    double badness = 0;
    for (std::size_t i = 0; i < k; ++i) badness += badnessOf(centre, ends[i], lines[i]);
    return badness;
  }

  /// Of the two lines through the middle.
  double badnessOfGrid(const Outline& outline) const {
    double badness = 0;
    for (const std::size_t i : {0, 1}) {
      const int at = outline[i].length / 2, length = outline[i + 1].length;
      const Point2 from = pointOf({}, outline[i], at),
                   to = pointOf({}, outline[i + 2], outline[i].length - at);
      badness += badnessOf(from, to, length);
    }
    return badness;
  }

  double badnessOf(Point2 from, Point2 to, int edges) const {
    constexpr double kShortest = 1e-3;
    const double off = logarithm(std::max(distance(from, to) / (edges * unit_), kShortest));
    return edges * off * off;
  }

  const Ring& ring_;
  std::size_t count_;
  int most_;
  double unit_;  ///< mean length of an edge of the ring
  std::vector<FillingPlan> found_;
};

}  // namespace

std::vector<FillingPlan> fillingPlans(const Ring& ring, int mostIrregular, std::size_t most) {
  constexpr std::size_t kMostCorners = 6;
  if (ring.corners.size() > kMostCorners || mostIrregular < 0) return {};
  std::vector<FillingPlan> plans = Planner(ring, mostIrregular).plans();
  if (plans.size() > most) plans.resize(most);
  return plans;
}

}  // namespace af2
