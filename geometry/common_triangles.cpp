#include "geometry/common_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace af2::geometry {

namespace {

/// A triangle between three vertices of the boundary.
struct Corner {
  std::array<std::uint32_t, 3> points;  ///< ascending
  std::size_t face = 0, element = 0;
};

/// Two triangles beside each other, and those that the other diagonal makes of them.
struct Swap {
  std::size_t face = 0, first = 0, second = 0;
  std::array<VertexId, 3> newFirst, newSecond;
  double angle = 0;  ///< the least of the new ones
};

class Parting {
 public:
  Parting(const DividedEdges& divided, std::vector<FaceMesh>& meshes)
      : divided_(divided), meshes_(meshes) {}

  void part() {
    std::vector<Corner> corners;
    for (std::size_t i = 0; i < meshes_.size(); ++i) addCorners(i, corners);
    std::ranges::sort(corners, {},
                      [](const Corner& c) { return std::tuple(c.points, c.face, c.element); });
    for (std::size_t i = 0; i + 1 < corners.size(); ++i)
      if (corners[i].points == corners[i + 1].points) partTwo(corners[i], corners[i + 1]);
  }

 private:
  void addCorners(std::size_t face, std::vector<Corner>& corners) const {
    const FaceMesh& mesh = meshes_[face];
    if (!mesh.middles.empty()) return;
    for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
      const auto c = mesh.elements[k].vertices();
      if (c.size() != 3) continue;
      if (std::ranges::any_of(c, [&](VertexId v) { return v.value >= mesh.boundary.size(); }))
        continue;
      std::array<std::uint32_t, 3> points{mesh.boundary[c[0].value], mesh.boundary[c[1].value],
                                          mesh.boundary[c[2].value]};
      std::ranges::sort(points);
      corners.push_back({points, face, k});
    }
  }

  void partTwo(const Corner& one, const Corner& other) {
    const std::optional<Swap> first = bestSwap(one), second = bestSwap(other);
    if (!first && !second) return;
    const Swap& best = !second || (first && first->angle >= second->angle) ? *first : *second;
    FaceMesh& mesh = meshes_[best.face];
    const auto set = [&](std::size_t element, const std::array<VertexId, 3>& corners) {
      for (std::size_t i = 0; i < 3; ++i) mesh.elements[element].corners[i] = corners[i];
    };
    set(best.first, best.newFirst);
    set(best.second, best.newSecond);
  }

  /// Nothing if no other diagonal is possible.
  std::optional<Swap> bestSwap(const Corner& corner) const {
    constexpr double kLeastAngle = 0.02;  // radians
    const FaceMesh& mesh = meshes_[corner.face];
    const auto own = mesh.elements[corner.element].vertices();
    std::optional<Swap> best;
    for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
      const auto c = mesh.elements[k].vertices();
      if (k == corner.element || c.size() != 3) continue;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
          if (own[i] != c[(j + 1) % 3] || own[(i + 1) % 3] != c[j]) continue;
          const VertexId a = own[i], b = own[(i + 1) % 3], tip = own[(i + 2) % 3];
          const VertexId beyond = c[(j + 2) % 3];
          Swap swap{corner.face, corner.element, k, {a, beyond, tip}, {beyond, b, tip}, 0};
          swap.angle = leastAngle(mesh, swap, {a, b, tip});
          if (swap.angle < kLeastAngle || areJoined(mesh, tip, beyond)) continue;
          if (!best || swap.angle > best->angle) best = swap;
        }
    }
    return best;
  }

  Point3 at(const FaceMesh& mesh, VertexId v) const {
    return v.value < mesh.boundary.size() ? divided_.points[mesh.boundary[v.value]]
                                          : mesh.inside[v.value - mesh.boundary.size()];
  }

  Point3 normalOf(const FaceMesh& mesh, const std::array<VertexId, 3>& c) const {
    const Point3 origin = at(mesh, c[0]);
    return cross(at(mesh, c[1]) - origin, at(mesh, c[2]) - origin);
  }

  /// Of both new triangles; 0 if one of them folds over.
  double leastAngle(const FaceMesh& mesh, const Swap& swap,
                    const std::array<VertexId, 3>& before) const {
    const Point3 normal = normalOf(mesh, before);
    double least = 4;
    for (const auto& corners : {swap.newFirst, swap.newSecond}) {
      if (!(dot(normalOf(mesh, corners), normal) > 0)) return 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const Point3 a = at(mesh, corners[(i + 1) % 3]) - at(mesh, corners[i]);
        const Point3 b = at(mesh, corners[(i + 2) % 3]) - at(mesh, corners[i]);
        least = std::min(least, std::atan2(length(cross(a, b)), dot(a, b)));
      }
    }
    return least;
  }

  static bool areJoined(const FaceMesh& mesh, VertexId one, VertexId other) {
    return std::ranges::any_of(mesh.elements, [&](const Element& element) {
      const auto c = element.vertices();
      return std::ranges::count(c, one) > 0 && std::ranges::count(c, other) > 0;
    });
  }

  const DividedEdges& divided_;
  std::vector<FaceMesh>& meshes_;
};

}  // namespace

void partCommonTriangles(const DividedEdges& divided, std::vector<FaceMesh>& meshes) {
  Parting(divided, meshes).part();
}

}  // namespace af2::geometry
