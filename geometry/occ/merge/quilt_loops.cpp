#include "geometry/occ/merge/quilt_loops.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "engine/base/error.h"

namespace af2::geometry {

namespace {

class LoopFinder {
 public:
  LoopFinder(const BackgroundFacets& background, const std::vector<std::uint32_t>& triangles,
             const std::vector<bool>& isInner, const std::vector<EdgeChain>& chains)
      : background_(background), triangles_(triangles), isInner_(isInner) {
    for (const EdgeChain& chain : chains)
      for (std::size_t i = 0; i < chain.links.size(); ++i)
        links_[chain.links[i].edge] = {&chain, i};
  }

  QuiltLoops find() {
    takeSides();
    for (const auto& [from, side] : sides_)
      if (isFollowed(from) && !isDone_.contains(from)) addLoop(from);
    result_.euler = eulerNumber();
    return std::move(result_);
  }

 private:
  using Side = std::pair<std::uint32_t, std::uint32_t>;  // of a triangle, in its direction
  struct Corner {
    std::uint32_t triangle = 0, next = 0;  // the vertex after the side
  };
  /// A piece of an edge, or a whole one, in the direction of a loop.
  struct Piece {
    EdgePlace place;
    bool isReversed = false;
    std::uint32_t triangle = 0;
  };

  [[noreturn]] static void fail(const char* why) { throw GeometryError(why); }

  void takeSides() {
    for (const std::uint32_t t : triangles_) {
      const auto& corners = background_.triangles[t];
      for (std::size_t i = 0; i < 3; ++i) {
        const Side side{corners[i], corners[(i + 1) % 3]};
        vertices_.insert(corners[i]);
        if (!sides_.emplace(side, Corner{t, corners[(i + 2) % 3]}).second)
          fail("three of its faces meet along an edge, or two overlap");
      }
    }
  }

  /// Of the surface that is cut along all followed edges: what lies on these cancels out.
  int eulerNumber() const {
    std::set<std::uint32_t> inside = vertices_;
    std::set<Side> inner;
    for (const auto& [side, corner] : sides_) {
      if (!isFollowed(side)) inner.insert(std::minmax(side.first, side.second));
      if (!isFollowed(side)) continue;
      inside.erase(side.first);
      inside.erase(side.second);
    }
    return static_cast<int>(std::ssize(inside) - std::ssize(inner) + std::ssize(triangles_));
  }

  const EdgePlace* placeOf(const Side& side) const {
    const auto [low, high] = std::minmax(side.first, side.second);
    const int face = background_.face[sides_.at(side).triangle];
    const auto found = background_.edges.find({face, low, high});
    return found == background_.edges.end() ? nullptr : &found->second;
  }
  bool isFollowed(const Side& side) const {
    const EdgePlace* place = placeOf(side);
    return place && !isInner_[static_cast<std::size_t>(place->edge) - 1];
  }

  /// Around the end of a followed side, over sides that are not followed, to the next that is.
  Side after(Side side) const {
    const std::size_t most = 3 * triangles_.size() + 3;
    Side next{side.second, sides_.at(side).next};
    for (std::size_t step = 0; step < most; ++step) {
      if (isFollowed(next)) return next;
      const auto twin = sides_.find({next.second, next.first});
      if (twin == sides_.end()) fail("its faces do not fit together along an edge");
      next = {twin->first.second, twin->second.next};
    }
    fail("its faces do not fit together at a vertex");
  }

  void addLoop(const Side& start) {
    std::vector<Piece> pieces;
    Side side = start;
    do {
      if (!isDone_.insert(side).second) fail("its boundary crosses itself");
      const EdgePlace& place = *placeOf(side);
      const bool isUp = side.first < side.second;
      pieces.push_back({place, isUp != place.isForward, sides_.at(side).triangle});
      result_.length +=
          distance(background_.vertices[side.first], background_.vertices[side.second]);
      side = after(side);
    } while (side != start);
    result_.loops.push_back(chained(wholeEdges(std::move(pieces))));
  }

  /// From pieces to edges. A loop begins where an edge does.
  std::vector<QuiltUse> wholeEdges(std::vector<Piece> pieces) const {
    const auto count = [&](const Piece& piece) { return background_.pieces.at(piece.place.edge); };
    const auto begins = [&](const Piece& piece) {
      return piece.place.index == (piece.isReversed ? count(piece) - 1 : 0);
    };
    const auto first = std::ranges::find_if(pieces, begins);
    if (first == pieces.end()) fail("its boundary begins nowhere");
    std::rotate(pieces.begin(), first, pieces.end());
    std::vector<QuiltUse> uses;
    std::uint32_t along = 0;
    for (const Piece& piece : pieces) {
      if (begins(piece)) {
        uses.push_back({piece.place.edge, piece.isReversed, {}});
        along = 0;
      }
      const std::uint32_t expected = piece.isReversed ? count(piece) - 1 - along : along;
      if (uses.back().edge != piece.place.edge || piece.place.index != expected)
        fail("its boundary leaves an edge between its ends");
      uses.back().triangles.push_back(piece.triangle);
      ++along;
    }
    return uses;
  }

  struct Link {
    const EdgeChain* chain = nullptr;
    std::size_t index = 0;
  };

  /// The links of chains, in the order in which the loop has them, become one.
  std::vector<QuiltUse> chained(std::vector<QuiltUse> uses) const {
    const auto linkOf = [&](const QuiltUse& use) {
      const auto found = links_.find(use.edge);
      return found == links_.end() ? Link() : found->second;
    };
    const auto isBackward = [&](const QuiltUse& use, const Link& link) {
      return use.isReversed != link.chain->links[link.index].isReversed;
    };
    const auto begins = [&](const QuiltUse& use) {
      const Link link = linkOf(use);
      return !link.chain ||
             link.index == (isBackward(use, link) ? link.chain->links.size() - 1 : 0);
    };
    const auto first = std::ranges::find_if(uses, begins);
    if (first == uses.end()) fail("its boundary begins inside a chain of edges");
    std::rotate(uses.begin(), first, uses.end());
    std::vector<QuiltUse> result;
    std::size_t along = 0;
    for (QuiltUse& use : uses) {
      const Link link = linkOf(use);
      if (!link.chain) {
        result.push_back(std::move(use));
        continue;
      }
      const bool backward = isBackward(use, link);
      if (begins(use)) {
        result.push_back({link.chain->id(), backward, {}});
        along = 0;
      }
      const std::size_t last = link.chain->links.size() - 1;
      QuiltUse& whole = result.back();
      if (whole.edge != link.chain->id() || whole.isReversed != backward ||
          link.index != (backward ? last - along : along))
        fail("its boundary leaves a chain of edges between its ends");
      whole.triangles.insert(whole.triangles.end(), use.triangles.begin(), use.triangles.end());
      ++along;
    }
    return result;
  }

  const BackgroundFacets& background_;
  const std::vector<std::uint32_t>& triangles_;
  const std::vector<bool>& isInner_;
  std::map<int, Link> links_;
  std::map<Side, Corner> sides_;
  std::set<Side> isDone_;
  std::set<std::uint32_t> vertices_;
  QuiltLoops result_;
};

}  // namespace

QuiltLoops loopsAround(const BackgroundFacets& background,
                       const std::vector<std::uint32_t>& triangles,
                       const std::vector<bool>& isInner, const std::vector<EdgeChain>& chains) {
  return LoopFinder(background, triangles, isInner, chains).find();
}

}  // namespace af2::geometry
