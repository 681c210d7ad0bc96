#include "geometry/occ/edges/edge_parts.h"

#include <algorithm>

#include "geometry/base/box_tree.h"

namespace af2::geometry {

namespace {

/// A piece up to a parameter; the piece itself becomes the rest.
EdgePiece cutOff(EdgePiece& piece, double parameter) {
  const auto at = std::ranges::lower_bound(piece.parameters, parameter);
  const std::size_t k = static_cast<std::size_t>(at - piece.parameters.begin());
  const double t =
      (parameter - piece.parameters[k - 1]) / (piece.parameters[k] - piece.parameters[k - 1]);
  const double s = piece.arcLength[k - 1] + t * (piece.arcLength[k] - piece.arcLength[k - 1]);
  const double size = piece.sizes[k - 1] + t * (piece.sizes[k] - piece.sizes[k - 1]);
  const Point3 position =
      piece.positions[k - 1] + t * (piece.positions[k] - piece.positions[k - 1]);
  const bool isSample = *at == parameter;
  EdgePiece before;
  const auto move = [&](auto& from, auto& to, const auto& between) {
    const auto end = from.begin() + static_cast<std::ptrdiff_t>(k);
    to.assign(from.begin(), end);
    to.push_back(between);
    from.erase(from.begin(), end);
    if (!isSample) from.insert(from.begin(), between);
  };
  const double least = std::min(piece.least[k - 1], piece.least[k]);
  move(piece.parameters.edit(), before.parameters.edit(), parameter);
  move(piece.arcLength.edit(), before.arcLength.edit(), s);
  move(piece.positions.edit(), before.positions.edit(), position);
  move(piece.sizes, before.sizes, size);
  move(piece.least.edit(), before.least.edit(), least);
  for (double& length : piece.arcLength.edit()) length -= s;
  return before;
}

}  // namespace

std::map<std::uint32_t, std::vector<EdgeEnd>> endsByPoint(const std::vector<EdgeUse>& edgesOfFace,
                                                          const std::vector<Ends>& ends,
                                                          const std::vector<EdgeSamples>& samples) {
  std::map<std::uint32_t, std::vector<EdgeEnd>> byPoint;
  for (const EdgeUse& use : edgesOfFace) {
    const auto edge = static_cast<std::size_t>(use.id) - 1;
    if (samples[edge].pieces.empty()) continue;
    byPoint[ends[edge].first].push_back({edge, true});
    byPoint[ends[edge].last].push_back({edge, false});
  }
  return byPoint;
}

Point3 directionFrom(EdgeEnd end, const std::vector<EdgeSamples>& samples) {
  const std::vector<EdgePiece>& pieces = samples[end.edge].pieces;
  const std::vector<Point3>& p = end.isStart ? pieces.front().positions : pieces.back().positions;
  const Point3 way = end.isStart ? p[1] - p[0] : p[p.size() - 2] - p.back();
  return (1 / length(way)) * way;
}

double extentOf(const EdgeSamples& samples) {
  Box3 box;
  for (const EdgePiece& piece : samples.pieces)
    for (const Point3& position : piece.positions) box.add(position);
  return samples.pieces.empty() ? 0 : distance(box.low, box.high);
}

double parameterAt(const EdgeSamples& samples, double length) {
  auto piece = samples.pieces.begin();
  for (; piece + 1 != samples.pieces.end() && piece->arcLength.back() < length; ++piece)
    length -= piece->arcLength.back();
  const std::vector<double>& along = piece->arcLength;
  const auto last = along.size() - 1;
  const auto found = std::lower_bound(along.begin() + 1, along.end() - 1, length);
  const auto k = std::min(static_cast<std::size_t>(found - along.begin()), last);
  const double t = (length - along[k - 1]) / (along[k] - along[k - 1]);
  return piece->parameters[k - 1] + t * (piece->parameters[k] - piece->parameters[k - 1]);
}

std::vector<EdgeSamples> split(EdgeSamples samples, const std::vector<double>& parameters) {
  std::vector<EdgeSamples> parts;
  parts.push_back(std::move(samples));
  for (const double parameter : parameters) {
    EdgeSamples rest = parts.back(), &before = parts.back();
    before.pieces.clear();
    while (rest.pieces.size() > 1 && rest.pieces.front().parameters.back() <= parameter) {
      before.pieces.push_back(std::move(rest.pieces.front()));
      rest.pieces.erase(rest.pieces.begin());
    }
    if (rest.pieces.front().parameters.front() < parameter)
      before.pieces.push_back(cutOff(rest.pieces.front(), parameter));
    parts.push_back(std::move(rest));
  }
  for (EdgeSamples& part : parts) {
    part.length = 0;
    for (const EdgePiece& piece : part.pieces) part.length += piece.arcLength.back();
    part.start = part.pieces.front().positions.front();
    part.end = part.pieces.back().positions.back();
  }
  return parts;
}

}  // namespace af2::geometry
