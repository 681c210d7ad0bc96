#include "geometry/occ/edges/layer_parts.h"

#include <algorithm>

namespace af2::geometry {
namespace {

/// The parameters of vertices at these lengths from an end of a part, in the order of the edge.
/// None if they do not fit on the part.
std::vector<double> parametersAt(const EdgeSamples& samples, const std::vector<double>& lengths,
                                 bool fromStart) {
  constexpr double kMax = 0.85;  // of the part
  std::vector<double> parameters;
  if (lengths.back() > kMax * samples.length) return parameters;
  for (const double length : lengths)
    parameters.push_back(parameterAt(samples, fromStart ? length : samples.length - length));
  if (!fromStart) std::ranges::reverse(parameters);
  return parameters;
}

}  // namespace

std::vector<double> divideBetweenLayers(const ModelShape& model, const EdgePart& part,
                                        const LayerEnds& layers, const CuspLengths& cusps,
                                        const std::map<std::uint32_t, double>& tips,
                                        AskedSegments asked, const CadSizes& sizes) {
  const int id = static_cast<int>(part.edge) + 1;
  const auto start = part.isFirst ? layers.find({id, true}) : layers.end();
  const auto end = part.isLast ? layers.find({id, false}) : layers.end();
  std::vector<double> first, last;
  if (start != layers.end()) first = parametersAt(part.samples, start->second, true);
  if (end != layers.end()) last = parametersAt(part.samples, end->second, false);
  if (!first.empty() && !last.empty() && first.back() >= last.front()) last.clear();
  if (first.empty() && last.empty()) return divideFromCusps(model, part, cusps, tips, asked, sizes);

  constexpr std::uint32_t kNowhere = 0xffffffffu;
  std::vector<double> cuts;
  if (!first.empty()) cuts.push_back(first.back());
  if (!last.empty()) cuts.push_back(last.front());
  EdgePart rest = part;
  rest.samples = split(part.samples, cuts)[first.empty() ? 0 : 1];
  if (!first.empty()) rest.isFirst = false;
  if (!first.empty()) rest.ends.first = kNowhere;
  if (!last.empty()) rest.isLast = false;
  if (!last.empty()) rest.ends.last = kNowhere;
  const std::size_t fixed = first.size() + last.size();
  asked.least = asked.least > fixed ? asked.least - fixed : 1;
  std::vector<double> parameters = divideFromCusps(model, rest, cusps, tips, asked, sizes);
  if (!first.empty()) {  // the last one is where the rest begins
    parameters.insert(parameters.begin(), first.begin(), first.end() - 1);
    parameters.insert(parameters.begin(), part.samples.pieces.front().parameters.front());
  }
  if (!last.empty()) {
    parameters.insert(parameters.end(), last.begin() + 1, last.end());
    parameters.push_back(part.samples.pieces.back().parameters.back());
  }
  return parameters;
}

}  // namespace af2::geometry
