#include "engine/run/even_cuts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "engine/base/elementary.h"
#include "engine/run/region_loops.h"

namespace af2::region {
namespace {

/// One edge more or less along a cut, which changes the parity of the loops on both sides of it.
struct Change {
  std::size_t cut = 0, edges = 0;
  double cost = 0;  ///< the number of edges times the square of how much longer or shorter they get
  std::size_t left = 0, right = 0;  ///< different loops
};

/// The cheaper one of an edge more and an edge less.
Change cheapestChange(std::size_t index, const Cut& cut, double wanted) {
  const auto cost = [&](std::size_t edges) {
    const double change = logarithm(static_cast<double>(edges) / wanted);
    return static_cast<double>(cut.edges()) * change * change;
  };
  const std::size_t more = cut.edges() + 1, fewer = cut.edges() - 1;
  const bool isFewer = fewer >= kFewestCutEdges && cost(fewer) < cost(more);
  const std::size_t edges = isFewer ? fewer : more;
  return {index, edges, cost(edges)};
}

/// The loops that cuts make are the nodes of a graph, and the cuts between different loops are its
/// links.
class EvenCuts {
 public:
  EvenCuts(const Loops& loops, const SurfaceEvaluator& surface, const SizeField& size,
           std::vector<Cut>& cuts)
      : loops_(loops), surface_(surface), size_(size), cuts_(cuts) {}

  void make() {
    findNewLoops();
    if (std::ranges::none_of(isOdd_, std::identity())) return;
    findChanges();
    makeForest();
    while (!forest_.empty()) takeLeaf();
  }

 private:
  /// Each cut has inner vertices. The first of them is a corner twice: once for each side.
  void findNewLoops() {
    std::size_t given = 0;
    for (const Loop& loop : loops_)
      for (const BoundaryCorner& c : loop) given = std::max<std::size_t>(given, c.vertex.value + 1);
    std::vector<std::size_t> firsts;
    std::size_t next = given;
    for (const Cut& cut : cuts_) {
      firsts.push_back(next);
      next += cut.inner.size();
    }
    beside_.resize(cuts_.size());
    for (const Loop& loop : relink(loops_, cuts_, given)) {
      for (const BoundaryCorner& c : loop) {
        const auto cut = std::ranges::lower_bound(firsts, c.vertex.value);
        if (cut != firsts.end() && *cut == c.vertex.value)
          beside_[static_cast<std::size_t>(cut - firsts.begin())].push_back(isOdd_.size());
      }
      isOdd_.push_back(loop.size() % 2 == 1);
    }
  }

  void findChanges() {
    for (std::size_t i = 0; i < cuts_.size(); ++i) {
      if (beside_[i].front() == beside_[i].back()) continue;  // twice along the same loop
      Change change = cheapestChange(i, cuts_[i], lineOf(cuts_[i]).wantedEdges());
      change.left = beside_[i].front();
      change.right = beside_[i].back();
      changes_.push_back(change);
    }
    std::ranges::stable_sort(changes_, {}, &Change::cost);
  }

  /// A spanning forest of the cheapest changes. Within a tree, which of them are needed is clear.
  void makeForest() {
    std::vector<std::size_t> tree(isOdd_.size());
    for (std::size_t loop = 0; loop < tree.size(); ++loop) tree[loop] = loop;
    for (const Change& change : changes_) {
      const std::size_t from = tree[change.left], to = tree[change.right];
      if (from == to) continue;
      std::ranges::replace(tree, from, to);
      forest_.push_back(change);
    }
  }

  void takeLeaf() {
    const auto isLeaf = [&](std::size_t loop) {
      return std::ranges::count_if(forest_, [&](const Change& change) {
               return change.left == loop || change.right == loop;
             }) == 1;
    };
    const auto found = std::ranges::find_if(
        forest_, [&](const Change& change) { return isLeaf(change.left) || isLeaf(change.right); });
    const Change change = *found;
    const std::size_t leaf = isLeaf(change.left) ? change.left : change.right;
    forest_.erase(found);
    if (!isOdd_[leaf]) return;
    isOdd_[change.left] = !isOdd_[change.left];
    isOdd_[change.right] = !isOdd_[change.right];
    cuts_[change.cut].inner = lineOf(cuts_[change.cut]).divided(change.edges);
  }

  CutLine lineOf(const Cut& cut) const {
    const auto at = [&](Spot s) { return loops_[s.loop][s.corner].point; };
    return {at(cut.from), at(cut.to), surface_, size_};
  }

  const Loops& loops_;
  const SurfaceEvaluator& surface_;
  const SizeField& size_;
  std::vector<Cut>& cuts_;
  std::vector<bool> isOdd_;                       // by new loop
  std::vector<std::vector<std::size_t>> beside_;  // by cut: the new loops on its two sides
  std::vector<Change> changes_;                   // the cheapest first
  std::vector<Change> forest_;
};

}  // namespace

void makePiecesEven(const Loops& loops, const SurfaceEvaluator& surface, const SizeField& size,
                    std::vector<Cut>& cuts) {
  if (!cuts.empty()) EvenCuts(loops, surface, size, cuts).make();
}

}  // namespace af2::region
