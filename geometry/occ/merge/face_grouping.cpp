#include "geometry/occ/merge/face_grouping.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "engine/base/elementary.h"
#include "geometry/base/constants.h"
#include "geometry/base/disjoint_sets.h"

namespace af2::geometry {

namespace {

/// Elements that reach over an edge with a larger angle would fold.
constexpr double kMaxFold = 100 * kDegree;

class Grouping {
 public:
  explicit Grouping(const GroupingInput& input)
      : in_(input), sets_(input.areas.size()), isNarrow_(input.areas.size(), false) {}

  FaceGrouping make() {
    for (std::size_t e = 0; e < in_.joints.size(); ++e)
      if (isSmooth(e)) sets_.join(one(e), other(e));
    joinNarrow();
    FaceGrouping grouping{{}, {}, {}, isNarrow_, facesAlone()};
    for (std::uint32_t f = 0; f < in_.areas.size(); ++f)
      grouping.group.push_back(grouping.isAlone[f] ? f : sets_.of(f));
    for (std::size_t e = 0; e < in_.joints.size(); ++e) {
      const bool isBeside = crossed_.contains(e);
      const bool isSeam = in_.joints[e].isSeam();
      grouping.isBesideNarrow.push_back(isBeside);
      grouping.isInner.push_back(isBeside ||
                                 (isSmooth(e) && (isSeam || !grouping.isAlone[one(e)])));
    }
    return grouping;
  }

 private:
  std::uint32_t one(std::size_t e) const {
    return static_cast<std::uint32_t>(in_.joints[e].one) - 1;
  }
  std::uint32_t other(std::size_t e) const {
    return static_cast<std::uint32_t>(in_.joints[e].other) - 1;
  }

  bool mayCross(std::size_t e) const {
    return in_.joints[e].isJoint() && !in_.isKept[e] && in_.mayMerge[one(e)] &&
           in_.mayMerge[other(e)] && in_.part[one(e)] == in_.part[other(e)] &&
           in_.sizes[one(e)] == in_.sizes[other(e)] && in_.chords[one(e)] == in_.chords[other(e)];
  }
  /// A rounding that is too tight for two elements across begins at an edge that is kept.
  bool isSmooth(std::size_t e) const {
    constexpr double kLeastRadius = 0.4;  // of the size
    return mayCross(e) && in_.joints[e].angle <= mostTurnAt(in_, e) &&
           in_.joints[e].bend * in_.sizes[one(e)] * kLeastRadius < 1;
  }

  /// What a strip has in common with a neighbouring group.
  struct Shared {
    double length = 0;         // of all common edges
    double longest = 0;        // of one of them
    Point3 normal;             // of the neighbour there
    double angle = 0;          // the largest between both
    bool mayBeCrossed = true;  // all of the edges
  };
  /// A group as long as it is one strip, by the edges around it.
  struct Strip {
    double area = 0, around = 0;
    double narrow = std::numeric_limits<double>::infinity();
    std::map<std::uint32_t, Shared> shared;  // by neighbouring group
    double width() const {
      return around > 0 ? 2 * area / around : std::numeric_limits<double>::infinity();
    }
    bool isNarrow() const { return width() < narrow; }
  };
  using Strips = std::map<std::uint32_t, Strip>;

  Strips strips() {
    Strips all;
    for (std::uint32_t f = 0; f < in_.areas.size(); ++f) {
      Strip& strip = all[sets_.of(f)];
      strip.area += in_.areas[f];
      strip.narrow = std::min(strip.narrow, in_.narrow[f]);
    }
    for (std::size_t e = 0; e < in_.joints.size(); ++e) addEdge(e, all);
    return all;
  }

  void addEdge(std::size_t e, Strips& all) {
    const double length = in_.lengths[e];
    const EdgeJoint& joint = in_.joints[e];
    if (!joint.isJoint()) {
      for (const int face : in_.model.facesOfEdges[e])
        all[sets_.of(static_cast<std::uint32_t>(face) - 1)].around += length;
      return;
    }
    const std::uint32_t a = sets_.of(one(e)), b = sets_.of(other(e));
    if (a == b) return;
    add(e, joint.normalOfOther, all[a], all[a].shared[b]);
    add(e, joint.normalOfOne, all[b], all[b].shared[a]);
  }

