#include "geometry/layers/layer_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/base/box_tree.h"

namespace af2::geometry {
namespace {

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
  Limiter(const FaceBoundary& boundary, LayerGrid& grid) : boundary_(boundary), grid_(grid) {}

  void limit() {
    for (const LayerCell& cell : grid_.cells) limitByShape(cell);
    smooth();
    if (crowding() > kMostCrowding) {
      giveUp();
      return;
    }
    isChanged_.assign(grid_.columns.size(), true);
    while (limitByCrossings()) smooth();
  }

 private:
  const LayerColumn& column(std::size_t i) const { return grid_.columns[i]; }

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
  void limitByShape(const LayerCell& cell) {
    LayerColumn &left = grid_.columns[cell.left], &right = grid_.columns[cell.right];
    const std::size_t most = std::min(left.levels, right.levels);
    for (std::size_t k = 1; k <= most; ++k) {
      if (isSound(left, right, k)) continue;
      left.levels = std::min(left.levels, k - 1);
      right.levels = std::min(right.levels, k - 1);
      return;
    }
  }

  static bool isSound(const LayerColumn& left, const LayerColumn& right, std::size_t k) {
    constexpr double kLeastSine = 0.2, kLeastOnTop = 0.25;
    const Point3 &a = left.points[k - 1].position, &b = right.points[k - 1].position,
                 &c = right.points[k].position, &d = left.points[k].position;
    const Point3 normal = unit(left.points[k].normal + right.points[k].normal);
    const bool isFan = left.fan >= 0 && left.fan == right.fan;
    const double base = distance(left.points[0].position, right.points[0].position);
    if (!isFan && distance(c, d) < kLeastOnTop * base) return false;
    const auto isOpen = [&](const Point3& p, const Point3& q, const Point3& r) {
      return dot(cross(unit(q - p), unit(r - p)), normal) > kLeastSine;
    };
    if (a == b) return isOpen(a, c, d);
    return isOpen(a, b, d) && isOpen(b, c, a) && isOpen(c, d, b) && isOpen(d, a, c);
  }

  void smooth() {
    for (bool isChanged = true; isChanged;) {
      isChanged = false;
      const auto lower = [&](std::size_t i, std::size_t most) {
        if (column(i).levels <= most) return;
        grid_.columns[i].levels = most;
        isChanged = true;
        if (!isChanged_.empty()) isChanged_[i] = true;
      };
      const auto fit = [&](const LayerCell& cell) {
        const bool isFan = column(cell.left).fan >= 0 &&
                           column(cell.left).fan == column(cell.right).fan &&
                           column(cell.left).corner == column(cell.right).corner;
        const std::size_t step = isFan ? 0 : 1;
        lower(cell.left, column(cell.right).levels + step);
        lower(cell.right, column(cell.left).levels + step);
      };
      for (const LayerCell& cell : grid_.cells) fit(cell);
      for (auto cell = grid_.cells.rbegin(); cell != grid_.cells.rend(); ++cell) fit(*cell);
    }
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
        for (const Line* line : {&lines[i], &lines[k]})
          for (const std::size_t c : line->columns)
            if (c != Line::kNone) isAny = isHit[c] = true;
      });
    }
    bool isLower = false;
    isChanged_.assign(isHit.size(), false);
    for (std::size_t c = 0; c < isHit.size(); ++c) {
      if (!isHit[c] || column(c).levels == 0) continue;
      --grid_.columns[c].levels;
      isChanged_[c] = isLower = true;
    }
    return isAny && isLower;
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
  LayerGrid& grid_;
  static constexpr double kMostCrowding = 2e6;
  static constexpr std::size_t kMostCompared = 100'000'000;  // pairs of lines
  std::size_t compared_ = 0;
  std::vector<bool> isChanged_;  // by column: since the last comparison; empty: before the first
};

}  // namespace

void limitLayers(const FaceBoundary& boundary, LayerGrid& grid) { Limiter(boundary, grid).limit(); }

}  // namespace af2::geometry
