#include "dsl/compile/test_piece.h"

#include "engine/base/turn.h"

namespace af2::dsl {

void joinChains(FrontPiece& piece) {
  auto& chains = piece.chains;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    for (std::size_t k = 0; k < chains.size(); ++k) {
      const bool isClosed =
          chains[i].front() == chains[i].back() || chains[k].front() == chains[k].back();
      if (i == k || isClosed || chains[i].back() != chains[k].front()) continue;
      // The first edge of the first chain stays the base edge.
      chains[i].insert(chains[i].end(), chains[k].begin() + 1, chains[k].end());
      chains.erase(chains.begin() + static_cast<std::ptrdiff_t>(k));
      if (k < i) --i;
      k = static_cast<std::size_t>(-1);
    }
  }
}

std::optional<double> turnAt(const FrontPiece& piece, std::size_t vertex) {
  for (const auto& chain : piece.chains) {
    const bool isClosed = chain.size() > 2 && chain.front() == chain.back();
    const std::size_t n = isClosed ? chain.size() - 1 : chain.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (chain[i] != vertex || (!isClosed && (i == 0 || i + 1 == n))) continue;
      const auto& at = piece.vertices;
      const Point2 here = at[vertex], from = at[chain[(i + 1) % n]] - here,
                   to = at[chain[(i + n - 1) % n]] - here;
      return turnBetween(from, to);
    }
  }
  return std::nullopt;
}

}  // namespace af2::dsl
