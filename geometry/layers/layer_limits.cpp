#include "geometry/layers/layer_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <utility>

#include "geometry/base/box_tree.h"

namespace af2::geometry {
namespace {

/// By which a column becomes lower at a time, and how steep the tops of layers may become where
/// columns differ.
constexpr double kStep = 0.9, kSlope = 0.25;

/// Share of its height by which a stack of layers stays away from others and from the boundary.
constexpr double kGap = 0.25;

/// A segment of the arrangement of layers and boundary.
struct Line {
  Point3 from, to;
  Point3 normal;  ///< of the surface, of any length
  /// What it belongs to: columns, and corners of the boundary, by loop. Lines with one in common do
  /// not count as crossing.
  std::array<std::size_t, 2> columns{kNone, kNone};
  std::array<VertexId, 2> vertices{};
  static constexpr std::size_t kNone = ~std::size_t{0};

  bool isBoundary() const { return columns[0] == kNone; }
};

/// Whether two lines cross or touch, seen along the normal of the surface, on the same sheet of it.
bool doCross(const Line& a, const Line& b) {
  constexpr double kSameSide = 0.3, kSheet = 0.5;
  constexpr double kTouching = 1e-9;  // where columns are opposite each other, ends are on lines
  if (dot(unit(a.normal), unit(b.normal)) < kSameSide) return false;
  const Point3 normal = unit(unit(a.normal) + unit(b.normal));
  const Point3 along = a.to - a.from, other = b.to - b.from, between = b.from - a.from;
  const double area = dot(cross(along, other), normal);
  if (area == 0) return false;
  const double s = dot(cross(between, other), normal) / area;
  const double t = dot(cross(between, along), normal) / area;
  const auto isOn = [](double share) { return share > -kTouching && share < 1 + kTouching; };
  if (!isOn(s) || !isOn(t)) return false;
  const double height = std::abs(dot(between + t * other - s * along, normal));
  return height < kSheet * std::max(length(along), length(other));
}

class Limiter {
 public:
  Limiter(const FaceBoundary& boundary, const SurfaceWalk& walk, LayerGrid& grid)
      : boundary_(boundary), walk_(walk), grid_(grid) {}

  void limit() {
    isChanged_.assign(grid_.columns.size(), false);
    settle();
    if (crowding() > kMostCrowding) {
      giveUp();
      return;
    }
    isChanged_.assign(grid_.columns.size(), true);
    while (limitByCrossings()) settle();
  }

 private:
  const LayerColumn& column(std::size_t i) const { return grid_.columns[i]; }

  bool isFixed(std::size_t i) const { return column(i).distances.empty(); }
  bool mayBeThinner(std::size_t i) const {
    return !isFixed(i) && column(i).share * kStep >= kThinnest;
  }
  void makeThinner(std::size_t i, double share) {
    grid_.columns[i].share = share;
    placePoints(grid_.columns[i], walk_);
    isChanged_[i] = true;
  }
  void makeFewer(std::size_t i, std::size_t levels) {
    if (column(i).levels <= levels) return;
    grid_.columns[i].levels = levels;
    isChanged_[i] = true;
  }
  bool isFan(const LayerCell& cell) const {
    const LayerColumn &left = column(cell.left), &right = column(cell.right);
    return left.fan >= 0 && left.fan == right.fan && left.corner == right.corner;
  }

  /// Until nothing becomes lower any more.
  void settle() {
    for (bool isLower = true; isLower;) {
      isLower = false;
      for (const LayerCell& cell : grid_.cells) isLower |= limitByShape(cell);
      isLower |= smooth();
    }
  }

  /// About how many segments of the boundary are as near to a column as it is high, for all
  /// columns.
  double crowding() const {
    double sum = 0;
    for (const LayerCell& cell : grid_.cells) {
      const LayerColumn& left = column(cell.left);
      const Point3& base = left.points[0].position;
      const double segment = distance(base, column(cell.right).points[0].position);
      if (segment > 0) sum += distance(base, left.points[left.levels].position) / segment;
    }
    return sum;
  }

