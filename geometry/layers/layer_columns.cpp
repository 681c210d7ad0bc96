#include "geometry/layers/layer_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "engine/base/elementary.h"

namespace af2::geometry {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Beyond this, columns at a corner of the boundary share its room.
constexpr double kLeast = 15 * kDegree;
/// Between sides that enclose less than 30 degrees, layers become fewer.
constexpr double kSharpest = 150 * kDegree;
/// The boundary turns away by more than this around a fan.
constexpr double kFan = -60 * kDegree;
constexpr double kNarrowest = 22.5 * kDegree, kWidest = 60 * kDegree;  // sectors of a fan
/// Columns lean up to this many times as far from a corner as layers above it reach along its
/// sides; then segments on top of the layers are a third shorter there.
constexpr double kSpread = 3;
constexpr double kMostLean = 4;  // more than the tangent of half of kSharpest

class RunMaker {
 public:
  RunMaker(const FaceBoundary& boundary, const std::vector<std::vector<int>>& edges,
           const EdgeLayers& layers, const std::set<VertexId>& blocked, const SurfaceWalk& walk,
           LayerGrid& grid)
      : boundary_(boundary),
        edges_(edges),
        layers_(layers),
        blocked_(blocked),
        walk_(walk),
        grid_(grid) {}

  void add(const LayerRun& run) {
    run_ = run;
    tops_ = run.heights.tops();
    corners_.clear();
    const LoopView loop = view();
    const std::size_t count = run.segments + (run.isClosed ? 0 : 1);
    double along = 0;
    for (std::size_t c = 0; c < count; ++c) {
      corners_.push_back(cornerAt(c));
      corners_.back().along = along;
      along += loop.lengthOf(run.first + c);
    }
    length_ = along;
    grid_.runs.push_back({run, grid_.columns.size(), 0});
    for (std::size_t c = 0; c < count; ++c) addColumns(c);
    grid_.runs.back().count = grid_.columns.size() - grid_.runs.back().first;
    addCells();
  }

 private:
  enum class Kind { Plain, Leaning, Fan, End };
  struct Corner {
    Kind kind = Kind::Plain;
    double turn = 0;
    double along = 0;  ///< its distance from the start of the run
    double lean = 0;   ///< of its column along the run, for each unit of height
    bool endsOnBoundary = false;
  };
  /// What the boundary has beyond an end of the run.
  struct LevelsOnBoundary {
    std::size_t levels = 0;
    double share = 1;  ///< of the heights asked for
  };

  LoopView view() const { return LoopView(boundary_.input.loops[run_.loop]); }
  std::size_t inLoop(std::size_t c) const { return (run_.first + c) % view().size(); }
  bool isEnd(std::size_t c) const { return !run_.isClosed && (c == 0 || c == run_.segments); }

  Corner cornerAt(std::size_t c) const {
    const LoopView loop = view();
    Corner corner;
    if (length(loop.at(inLoop(c)).point.normal) == 0) return {Kind::End};
    corner.turn = loop.turnAt(inLoop(c));
    if (isEnd(c)) {
      corner.kind = Kind::End;
      corner.endsOnBoundary =
          mayEndOnBoundary(corner.turn) && levelsOnBoundary(c, corner.turn).levels > 0;
      if (corner.endsOnBoundary) corner.lean = -1 / tangent(corner.turn);
    } else if (corner.turn > kSharpest || blocked_.contains(loop.at(inLoop(c)).vertex)) {
      corner.kind = Kind::End;
    } else if (corner.turn > kLeast) {
      corner.kind = Kind::Leaning;
      corner.lean = tangent(corner.turn / 2);
    } else if (corner.turn < kFan) {
      corner.kind = Kind::Fan;
    }
    return corner;
  }

  /// The number of segments without layers beside an end of the run.
  std::size_t freeSegments(std::size_t c) const {
    const LoopView loop = view();
    std::size_t count = 0;
    for (; count < loop.size(); ++count) {
      const std::size_t segment =
          c == 0 ? inLoop(0) + 2 * loop.size() - 1 - count : inLoop(c) + count;
      if (layers_.contains(edges_[run_.loop][segment % loop.size()])) break;
    }
    return count;
  }

  /// The corner of the loop `steps` segments beyond an end of the run.
  std::size_t beyond(std::size_t c, std::size_t steps) const {
    const std::size_t size = view().size();
    return (c == 0 ? inLoop(0) + size - steps % size : inLoop(c) + steps) % size;
  }

