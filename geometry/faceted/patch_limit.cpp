#include "geometry/faceted/patch_limit.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>

#include "engine/base/constants.h"

namespace af2::geometry {
namespace {

std::vector<double> limitsAtVertices(const Facets& facets, const std::vector<PatchFace>& faces,
                                     const DomainSize& size, double growth) {
  std::vector<double> limits(facets.vertices.size(), std::numeric_limits<double>::infinity());
  for (const PatchFace& face : faces)
    face.surface.forEachCurvature([&](std::uint32_t v, double curvature) {
      const double radius = curvature > 0 ? 1 / curvature : 1e300;
      limits[v] = std::min(limits[v], size.turnLimit(radius, kMinAtPatchTurns));
    });
  // By vertex, in one list: those at the other ends of its edges.
  std::vector<std::size_t> first(facets.vertices.size() + 1, 0);
  for (const auto& t : facets.triangles)
    for (const std::uint32_t v : t) first[v + 1] += 2;
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> beside(first.back());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (const auto& t : facets.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      beside[next[t[i]]++] = t[(i + 1) % 3];
      beside[next[t[i]]++] = t[(i + 2) % 3];
    }
  using Entry = std::pair<double, std::uint32_t>;
  std::vector<Entry> entries;
  for (std::uint32_t v = 0; v < limits.size(); ++v) entries.emplace_back(limits[v], v);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open({}, std::move(entries));
  while (!open.empty()) {
    const auto [limit, v] = open.top();
    open.pop();
    if (limit > limits[v]) continue;
    for (std::size_t i = first[v]; i < first[v + 1]; ++i) {
      const std::uint32_t w = beside[i];
      const double grown = limit + growth * distance(facets.vertices[v], facets.vertices[w]);
      if (!(grown < limits[w])) continue;
      limits[w] = grown;
      open.push({grown, w});
    }
  }
  return limits;
}

class PatchLimit final : public CurvatureLimit {
 public:
  PatchLimit(FacetSurface surface, std::shared_ptr<const std::vector<double>> limits, double growth)
      : surface_(std::move(surface)), limits_(std::move(limits)), growth_(growth) {}

  std::optional<std::vector<double>> numbers() const override {
    std::vector<double> numbers;
    surface_.forEachCurvature([&](std::uint32_t v, double) { numbers.push_back((*limits_)[v]); });
    return numbers;
  }

  double sizeAt(const SurfacePoint& point) const override {
    return surface_.interpolated(*limits_, point.position);
  }

  double expectedElements(double size) const override {
    double sum = 0;
    surface_.forEachTriangle([&](const auto& corners, const auto& positions) {
      double here = 0;
      for (const std::uint32_t v : corners) here += std::min(size, (*limits_)[v]) / 3;
      const Point3 p = positions[1] - positions[0], q = positions[2] - positions[0];
      sum += length(cross(p, q)) / 2 / (kUnitTriangle * here * here);
    });
    return sum;
  }

  /// Along the edges of the triangles, where the limit is too coarse for the curvature.
  std::vector<SizeSource> sizesToFollow() const override {
    constexpr double kTurn = 1.2;        // radians along an element
    constexpr double kCoarse = 1.5;      // times as large as that
    constexpr std::size_t kMax = 20000;  // places
    std::vector<double> wanted(limits_->size(), std::numeric_limits<double>::infinity());
    surface_.forEachCurvature([&](std::uint32_t v, double curvature) {
      if (curvature > 0 && kCoarse * kTurn < curvature * (*limits_)[v])
        wanted[v] = kTurn / curvature;
    });
    std::vector<SizeSource> places;
    surface_.forEachTriangle([&](const auto& corners, const auto& positions) {
      for (std::size_t i = 0; i < 3 && places.size() < kMax; ++i) {
        const double size = std::max(wanted[corners[i]], wanted[corners[(i + 1) % 3]]);
        if (!(size < std::numeric_limits<double>::infinity())) continue;
        addAlong(positions[i], positions[(i + 1) % 3], size, places);
      }
    });
    return places.size() < kMax ? places : std::vector<SizeSource>();
  }

 private:
  /// The places are so near to each other that sizes grow by half between two of them.
  void addAlong(const Point3& from, const Point3& to, double size,
                std::vector<SizeSource>& places) const {
    const double step = size / growth_;
    const auto steps = std::min(std::ceil(distance(from, to) / step), 1e6);
    for (double i = 0; i < steps; ++i) places.push_back({from + (i / steps) * (to - from), size});
  }

  FacetSurface surface_;
  std::shared_ptr<const std::vector<double>> limits_;  // by vertex of the facets
  double growth_;
};

}  // namespace

CurvatureLimits limitsOfPatches(const Facets& facets, const std::vector<PatchFace>& faces,
                                const std::vector<std::vector<std::uint32_t>>& knots,
                                const DomainSize& size, double growth) {
  const auto limits =
      std::make_shared<const std::vector<double>>(limitsAtVertices(facets, faces, size, growth));
  CurvatureLimits found;
  for (const auto& [surface, isPlane] : faces)
    found.ofFaces.push_back(isPlane ? nullptr
                                    : std::make_shared<const PatchLimit>(surface, limits, growth));
  for (const std::vector<std::uint32_t>& vertices : knots) {
    std::vector<double>& at = found.atKnots.emplace_back();
    for (const std::uint32_t v : vertices) at.push_back((*limits)[v]);
  }
  return found;
}

}  // namespace af2::geometry
