#include "geometry/mesh/inside_out.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "engine/base/parallel.h"

namespace af2::geometry {

namespace {

bool isWhole(const ModelMesh& mesh) {
  const auto isComplete = [](const FaceReport& face) {
    return face.status == FaceStatus::Complete;
  };
  const auto isShared = [](const EdgeSegment& segment) { return segment.uses == 2; };
  return elementCount(mesh) > 0 && !mesh.segments.empty() && mesh.findings.empty() &&
         std::ranges::all_of(mesh.faces, isComplete) &&
         std::ranges::all_of(mesh.segments, isShared);
}

/// Whether each side between faces is there in both directions. Inside faces that is so anyway.
bool isTurnedAlike(const ModelMesh& mesh) {
  std::vector<std::uint8_t> isOnEdge(mesh.vertices.size(), 0);
  for (const EdgeSegment& segment : mesh.segments)
    isOnEdge[segment.from.value] = isOnEdge[segment.to.value] = 1;
  std::vector<std::pair<VertexId, VertexId>> sides, reversed;
  const auto add = [&](VertexId from, VertexId to) {
    for (const VertexId v : {from, to})
      if (v.value >= isOnEdge.size() || !isOnEdge[v.value]) return;
    sides.emplace_back(from, to);
    reversed.emplace_back(to, from);
  };
  forEachSlice(mesh, [&](const MeshSlice& slice) {
    for (const Element& element : slice.elements) {
      const auto& [a, b, c, d] = element.corners;
      add(a, b);
      add(b, c);
      add(c, d.isNone() ? a : d);
      if (!d.isNone()) add(d, a);
    }
  });
  std::ranges::sort(sides);
  std::ranges::sort(reversed);
  return sides == reversed;
}

/// Of the pyramid, or two tetrahedra, between an element and a point.
double sixfoldVolume(const MeshSlice& slice, const Element& element, const Point3& apex) {
  const auto& [a, b, c, d] = element.corners;
  const auto at = [&](VertexId v) { return slice.position(v) - apex; };
  const Point3 first = at(a), third = at(c);
  double volume = dot(first, cross(at(b), third));
  if (!d.isNone()) volume += dot(first, cross(third, at(d)));
  return volume;
}

/// Positive if the elements are counter-clockwise seen from outside.
double volumeOf(const ModelMesh& mesh) {
  constexpr std::size_t kAtOnce = 1 << 15;
  std::optional<Point3> origin;  // a corner of the first element
  double sum = 0;
  forEachSlice(mesh, [&](const MeshSlice& slice) {
    if (slice.elements.empty()) return;
    if (!origin) origin = slice.position(slice.elements.front().corners.front());
    const Ranges ranges(slice.elements.size(), kAtOnce);
    takeInOrder(
        ranges.count(), 0,
        [&](std::size_t range) {
          double part = 0;
          for (const std::size_t i : ranges[range])
            part += sixfoldVolume(slice, slice.elements[i], *origin);
          return part;
        },
        [&](double part) { sum += part; });
  });
  return sum / 6;
}

}  // namespace

std::optional<double> enclosedVolumeIf(const ModelMesh& mesh,
                                       const std::function<bool(double)>& matters) {
  if (!isWhole(mesh)) return std::nullopt;
  const double volume = volumeOf(mesh);
  return matters(volume) && isTurnedAlike(mesh) ? std::optional(volume) : std::nullopt;
}

std::optional<double> enclosedVolume(const ModelMesh& mesh) {
  return enclosedVolumeIf(mesh, [](double) { return true; });
}

bool isInsideOut(const ModelMesh& mesh) {
  return enclosedVolumeIf(mesh, [](double volume) { return volume < 0; }).has_value();
}

}  // namespace af2::geometry
