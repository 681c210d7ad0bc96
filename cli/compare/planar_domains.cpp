#include "cli/compare/planar_domains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/planar/in2d_file.h"

namespace af2::cli {
namespace {

using geometry::PlanarCurves;
constexpr double kTurn = 2 * std::numbers::pi;

Point2 onCircle(Point2 centre, double radius, double angle) {
  return centre + radius * Point2{std::cos(angle), std::sin(angle)};
}

/// Curves with the region on their left.
class DomainMaker {
 public:
  int point(Point2 p) {
    curves_.points.push_back(p);
    return static_cast<int>(curves_.points.size()) - 1;
  }
  void line(int from, int to) { add(from, to); }
  /// An arc of less than half a turn around `centre`.
  void arc(int from, int to, Point2 centre, double radius, double begin, double end) {
    const double half = (end - begin) / 2;
    add(from, to).control = point(onCircle(centre, radius / std::cos(half), begin + half));
  }
  /// A spline that goes through its first and last pole.
  void spline(int from, int to, std::vector<Point2> poles) {
    PlanarCurves::Curve& curve = add(from, to);
    curve.poles = std::move(poles);
    curve.order = 4;
  }
  /// Counter-clockwise, or clockwise for a hole; in four arcs.
  void circle(Point2 centre, double radius, bool isHole) {
    const double turn = isHole ? -kTurn / 4 : kTurn / 4;
    std::vector<int> ends;
    for (int i = 0; i < 4; ++i) ends.push_back(point(onCircle(centre, radius, i * turn)));
    for (int i = 0; i < 4; ++i)
      arc(ends[static_cast<std::size_t>(i)], ends[static_cast<std::size_t>((i + 1) % 4)], centre,
          radius, i * turn, (i + 1) * turn);
  }
  void polygon(const std::vector<Point2>& corners) {
    const int first = static_cast<int>(curves_.points.size());
    for (const Point2 corner : corners) point(corner);
    const int count = static_cast<int>(corners.size());
    for (int i = 0; i < count; ++i) line(first + i, first + (i + 1) % count);
  }
  geometry::PlanarDomain domain() const { return geometry::domainOf(curves_); }

 private:
  PlanarCurves::Curve& add(int from, int to) {
    PlanarCurves::Curve curve;
    curve.from = from;
    curve.to = to;
    curve.left = 1;
    return curves_.curves.emplace_back(curve);
  }
  PlanarCurves curves_;
};

const std::vector<Point2> kUnitSquare{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

geometry::PlanarDomain polygonDomain(const std::vector<Point2>& corners) {
  DomainMaker maker;
  maker.polygon(corners);
  return maker.domain();
}

geometry::PlanarDomain squareWithHole() {
  DomainMaker maker;
  maker.polygon(kUnitSquare);
  maker.circle({0.5, 0.5}, 0.2, true);
  return maker.domain();
}

/// Twelve teeth with straight flanks, and a bore.
geometry::PlanarDomain gear() {
  constexpr int kTeeth = 12;
  constexpr double kRoot = 0.38, kTip = 0.5, kPitch = kTurn / kTeeth;
  DomainMaker maker;
  std::vector<int> ends;  // four for each tooth
  for (int tooth = 0; tooth < kTeeth; ++tooth)
    for (const auto& [part, radius] :
         {std::pair{0.0, kRoot}, {0.34, kRoot}, {0.46, kTip}, {0.88, kTip}})
      ends.push_back(maker.point(onCircle({0, 0}, radius, (tooth + part) * kPitch)));
  for (int tooth = 0; tooth < kTeeth; ++tooth) {
    const auto at = [&](int i) {
      return ends[static_cast<std::size_t>(4 * tooth + i) % ends.size()];
    };
    maker.arc(at(0), at(1), {0, 0}, kRoot, tooth * kPitch, (tooth + 0.34) * kPitch);
    maker.line(at(1), at(2));
    maker.arc(at(2), at(3), {0, 0}, kTip, (tooth + 0.46) * kPitch, (tooth + 0.88) * kPitch);
    maker.line(at(3), at(4));
  }
  maker.circle({0, 0}, 0.12, true);
  return maker.domain();
}

geometry::PlanarDomain disc(bool hasHole) {
  DomainMaker maker;
  maker.circle({0, 0}, 0.5, false);
  if (hasHole) maker.circle({0.18, 0}, 0.2, true);
  return maker.domain();
}

/// A symmetric profile of four digits with a closed trailing edge, 12 % thick, in a box.
geometry::PlanarDomain airfoil() {
  const auto thickness = [](double x) {
    return 0.6 * (0.2969 * std::sqrt(x) - x * (0.1260 + x * (0.3516 - x * (0.2843 - x * 0.1036))));
  };
  constexpr double kChord = 0.6;
  std::vector<Point2> lower, upper;  // from the nose to the tail; along the tail to the nose
  for (int i = 0; i <= 12; ++i) {
    const double x = (1 - std::cos(std::numbers::pi * i / 12)) / 2;
    const double y = i == 0 || i == 12 ? 0 : thickness(x);
    upper.push_back({kChord * (x - 0.5), kChord * y});
    lower.push_back({kChord * (x - 0.5), -kChord * y});
  }
  // At the nose, both sides are vertical.
  upper.insert(upper.begin() + 1, {upper[0].x, kChord * 0.015});
  lower.insert(lower.begin() + 1, {lower[0].x, -kChord * 0.015});
  DomainMaker maker;
  maker.polygon({{-0.7, -0.4}, {0.7, -0.4}, {0.7, 0.4}, {-0.7, 0.4}});
  const int nose = maker.point(upper.front()), tail = maker.point(upper.back());
  maker.spline(nose, tail, upper);
  maker.spline(tail, nose, {lower.rbegin(), lower.rend()});
  return maker.domain();
}

/// Random numbers in [0, 1), the same on every machine. Source: [Steele14], splitmix64.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u) {}
  double unit() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ z >> 31) >> 11) * 0x1p-53;
  }
  double between(double low, double high) { return low + (high - low) * unit(); }

 private:
  std::uint64_t state_;
};

