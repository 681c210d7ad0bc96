#include "geometry/congruence/congruence.h"

#include <cmath>
#include <utility>

namespace af2::geometry {
namespace {

using Loop = std::vector<BoundaryCorner>;

/// Of the extent of a boundary. Files give coordinates with 15 digits or so.
constexpr double kSamePlace = 1e-9;
/// Between unit normals. Those of curved surfaces are known less well than places.
constexpr double kSameNormal = 1e-6;
/// Of the extent: three corners that are nearer to a line do not tell how a boundary is turned.
constexpr double kFlat = 1e-4;

const Point3& at(const Loop& loop, std::size_t k) { return loop[k % loop.size()].point.position; }

std::optional<BoundaryForm::Corners> cornersOf(const Loop& loop) {
  const auto farthest = [&](const auto& distanceAt) {
    std::pair<std::size_t, double> found{0, 0};
    for (std::size_t k = 0; k < loop.size(); ++k)
      if (const double d = distanceAt(at(loop, k)); d > found.second) found = {k, d};
    return found;
  };
  const Point3& first = at(loop, 0);
  const auto [second, extent] = farthest([&](const Point3& p) { return distance(p, first); });
  const Point3 along = unit(at(loop, second) - first);
  const auto [third, height] =
      farthest([&](const Point3& p) { return length(cross(along, p - first)); });
  if (!(height > kFlat * extent)) return std::nullopt;
  return BoundaryForm::Corners{0, second, third, extent};
}

/// Tries to match the corners of two boundaries.
class Matching {
 public:
  Matching(const BoundaryForm& one, const BoundaryForm& other, bool isReflection)
      : one_(one),
        other_(other),
        isReflection_(isReflection),
        tolerance_(kSamePlace * one.corners->extent) {}

  /// With the first corner at the corner `shift` of a loop.
  std::optional<Congruence> with(std::size_t loop, std::size_t shift) const {
    if (!haveSameLengths(loop, shift)) return std::nullopt;
    const Loop &from = one_.input.loops.front(), &to = other_.input.loops[loop];
    const auto& [first, second, third, extent] = *one_.corners;
    const Frame own = Frame::at(at(from, first), at(from, second), at(from, third));
    const auto image = [&](std::size_t k) { return at(to, imageOf(k, shift, to.size())); };
    const Frame others = Frame::at(image(first), image(second), image(third));
    Congruence found{Motion(own, isReflection_ ? others.reflected() : others), isReflection_,
                     tolerance_, std::vector<VertexId>(one_.input.vertexCount)};
    if (!matches(0, loop, shift, found) || !matchOtherLoops(loop, found)) return std::nullopt;
    return found;
  }

 private:
  /// The corner of a loop at which the k-th one lies if the first one lies at `shift`.
  std::size_t imageOf(std::size_t k, std::size_t shift, std::size_t size) const {
    return (isReflection_ ? shift + size - k : shift + k) % size;
  }

  bool haveSameLengths(std::size_t loop, std::size_t shift) const {
    const auto &own = one_.lengths.front(), &others = other_.lengths[loop];
    for (std::size_t k = 0; k < own.size(); ++k) {
      const std::size_t segment = imageOf(isReflection_ ? k + 1 : k, shift, own.size());
      if (std::abs(own[k] - others[segment]) > 2 * tolerance_) return false;
    }
    return true;
  }

  bool isMoved(const SurfacePoint& from, const SurfacePoint& to, const Motion& motion) const {
    return distance(motion.moved(from.position), to.position) <= tolerance_ &&
           distance(motion.turned(from.normal), to.normal) <= kSameNormal;
  }

  /// Whether the motion moves a loop onto one of the other boundary. Notes its vertices.
  bool matches(std::size_t from, std::size_t to, std::size_t shift, Congruence& found) const {
    const Loop &own = one_.input.loops[from], &others = other_.input.loops[to];
    const auto image = [&](std::size_t k) -> const BoundaryCorner& {
      return others[imageOf(k, shift, others.size())];
    };
    for (std::size_t k = 0; k < own.size(); ++k)
      if (!isMoved(own[k].point, image(k).point, found.motion)) return false;
    for (std::size_t k = 0; k < own.size(); ++k) {
      VertexId& vertex = found.vertices[own[k].vertex.value];
      if (!vertex.isNone() && vertex != image(k).vertex) return false;
      vertex = image(k).vertex;
    }
    return true;
  }

  bool matchOtherLoops(std::size_t used, Congruence& found) const {
    std::vector<bool> isUsed(other_.input.loops.size(), false);
    isUsed[used] = true;
    for (std::size_t i = 1; i < one_.input.loops.size(); ++i) {
      const auto loop = findLoop(i, isUsed, found);
      if (!loop) return false;
      isUsed[*loop] = true;
    }
    return true;
  }

  std::optional<std::size_t> findLoop(std::size_t from, const std::vector<bool>& isUsed,
                                      Congruence& found) const {
    const Loop& own = one_.input.loops[from];
    const Point3 place = found.motion.moved(at(own, 0));
    for (std::size_t loop = 0; loop < isUsed.size(); ++loop) {
      const Loop& others = other_.input.loops[loop];
      if (isUsed[loop] || others.size() != own.size()) continue;
      for (std::size_t shift = 0; shift < others.size(); ++shift)
        if (distance(place, at(others, shift)) <= tolerance_ && matches(from, loop, shift, found))
          return loop;
    }
    return std::nullopt;
  }

  const BoundaryForm &one_, &other_;
  bool isReflection_;
  double tolerance_;
};

}  // namespace

BoundaryForm formOf(FrontInput input) {
  BoundaryForm form{std::move(input), {}, {}};
  for (const Loop& loop : form.input.loops) {
    std::vector<double>& lengths = form.lengths.emplace_back();
    for (std::size_t k = 0; k < loop.size(); ++k)
      lengths.push_back(distance(at(loop, k), at(loop, k + 1)));
  }
  if (!form.input.loops.empty()) form.corners = cornersOf(form.input.loops.front());
  return form;
}

std::optional<Congruence> congruenceOf(const BoundaryForm& one, const BoundaryForm& other) {
  const FrontInput &own = one.input, &others = other.input;
  if (!one.corners || own.loops.size() != others.loops.size() ||
      own.vertexCount != others.vertexCount || !own.isolated.empty() || !others.isolated.empty())
    return std::nullopt;
  for (const bool isReflection : {false, true}) {
    const Matching matching(one, other, isReflection);
    for (std::size_t loop = 0; loop < others.loops.size(); ++loop) {
      if (others.loops[loop].size() != own.loops.front().size()) continue;
      for (std::size_t shift = 0; shift < others.loops[loop].size(); ++shift)
        if (auto found = matching.with(loop, shift)) return found;
    }
  }
  return std::nullopt;
}

}  // namespace af2::geometry
