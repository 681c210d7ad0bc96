#include "geometry/occ/edges/crease_reach.h"

#include <algorithm>
#include <cmath>

namespace af2::geometry {

namespace {

/// The sizes near an end of a piece, which is at a length, become that where the crease is over.
void ease(EdgePiece& piece, double end, double reach) {
  if (!(reach > 0)) return;
  const auto distance = [&](std::size_t i) { return std::abs(piece.arcLength[i] - end); };
  std::size_t beyond = end > 0 ? 0 : piece.sizes.size() - 1;
  for (std::size_t i = 0; i < piece.sizes.size(); ++i)
    if (distance(i) > reach && distance(i) < distance(beyond)) beyond = i;
  for (std::size_t i = 0; i < piece.sizes.size(); ++i)
    if (distance(i) <= reach) piece.sizes[i] = std::max(piece.sizes[i], piece.sizes[beyond]);
}

}  // namespace

CreaseReach::CreaseReach(const ModelShape& model,
                         const std::function<std::uint32_t(std::uint32_t)>& pointOf) {
  for (const auto& [vertex, reach] : model.creaseReach) {
    double& farthest = byPoint_[pointOf(static_cast<std::uint32_t>(vertex - 1))];
    farthest = std::max(farthest, reach);
  }
}

double CreaseReach::at(std::uint32_t point) const {
  const auto found = byPoint_.find(point);
  return found == byPoint_.end() ? 0 : found->second;
}

void CreaseReach::leaveOut(EdgePart& part) const {
  ease(part.samples.pieces.front(), 0, at(part.ends.first));
  EdgePiece& last = part.samples.pieces.back();
  ease(last, last.arcLength.back(), at(part.ends.last));
}

}  // namespace af2::geometry