/// A smooth loop: a circle with waves of two to four periods.
class Blob {
 public:
  Blob(Random& random, Point2 centre, double radius, double wave)
      : centre_(centre), radius_(radius) {
    for (Wave& w : waves_) w = {random.between(0, wave), random.between(0, kTurn)};
  }
  Point2 at(double part) const {
    double radius = 1;
    for (std::size_t k = 0; k < waves_.size(); ++k)
      radius +=
          waves_[k].height * std::cos(static_cast<double>(k + 2) * kTurn * part + waves_[k].phase);
    return onCircle(centre_, radius_ * radius, kTurn * part);
  }

 private:
  struct Wave {
    double height = 0, phase = 0;
  };
  Point2 centre_;
  double radius_;
  std::array<Wave, 3> waves_{};
};

/// Adds a loop of segments to a domain.
void addLoop(const Blob& blob, double size, bool isUneven, Random& random,
             geometry::PlanarDomain& domain) {
  constexpr int kSamples = 2000;
  std::vector<double> lengths{0};
  for (int i = 1; i <= kSamples; ++i)
    lengths.push_back(lengths.back() +
                      distance(blob.at(double(i - 1) / kSamples), blob.at(double(i) / kSamples)));
  const int count = 2 * std::max(3, static_cast<int>(std::lround(lengths.back() / size / 2)));
  std::vector<double> ends{0};
  for (int i = 0; i < count; ++i)
    ends.push_back(ends.back() + (isUneven ? std::exp2(random.between(-0.5, 0.5)) : 1));
  const int first = static_cast<int>(domain.points.size());
  std::size_t sample = 0;
  for (int i = 0; i < count; ++i) {
    const double wanted = ends[static_cast<std::size_t>(i)] / ends.back() * lengths.back();
    while (sample + 1 < lengths.size() - 1 && lengths[sample + 1] <= wanted) ++sample;
    const double rest = (wanted - lengths[sample]) / (lengths[sample + 1] - lengths[sample]);
    domain.points.push_back(blob.at((static_cast<double>(sample) + rest) / kSamples));
    geometry::PlanarDomain::Segment segment;
    segment.from = first + i;
    segment.to = first + (i + 1) % count;
    segment.edge = static_cast<int>(domain.segments.size()) + 1;
    domain.segments.push_back(segment);
  }
}

}  // namespace

std::vector<NamedDomain> namedDomains() {
  const auto fromCorner = [](const Point3& p, double size) {
    return std::min(size, 0.1 * size + 0.06 * std::hypot(p.x, p.y));
  };
  const auto across = [](const Point3& p, double size) { return size * (0.4 + 1.2 * p.x); };
  return {{"square with hole", squareWithHole()},
          {"gear", gear()},
          {"disc", disc(false)},
          {"eccentric ring", disc(true)},
          {"airfoil", airfoil()},
          {"L-shape", polygonDomain({{0, 0}, {1, 0}, {1, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 1}})},
          {"rectangle", polygonDomain({{0, 0}, {1, 0}, {1, 0.6}, {0, 0.6}})},
          {"graded square", polygonDomain(kUnitSquare), fromCorner},
          {"square graded across", polygonDomain(kUnitSquare), across},
          {"square with hole, graded across", squareWithHole(), across}};
}

geometry::PlanarDomain randomDomain(std::uint64_t seed, double size) {
  Random random(seed);
  geometry::PlanarDomain domain;
  const bool isUneven = seed / 4 % 2 != 0;
  addLoop(Blob(random, {0, 0}, 0.6, 0.1), size, isUneven, random, domain);
  const auto holes = static_cast<int>(seed % 4);
  const double turn = random.unit();
  for (int i = 0; i < holes; ++i) {
    const double angle = kTurn * (turn + (i + random.between(-0.05, 0.05)) / holes);
    const Point2 centre = onCircle({0, 0}, random.between(0.2, 0.25), angle);
    addLoop(Blob(random, centre, random.between(0.07, 0.11), 0.08), size, isUneven, random, domain);
    domain.holes.push_back(centre);
  }
  return domain;
}

}  // namespace af2::cli