  /// No quadrilateral of a cell has an angle far from that of a rectangle, or is far narrower on
  /// top than the segment below.
  bool limitByShape(const LayerCell& cell) {
    const LayerColumn &left = column(cell.left), &right = column(cell.right);
    for (std::size_t k = 1; k <= std::min(left.levels, right.levels); ++k) {
      if (isSound(cell, k)) continue;
      lower({cell.left, cell.right}, k - 1);
      return true;
    }
    return false;
  }

  /// Makes those columns thinner that may be, or else all of them end below a level.
  void lower(std::initializer_list<std::size_t> columns, std::size_t levels) {
    if (std::ranges::any_of(columns, [&](std::size_t i) { return mayBeThinner(i); })) {
      for (const std::size_t i : columns)
        if (mayBeThinner(i)) makeThinner(i, kStep * column(i).share);
    } else {
      for (const std::size_t i : columns) makeFewer(i, levels);
    }
  }

  bool isSound(const LayerCell& cell, std::size_t k) const {
    const LayerColumn &left = column(cell.left), &right = column(cell.right);
    constexpr double kLeastSine = 0.2, kLeastOnTop = 0.25;
    const Point3 &a = left.points[k - 1].position, &b = right.points[k - 1].position,
                 &c = right.points[k].position, &d = left.points[k].position;
    const Point3 normal = unit(left.points[k].normal + right.points[k].normal);
    const double base = distance(left.points[0].position, right.points[0].position);
    if (!isFan(cell) && distance(c, d) < kLeastOnTop * base) return false;
    const auto isOpen = [&](const Point3& p, const Point3& q, const Point3& r) {
      return dot(cross(unit(q - p), unit(r - p)), normal) > kLeastSine;
    };
    if (a == b) return isOpen(a, c, d);
    return isOpen(a, b, d) && isOpen(b, c, a) && isOpen(c, d, b) && isOpen(d, a, c);
  }

  /// Whether a column became lower.
  bool smooth() {
    bool isAny = false;
    for (bool isLower = true; isLower; isAny |= isLower) {
      isLower = false;
      for (const LayerCell& cell : grid_.cells) isLower |= fit(cell);
      for (auto cell = grid_.cells.rbegin(); cell != grid_.cells.rend(); ++cell)
        isLower |= fit(*cell);
    }
    return isAny;
  }

  bool fit(const LayerCell& cell) {
    const std::size_t step = isFan(cell) ? 0 : 1;
    const bool isLower = fitTo(cell.left, cell.right, step);
    return fitTo(cell.right, cell.left, step) || isLower;
  }

  /// Makes a column at most so high that it fits to the next one.
  bool fitTo(std::size_t i, std::size_t next, std::size_t step) {
    constexpr double kLeastChange = 1e-3;
    const LayerColumn &own = column(i), &other = column(next);
    const std::size_t levels = own.levels;
    makeFewer(i, other.levels + step);
    const std::size_t common = std::min(own.levels, other.levels);
    if (common == 0 || isFixed(i)) return own.levels < levels;
    const double width = distance(own.points[0].position, other.points[0].position);
    const double most = other.share + kSlope * width / own.distances[common - 1];
    if (own.share <= most + kLeastChange) return own.levels < levels;
    makeThinner(i, most);
    return true;
  }

  /// The top of a column, a little higher than it is.
  Point3 raisedTop(const LayerColumn& of) const {
    const Point3 &base = of.points[0].position, &top = of.points[of.levels].position;
    return of.corners.empty() ? top + kGap * (top - base) : top;
  }

  bool limitByCrossings() {
    const std::vector<Line> lines = allLines();
    std::vector<Box3> boxes;
    for (const Line& line : lines) boxes.push_back(boxOf(line));
    const BoxTree tree(boxes);
    std::vector<bool> isHit(grid_.columns.size(), false);
    bool isAny = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (!isNew(lines[i])) continue;
      if (compared_ > kMostCompared) return giveUp();
      tree.forEachIn(boxes[i], [&](std::uint32_t k) {
        ++compared_;
        if (areBeside(lines[i], lines[k]) || !doCross(lines[i], lines[k])) return;
        markThoseToLower(lines[i], lines[k], isHit);
        isAny = true;
      });
    }
    bool isLower = false;
    isChanged_.assign(isHit.size(), false);
    for (std::size_t c = 0; c < isHit.size(); ++c) {
      if (!isHit[c] || column(c).levels == 0) continue;
      lower({c}, column(c).levels - 1);
      isLower = true;
    }
    return isAny && isLower;
  }