  /// How many corners beyond an end are at the heights of layers, or at the same share of them.
  LevelsOnBoundary levelsOnBoundary(std::size_t c, double turn) const {
    constexpr double kNear = 0.1;  // of the height of a layer
    constexpr double kStraight = 20 * kDegree;
    const LoopView loop = view();
    const std::size_t most = std::max<std::size_t>(freeSegments(c), 1) - 1;
    double away = 0;
    LevelsOnBoundary found;
    for (std::size_t& levels = found.levels; levels < most && levels + 1 < tops_.size(); ++levels) {
      const std::size_t next = beyond(c, levels + 1);
      if (blocked_.contains(loop.at(next).vertex)) break;
      if (levels > 0 && std::abs(loop.turnAt(beyond(c, levels))) > kStraight) break;
      away += distance(loop.at(beyond(c, levels)).point.position, loop.at(next).point.position);
      const double height = away * sine(turn);
      if (levels == 0) found.share = shareOf(height / tops_[1], kNear);
      const double layer = tops_[levels + 1] - tops_[levels];
      if (std::abs(height - found.share * tops_[levels + 1]) > kNear * found.share * layer) break;
    }
    return found;
  }

  static double shareOf(double share, double near) {
    return share > 1 - near ? 1 : std::max(share, kThinnest);
  }

  /// How far columns lean along the run, away from the leaning corners before and behind.
  double leanAt(std::size_t c) const { return leanFrom(c, true) - leanFrom(c, false); }

  double leanFrom(std::size_t c, bool isBefore) const {
    const std::size_t count = corners_.size();
    double away = 0;
    for (std::size_t i = 1; i <= count; ++i) {
      if (!run_.isClosed && (isBefore ? i > c : c + i >= count)) return 0;
      const std::size_t other = (isBefore ? c + count - i : c + i) % count;
      const std::size_t next = (isBefore ? other + 1 : other + count - 1) % count;
      away += gapBetween(isBefore ? other : next, isBefore ? next : other);
      if (away > kSpread * kMostLean * tops_.back()) return 0;  // no column leans that far away
      if (corners_[other].kind == Kind::Plain) continue;
      const double reach = std::min(kSpread * tops_.back() * std::abs(corners_[other].lean),
                                    roomFrom(other, isBefore));
      return reach > 0 ? corners_[other].lean * std::max(0.0, 1 - away / reach) : 0;
    }
    return 0;
  }

  double gapBetween(std::size_t from, std::size_t to) const {
    return (to > from ? corners_[to].along : length_) - corners_[from].along;
  }

  /// The distance from a corner to the next one that is not plain, or to half of the way there if
  /// columns lean away from that, too.
  double roomFrom(std::size_t c, bool isForward) const {
    const std::size_t count = corners_.size();
    double room = 0;
    for (std::size_t i = 1; i <= count; ++i) {
      if (!run_.isClosed && (isForward ? c + i >= count : i > c)) break;
      const std::size_t other = (isForward ? c + i : c + count - i) % count;
      const std::size_t next = (isForward ? other + count - 1 : other + 1) % count;
      room += gapBetween(isForward ? next : other, isForward ? other : next);
      if (corners_[other].kind != Kind::Plain) return corners_[other].lean != 0 ? room / 2 : room;
    }
    return room;
  }

  void addColumns(std::size_t c) {
    const Corner& corner = corners_[c];
    if (corner.kind == Kind::End && !corner.endsOnBoundary) {
      grid_.columns.push_back(begun(c));
    } else if (corner.kind == Kind::End) {
      addOnBoundary(c);
    } else if (corner.kind == Kind::Fan) {
      addFan(c);
    } else {
      addColumn(c, middleRay(c));
    }
  }

  LayerColumn begun(std::size_t c) const {
    LayerColumn column;
    column.loop = run_.loop;
    column.corner = inLoop(c);
    column.points.push_back(view().at(inLoop(c)).point);
    return column;
  }

  void addOnBoundary(std::size_t c) {
    LayerColumn column = begun(c);
    const LoopView loop = view();
    column.corners.push_back(inLoop(c));
    const LevelsOnBoundary found = levelsOnBoundary(c, corners_[c].turn);
    column.levels = found.levels;
    column.share = found.share;
    for (std::size_t k = 1; k <= column.levels; ++k) {
      column.corners.push_back(beyond(c, k));
      column.points.push_back(loop.at(beyond(c, k)).point);
    }
    grid_.columns.push_back(std::move(column));
  }

