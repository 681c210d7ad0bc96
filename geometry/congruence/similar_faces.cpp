#include "geometry/congruence/similar_faces.h"

#include <algorithm>
#include <tuple>

namespace af2::geometry {
namespace {

/// Of the area: integrals along a boundary are exact to about ten digits.
constexpr double kSameArea = 1e-7;

bool areSimilar(const FaceNumbers& one, const FaceNumbers& other) {
  return one.area > 0 && other.area - one.area <= kSameArea * other.area &&
         one.surfaceType == other.surfaceType && one.segments == other.segments;
}

}  // namespace

std::vector<std::vector<std::size_t>> similarFaces(std::vector<FaceNumbers> faces) {
  std::ranges::sort(faces, {}, [](const FaceNumbers& face) {
    return std::tie(face.surfaceType, face.segments, face.area, face.face);
  });
  std::vector<std::vector<std::size_t>> groups;
  for (auto first = faces.begin(); first != faces.end();) {
    const auto end = std::find_if(
        first + 1, faces.end(), [&](const FaceNumbers& face) { return !areSimilar(*first, face); });
    std::vector<std::size_t>& group = groups.emplace_back();
    for (; first != end; ++first) group.push_back(first->face);
    std::ranges::sort(group);
  }
  std::ranges::sort(groups, {}, [](const auto& group) { return group.front(); });
  return groups;
}

}  // namespace af2::geometry
