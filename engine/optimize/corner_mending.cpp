#include "engine/optimize/corner_mending.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/base/eight_directions.h"
#include "engine/base/error.h"
#include "engine/mesh/element_measures.h"
#include "engine/mesh/element_shape.h"
#include "engine/step/neighborhood.h"

namespace af2 {
namespace {

constexpr double kGoodJacobian = 0.9;
constexpr int kMaxSweeps = 12;
/// In lengths of the shortest edge at the vertex: the first step of a search, and the last one.
constexpr double kFirstStep = 0.2, kLastStep = 0.01;
/// Smaller gains are not worth a move.
constexpr double kLeastGain = 1e-3;
/// How much the two sides of a corner may differ for the sake of its angle, as `unevenness`: 1.25
/// is a ratio of 2. Where they differ more already, they stay as they are.
constexpr double kMostUneven = 1.25;

/// Arithmetic by geometric mean of the squared lengths of the sides of a corner: 1 if both are
/// equal.
double unevenness(Point2 ahead, Point2 behind) {
  const double ee = dot(ahead, ahead), ff = dot(behind, behind);
  return ee > 0 && ff > 0 ? (ee + ff) / (2 * std::sqrt(ee * ff)) : INFINITY;
}

class CornerMender {
 public:
  CornerMender(const MeshTopology& topology, Mesh& mesh, const AF2LocalTransformMaker& maker,
               ActRecorder* recorder)
      : topology_(topology), mesh_(mesh), maker_(maker), recorder_(recorder) {}

  std::size_t run(const WorkWatch& watch) {
    std::vector<VertexId> visited = verticesOfPoorQuads();
    std::size_t moves = 0;
    for (int sweep = 0; sweep < kMaxSweeps && !visited.empty(); ++sweep) {
      std::vector<VertexId> next;
      for (const VertexId v : visited) {
        if (watch.mustStop()) return moves;
        if (!mend(v)) continue;
        ++moves;
        topology_.forEachCornerOf(v, [&](Corner c) { addInner(c.element(), next); });
      }
      visited = sorted(std::move(next));
    }
    return moves;
  }

 private:
  /// An element around the vertex, in the chart. The vertex is one of its corners.
  struct Around {
    std::array<Point2, 4> corners;
    std::size_t count = 0, own = 0;
  };

  static std::vector<VertexId> sorted(std::vector<VertexId> vertices) {
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }

  void addInner(std::size_t element, std::vector<VertexId>& vertices) const {
    for (const VertexId v : mesh_.elements[element].vertices())
      if (!topology_.isFixed(v)) vertices.push_back(v);
  }

  std::vector<VertexId> verticesOfPoorQuads() const {
    std::vector<VertexId> vertices;
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e)
      if (!topology_.isDead(e) && isPoorQuad(mesh_.elements[e])) addInner(e, vertices);
    return sorted(std::move(vertices));
  }

  bool isPoorQuad(const Element& element) const {
    if (!element.isQuad()) return false;
    const auto at = [&](std::size_t i) {
      return mesh_.vertices[element.corners[i % 4].value].position;
    };
    for (std::size_t i = 0; i < 4; ++i) {
      const Point3 ahead = at(i + 1) - at(i), behind = at(i + 3) - at(i);
      const Point3 turned = cross(ahead, behind);
      if (dot(turned, turned) <
          kGoodJacobian * kGoodJacobian * dot(ahead, ahead) * dot(behind, behind))
        return true;
    }
    return false;
  }

  bool mend(VertexId v) {
    const Corner first = topology_.cornerOf(v);
    if (first.isNone()) return false;
    const SurfacePoint here = mesh_.vertices[v.value];
    const SurfacePoint& neighbor = mesh_.vertices[topology_.vertexAt(topology_.next(first)).value];
    const double unit = distance(here.position, neighbor.position);
    if (!(unit > 0)) return false;
    try {
      const StepChart chart(maker_.makeLocalTransformIn(slot_, here, neighbor, unit), unit);
      if (!look(chart, v)) return false;
      const Point2 place = bestPlace();
      if (place == Point2{}) return false;
      const auto lifted = chart.lift(place);
      return lifted && put(v, *lifted);
    } catch (const GeometryError&) {
      return false;  // there is no chart at this vertex: it does not move
    }
  }

