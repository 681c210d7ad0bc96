#include "geometry/occ/merge/face_grouping.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

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
    if (in_.narrow > 0) joinNarrow();
    FaceGrouping grouping{{}, {}, {}, isNarrow_};
    for (std::uint32_t f = 0; f < in_.areas.size(); ++f) grouping.group.push_back(sets_.of(f));
    for (std::size_t e = 0; e < in_.joints.size(); ++e) {
      const bool isBeside = crossed_.contains(e);
      grouping.isBesideNarrow.push_back(isBeside);
      grouping.isInner.push_back(isBeside || isSmooth(e));
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
           in_.sizes[one(e)] == in_.sizes[other(e)];
  }
  bool isSmooth(std::size_t e) const { return mayCross(e) && in_.joints[e].angle <= in_.angle; }

  /// A group as long as it is one strip, by the edges around it.
  struct Strip {
    double area = 0, around = 0;
    double size = std::numeric_limits<double>::infinity();
    std::map<std::uint32_t, double> shared;  // by neighbouring group: length of common edges
    double width() const { return around > 0 ? 2 * area / around : 0; }
    bool isNarrow(double share) const { return width() < share * size; }
  };

  std::map<std::uint32_t, Strip> strips() {
    std::map<std::uint32_t, Strip> all;
    for (std::uint32_t f = 0; f < in_.areas.size(); ++f) {
      Strip& strip = all[sets_.of(f)];
      strip.area += in_.areas[f];
      strip.size = std::min(strip.size, in_.sizes[f]);
    }
    for (std::size_t e = 0; e < in_.joints.size(); ++e) addEdge(e, all);
    return all;
  }

  void addEdge(std::size_t e, std::map<std::uint32_t, Strip>& all) {
    const double length = in_.lengths[e];
    if (!in_.joints[e].isJoint()) {
      for (const int face : in_.model.facesOfEdges[e])
        all[sets_.of(static_cast<std::uint32_t>(face) - 1)].around += length;
      return;
    }
    const std::uint32_t a = sets_.of(one(e)), b = sets_.of(other(e));
    if (a == b) return;
    all[a].around += length;
    all[b].around += length;
    if (!mayCross(e)) return;
    all[a].shared[b] += length;
    all[b].shared[a] += length;
  }

  /// The narrowest strips first; each is merged with one wider group beside it.
  void joinNarrow() {
    const std::map<std::uint32_t, Strip> all = strips();
    std::vector<std::uint32_t> order;
    for (const auto& [group, strip] : all)
      if (strip.isNarrow(in_.narrow)) order.push_back(group);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t group) { return all.at(group).width(); });
    std::map<std::uint32_t, std::uint32_t> hosts;
    for (const std::uint32_t group : order)
      if (const auto host = hostOf(group, all)) hosts[group] = *host;
    std::vector<std::uint32_t> before;
    for (std::uint32_t f = 0; f < in_.areas.size(); ++f) before.push_back(sets_.of(f));
    for (const auto& [group, host] : hosts) {
      for (std::size_t e = 0; e < in_.joints.size(); ++e)
        if (mayCross(e) &&
            std::minmax(before[one(e)], before[other(e)]) == std::minmax(group, host))
          crossed_[e] = true;
      sets_.join(group, host);
    }
    for (std::uint32_t f = 0; f < before.size(); ++f) isNarrow_[f] = hosts.contains(before[f]);
  }

  /// The wide group with which a strip shares most of its boundary, but not all of it: then it is
  /// the end of a pin, and no strip.
  std::optional<std::uint32_t> hostOf(std::uint32_t group,
                                      const std::map<std::uint32_t, Strip>& all) {
    constexpr double kLeast = 0.25, kMost = 0.9;  // of the boundary of the strip
    const Strip& strip = all.at(group);
    std::optional<std::uint32_t> best;
    double longest = kLeast * strip.around;
    for (const auto& [neighbor, length] : strip.shared) {
      if (all.at(neighbor).isNarrow(in_.narrow) || length > kMost * strip.around) continue;
      if (!(length > longest) || !isShallow(group, neighbor, strip)) continue;
      longest = length;
      best = neighbor;
    }
    return best;
  }

  /// Whether elements that reach from the neighbour across the strip come near enough to both.
  bool isShallow(std::uint32_t group, std::uint32_t neighbor, const Strip& strip) {
    double angle = 0;
    for (std::size_t e = 0; e < in_.joints.size(); ++e)
      if (mayCross(e) &&
          std::minmax(sets_.of(one(e)), sets_.of(other(e))) == std::minmax(group, neighbor))
        angle = std::max(angle, in_.joints[e].angle);
    const double rise = strip.width() * std::sin(std::min(angle, 90 * kDegree));
    return angle <= kMaxFold && rise <= in_.narrow / 2 * strip.size;
  }

  const GroupingInput& in_;
  DisjointSets sets_;
  std::vector<bool> isNarrow_;
  std::map<std::size_t, bool> crossed_;  // edges beside narrow faces
};

}  // namespace

FaceGrouping groupFaces(const GroupingInput& input) { return Grouping(input).make(); }

double sizeAtEdge(const GroupingInput& input, std::size_t edge) {
  double size = std::numeric_limits<double>::infinity();
  for (const int face : input.model.facesOfEdges[edge])
    size = std::min(size, input.sizes[static_cast<std::size_t>(face) - 1]);
  return size;
}

}  // namespace af2::geometry