  /// For each unit of height; equally high above both segments at the corner.
  Point3 middleRay(std::size_t c) const {
    const LoopView loop = view();
    const Point3& normal = loop.at(inLoop(c)).point.normal;
    const Point3 in = loop.directionIn(inLoop(c)), out = loop.directionOut(inLoop(c));
    const Point3 leftOfIn = cross(normal, in), leftOfOut = cross(normal, out);
    const Point3 middle = (1 / (1 + dot(in, out))) * (leftOfIn + leftOfOut);
    return corners_[c].kind == Kind::Leaning ? middle : middle + leanAt(c) * unit(in + out);
  }

  void addColumn(std::size_t c, const Point3& ray, int fan = -1) {
    LayerColumn column = begun(c);
    column.direction = unit(ray);
    for (std::size_t k = 1; k < tops_.size(); ++k)
      column.distances.push_back(length(ray) * tops_[k]);
    column.levels = column.distances.size();
    column.fan = fan;
    placePoints(column, walk_);
    grid_.columns.push_back(std::move(column));
  }

  /// With an even number of sectors, about as wide on top as the segments beside the corner.
  void addFan(std::size_t c) {
    const LoopView loop = view();
    const Point3& normal = loop.at(inLoop(c)).point.normal;
    const Point3 in = loop.directionIn(inLoop(c)), left = cross(normal, in);
    const double turn = -corners_[c].turn;
    const std::size_t corner = inLoop(c);
    const double beside = (loop.lengthOf(loop.before(corner)) + loop.lengthOf(corner)) / 2;
    const double angle = std::clamp(beside / tops_.back(), kNarrowest, kWidest);
    const int sectors = 2 * static_cast<int>(std::ceil(turn / (2 * angle)));
    const int fan = fans_++;
    for (int k = 0; k <= sectors; ++k) {
      const double at = turn * k / sectors;
      addColumn(c, cosine(at) * left + sine(at) * in, fan);
    }
  }

  void addCells() {
    const RunColumns& own = grid_.runs.back();
    for (std::size_t i = 0; i + 1 < own.count; ++i)
      grid_.cells.push_back({own.first + i, own.first + i + 1});
    if (own.run.isClosed) grid_.cells.push_back({own.first + own.count - 1, own.first});
  }

  const FaceBoundary& boundary_;
  const std::vector<std::vector<int>>& edges_;
  const EdgeLayers& layers_;
  const std::set<VertexId>& blocked_;
  const SurfaceWalk& walk_;
  LayerGrid& grid_;
  LayerRun run_;
  std::vector<double> tops_;
  std::vector<Corner> corners_;
  double length_ = 0;  // of the run
  int fans_ = 0;
};

/// Layers that end on the same part of the boundary, from both sides, leave a segment between them.
void partEnds(const FaceBoundary& boundary, LayerGrid& grid) {
  for (std::size_t r = 0; r < grid.runs.size(); ++r) {
    const RunColumns& run = grid.runs[r];
    std::size_t next = r + 1;
    if (next == grid.runs.size() || grid.runs[next].run.loop != run.run.loop)
      for (next = r; next > 0 && grid.runs[next - 1].run.loop == run.run.loop;) --next;
    if (run.run.isClosed) continue;
    LayerColumn &one = grid.columns[run.first + run.count - 1],
                &other = grid.columns[grid.runs[next].first];
    const std::size_t size = boundary.input.loops[run.run.loop].size();
    const std::size_t between = (other.corner + size - one.corner) % size;
    while (one.levels > 0 && one.levels + other.levels + 1 > between)
      --(one.levels > other.levels || other.levels == 0 ? one : other).levels;
  }
}

}  // namespace

void placePoints(LayerColumn& column, const SurfaceWalk& walk) {
  std::vector<double> distances = column.distances;
  for (double& d : distances) d *= column.share;
  column.points.resize(1);
  for (const SurfacePoint& p : walk.along(column.points[0], column.direction, distances))
    column.points.push_back(p);
  column.levels = std::min(column.levels, column.points.size() - 1);
}

LayerGrid layerGrid(const FaceBoundary& boundary, const EdgeLayers& layers,
                    const std::vector<std::vector<int>>& edges, const std::set<VertexId>& blocked,
                    const SurfaceWalk& walk) {
  LayerGrid grid;
  RunMaker maker(boundary, edges, layers, blocked, walk, grid);
  for (const LayerRun& run : layerRuns(boundary, layers, edges)) maker.add(run);
  partEnds(boundary, grid);
  return grid;
}

}  // namespace af2::geometry