  /// Returns false if an element is hidden, or if all are good.
  bool look(const StepChart& chart, VertexId v) {
    around_.clear();
    star_.clear();
    shortest_ = INFINITY;
    bool isSeen = true;
    topology_.forEachCornerOf(v, [&](Corner c) {
      star_.push_back(c);
      const auto corners = mesh_.elements[c.element()].vertices();
      Around& element = around_.emplace_back();
      element.count = corners.size();
      for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners[i] == v) element.own = i;
        const ChartPoint point = chart.project(mesh_.vertices[corners[i].value]);
        isSeen = isSeen && point.view != ChartView::Hidden;
        element.corners[i] = corners[i] == v ? Point2{} : point.position;
      }
      const Point2 next = element.corners[(element.own + 1) % element.count];
      shortest_ = std::min(shortest_, length(next));
    });
    return isSeen && leastAt({}) < kGoodJacobian;
  }

  double leastAt(Point2 place) {
    double least = 1;
    for (Around& element : around_) {
      element.corners[element.own] = place;
      least = std::min(least, scaledJacobian({element.corners.data(), element.count}));
    }
    return least;
  }

  /// The most uneven corner around the vertex, as it was moved last.
  double mostUneven() const {
    double most = 1;
    for (const Around& element : around_)
      for (std::size_t i = 0; i < element.count; ++i) {
        const Point2 corner = element.corners[i];
        most = std::max(
            most, unevenness(element.corners[(i + 1) % element.count] - corner,
                             element.corners[(i + element.count - 1) % element.count] - corner));
      }
    return most;
  }

  /// Where the smallest scaled Jacobian is larger, found by steps in eight directions; the origin
  /// if there is nothing to gain.
  Point2 bestPlace() {
    const double before = leastAt({}), mostAllowed = std::max(kMostUneven, mostUneven());
    double best = before;
    Point2 place;
    for (double step = kFirstStep * shortest_; step >= kLastStep * shortest_;) {
      Point2 better = place;
      for (const Point2& direction : kEightDirections)
        if (const double least = leastAt(place + step * direction);
            least > best && mostUneven() <= mostAllowed) {
          best = least;
          better = place + step * direction;
        }
      if (better == place) step *= 0.5;
      place = better;
    }
    return best >= before + kLeastGain ? place : Point2{};
  }

  /// Moves the vertex unless an element would lean more against the surface than all did before.
  bool put(VertexId v, const SurfacePoint& point) {
    const SurfacePoint before = mesh_.vertices[v.value];
    if (recorder_) recorder_->begin(star_, v);
    mesh_.vertices[v.value] = point;
    const bool isSound = std::ranges::none_of(
        star_, [&](Corner c) { return leans(mesh_, mesh_.elements[c.element()]); });
    if (!isSound) mesh_.vertices[v.value] = before;
    if (recorder_ && isSound) recorder_->end(FinishAct::Kind::Move);
    return isSound;
  }

  const MeshTopology& topology_;
  Mesh& mesh_;
  const AF2LocalTransformMaker& maker_;
  ActRecorder* recorder_;
  ChartSlot slot_;
  std::vector<Corner> star_;
  std::vector<Around> around_;
  double shortest_ = 0;
};

}  // namespace

std::size_t mendCorners(const MeshTopology& topology, Mesh& mesh,
                        const AF2LocalTransformMaker& maker, ActRecorder* recorder,
                        const WorkWatch& watch) {
  return CornerMender(topology, mesh, maker, recorder).run(watch);
}

}  // namespace af2
