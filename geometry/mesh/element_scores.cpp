#include "geometry/mesh/element_scores.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "engine/base/parallel.h"
#include "geometry/base/plane_axes.h"
#include "geometry/spool/spooled_mesh.h"

namespace af2::geometry {

namespace {

constexpr float kNoScore = std::numeric_limits<float>::quiet_NaN();

/// The corners of an element in its own plane, as seen from the side of its normal.
class Layout {
 public:
  Layout(const MeshSlice& mesh, const Element& element) : count_(element.size()) {
    std::array<Point3, 4> corners;
    for (int i = 0; i < count_; ++i) corners[index(i)] = mesh.position(element.corners[index(i)]);
    const Point3 normal = element.isQuad()
                              ? cross(corners[2] - corners[0], corners[3] - corners[1])
                              : cross(corners[1] - corners[0], corners[2] - corners[0]);
    isFlat_ = length(normal) > 0;
    if (!isFlat_) return;
    const PlaneAxes axes(corners[0], (1 / length(normal)) * normal);
    for (int i = 0; i < count_; ++i) points_[index(i)] = axes(corners[index(i)]);
  }

  bool isFlat() const { return isFlat_; }
  int count() const { return count_; }
  double firstSide() const { return distance(points_[0], points_[1]); }

  /// In chart units, beginning at a corner.
  std::array<Point2, 4> from(int first, double unit) const {
    std::array<Point2, 4> corners;
    for (int i = 0; i < count_; ++i)
      corners[index(i)] = (1 / unit) * points_[index((first + i) % count_)];
    return corners;
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  std::array<Point2, 4> points_;
  int count_;
  bool isFlat_ = false;
};

double meanWantedSize(const MeshSlice& mesh, const Element& element) {
  double sum = 0;
  for (const VertexId v : element.vertices()) sum += mesh.wantedSize(v);
  return sum / element.size();
}

bool hasSizes(const MeshSlice& mesh) {
  return !mesh.wantedSizes.empty() || !mesh.sharedSizes.empty();
}

float scoreOf(const MeshSlice& mesh, std::size_t e, const RuleSetDefinition& rules) {
  const Element& element = mesh.elements[e];
  const ElementOrigin& origin = mesh.origins[e];
  const Layout layout(mesh, element);
  if (!layout.isFlat()) return kNoScore;
  const bool isWanted = rules.unit == ChartUnit::WantedLength && hasSizes(mesh);
  const double unit = isWanted ? meanWantedSize(mesh, element) : layout.firstSide();
  if (!(unit > 0)) return kNoScore;
  float best = kNoScore;
  for (int first = 0; first < (origin.isChanged ? layout.count() : 1); ++first) {
    const auto corners = layout.from(first, unit);
    const auto badness =
        rules.metric->badnessAt(std::span(corners.data(), static_cast<std::size_t>(layout.count())),
                                std::max<int>(origin.level, 1));
    if (badness && !(best <= *badness)) best = static_cast<float>(*badness);
  }
  return best;
}

std::vector<float> sliceScores(const MeshSlice& slice, const RuleSetDefinition& rules,
                               int threads) {
  constexpr std::size_t kAtOnce = 4096;
  std::vector<float> scores(slice.elements.size());
  forEachInRanges(scores.size(), kAtOnce, threads,
                  [&](std::size_t e) { scores[e] = scoreOf(slice, e, rules); });
  return scores;
}

}  // namespace

std::vector<float> elementScores(const ModelMesh& mesh, const RuleSetDefinition& rules,
                                 int threads) {
  std::vector<float> scores;
  forEachSlice(mesh, [&](const MeshSlice& slice) {
    std::vector<float> own = sliceScores(slice, rules, threads);
    if (scores.empty())
      scores = std::move(own);
    else
      scores.insert(scores.end(), own.begin(), own.end());
  });
  return scores;
}

void scoreElements(ModelMesh& mesh, const RuleSetDefinition& rules, int threads) {
  if (!mesh.spooled) {
    mesh.scores = elementScores(mesh, rules, threads);
    return;
  }
  std::vector<SpooledPart> parts = mesh.spooled->parts();
  const SpooledMesh::Shared shared{mesh.vertices, mesh.wantedSizes};
  for (std::size_t i = 0; i < parts.size(); ++i)
    mesh.spooled->visitPart(i, shared, [&](const MeshSlice& slice) {
      parts[i].scores = std::make_shared<const SpooledFloats>(mesh.spooled->file(),
                                                              sliceScores(slice, rules, threads));
    });
  mesh.spooled = std::make_shared<const SpooledMesh>(std::move(parts), mesh.vertices.size(),
                                                     mesh.spooled->file());
}

}  // namespace af2::geometry