  /// Of the columns of two lines that cross, those that may be thinner, or else all.
  void markThoseToLower(const Line& a, const Line& b, std::vector<bool>& isHit) const {
    std::array<std::size_t, 4> columns{a.columns[0], a.columns[1], b.columns[0], b.columns[1]};
    const auto end = std::remove(columns.begin(), columns.end(), Line::kNone);
    const bool isAnyThinner =
        std::any_of(columns.begin(), end, [&](std::size_t c) { return mayBeThinner(c); });
    for (auto c = columns.begin(); c != end; ++c)
      if (!isAnyThinner || mayBeThinner(*c)) isHit[*c] = true;
  }

  /// Layers are far higher than segments are long, and cross everywhere, as where retries divide a
  /// boundary that crosses itself: none of them is worth the time.
  bool giveUp() {
    for (LayerColumn& of : grid_.columns) of.levels = 0;
    return false;
  }

  /// Lines of columns that stayed as they were have been compared before.
  bool isNew(const Line& line) const {
    return std::ranges::any_of(line.columns,
                               [&](std::size_t c) { return c != Line::kNone && isChanged_[c]; });
  }

  /// Lines cross on a curved surface although they pass each other at some distance.
  static Box3 boxOf(const Line& line) {
    constexpr double kSag = 0.25;
    const double slack = kSag * distance(line.from, line.to);
    Box3 box;
    box.add(line.from);
    box.add(line.to);
    box.low = box.low - Point3{slack, slack, slack};
    box.high = box.high + Point3{slack, slack, slack};
    return box;
  }

  static bool areBeside(const Line& a, const Line& b) {
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t k = 0; k < 2; ++k)
        if ((a.columns[i] != Line::kNone && a.columns[i] == b.columns[k]) ||
            (!a.vertices[i].isNone() && a.vertices[i] == b.vertices[k]))
          return true;
    return false;
  }

  VertexId baseOf(const LayerColumn& of) const {
    return boundary_.input.loops[of.loop][of.corner].vertex;
  }

  std::vector<Line> allLines() const {
    std::vector<Line> lines;
    for (std::size_t i = 0; i < grid_.columns.size(); ++i) {
      const LayerColumn& of = column(i);
      if (of.levels == 0 || !of.corners.empty()) continue;
      lines.push_back({of.points[0].position,
                       raisedTop(of),
                       of.points[of.levels].normal,
                       {i, Line::kNone},
                       {baseOf(of), VertexId()}});
    }
    for (const LayerCell& cell : grid_.cells) {
      const LayerColumn &left = column(cell.left), &right = column(cell.right);
      if (left.levels + right.levels == 0) continue;
      lines.push_back({raisedTop(left),
                       raisedTop(right),
                       left.points[left.levels].normal + right.points[right.levels].normal,
                       {cell.left, cell.right},
                       {topOnBoundary(left), topOnBoundary(right)}});
    }
    for (const auto& loop : boundary_.input.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const BoundaryCorner &from = loop[i], &to = loop[(i + 1) % loop.size()];
        lines.push_back({from.point.position,
                         to.point.position,
                         from.point.normal + to.point.normal,
                         {Line::kNone, Line::kNone},
                         {from.vertex, to.vertex}});
      }
    return lines;
  }

  /// The vertex of the boundary at the top of a column, if there is one.
  VertexId topOnBoundary(const LayerColumn& of) const {
    if (!of.corners.empty()) return boundary_.input.loops[of.loop][of.corners[of.levels]].vertex;
    return of.levels == 0 ? baseOf(of) : VertexId();
  }

  const FaceBoundary& boundary_;
  const SurfaceWalk& walk_;
  LayerGrid& grid_;
  static constexpr double kMostCrowding = 2e6;
  static constexpr std::size_t kMostCompared = 100'000'000;  // pairs of lines
  std::size_t compared_ = 0;
  std::vector<bool> isChanged_;  // by column: since the last comparison
};

}  // namespace

void limitLayers(const FaceBoundary& boundary, const SurfaceWalk& walk, LayerGrid& grid) {
  Limiter(boundary, walk, grid).limit();
}

}  // namespace af2::geometry