  void add(std::size_t e, const Point3& normal, Strip& strip, Shared& shared) const {
    const double length = in_.lengths[e];
    strip.around += length;
    shared.length += length;
    shared.angle = std::max(shared.angle, in_.joints[e].angle);
    shared.mayBeCrossed = shared.mayBeCrossed && mayCross(e);
    if (!(length > shared.longest)) return;
    shared.longest = length;
    shared.normal = normal;
  }

  /// The narrowest strips first; each is merged with one wide group beside it.
  void joinNarrow() {
    const Strips all = strips();
    std::vector<std::uint32_t> order;
    for (const auto& [group, strip] : all)
      if (strip.isNarrow()) order.push_back(group);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t group) { return all.at(group).width(); });
    std::map<std::uint32_t, std::uint32_t> hosts;
    for (const std::uint32_t group : order)
      if (const auto host = hostOf(group, all)) hosts[group] = *host;
    std::vector<std::uint32_t> before;
    for (std::uint32_t f = 0; f < in_.areas.size(); ++f) before.push_back(sets_.of(f));
    for (std::size_t e = 0; e < in_.joints.size(); ++e) {
      if (!mayCross(e)) continue;
      const std::uint32_t a = before[one(e)], b = before[other(e)];
      const auto isHost = [&](std::uint32_t group, std::uint32_t host) {
        const auto found = hosts.find(group);
        return found != hosts.end() && found->second == host;
      };
      if (isHost(a, b) || isHost(b, a)) crossed_.insert(e);
    }
    for (const auto& [group, host] : hosts) sets_.join(group, host);
    for (std::uint32_t f = 0; f < before.size(); ++f) isNarrow_[f] = hosts.contains(before[f]);
  }

  std::vector<bool> facesAlone() {
    std::vector<bool> areAlone(in_.areas.size(), false);
    const Strips all = strips();
    for (std::uint32_t f = 0; f < areAlone.size(); ++f)
      areAlone[f] = all.at(sets_.of(f)).isNarrow();
    return areAlone;
  }

  /// A strip lies between two wide groups, along each with a good part of its boundary. The one
  /// along which it lies longer is its host.
  std::optional<std::uint32_t> hostOf(std::uint32_t group, const Strips& all) const {
    constexpr double kLeast = 0.25;  // of the boundary of the strip
    const Strip& strip = all.at(group);
    std::vector<std::uint32_t> sides;
    for (const auto& [neighbor, shared] : strip.shared)
      if (!all.at(neighbor).isNarrow() && shared.length >= kLeast * strip.around)
        sides.push_back(neighbor);
    std::ranges::stable_sort(sides, std::ranges::greater(),
                             [&](std::uint32_t side) { return strip.shared.at(side).length; });
    for (const std::uint32_t host : sides)
      for (const std::uint32_t other : sides)
        if (host != other && isShallow(strip, strip.shared.at(host), strip.shared.at(other)))
          return host;
    return std::nullopt;
  }

  /// Whether elements that reach from the host across the strip come near enough to both, and the
  /// other side does not fold back onto the host.
  bool isShallow(const Strip& strip, const Shared& host, const Shared& other) const {
    const double rise = strip.width() * sine(std::min(host.angle, 90 * kDegree));
    return host.mayBeCrossed && host.angle <= kMaxFold && other.angle <= kMaxFold &&
           dot(host.normal, other.normal) >= cosine(kMaxFold) && rise <= strip.narrow / 2;
  }

  const GroupingInput& in_;
  DisjointSets sets_;
  std::vector<bool> isNarrow_;
  std::set<std::size_t> crossed_;  // edges beside narrow faces
};

}  // namespace

FaceGrouping groupFaces(const GroupingInput& input) { return Grouping(input).make(); }

double mostTurnAt(const GroupingInput& input, std::size_t edge) {
  double turn = input.angle;
  for (const int face : input.model.facesOfEdges[edge]) {
    const auto f = static_cast<std::size_t>(face) - 1;
    turn = std::min(turn, angleOf({input.sizes[f], 4 * input.chords[f]}));
  }
  return turn;
}

double shortAt(const GroupingInput& input, std::size_t edge) {
  double length = std::numeric_limits<double>::infinity();
  for (const int face : input.model.facesOfEdges[edge])
    length = std::min(length, input.narrow[static_cast<std::size_t>(face) - 1]);
  return length;
}

}  // namespace af2::geometry
