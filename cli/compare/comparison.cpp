#include "cli/compare/comparison.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "dsl/match/match_sampler.h"

namespace af2::cli {
namespace {

using geometry::Distribution;
using Value = std::optional<double>;

Value share(std::size_t part, std::size_t whole) {
  if (whole == 0) return std::nullopt;
  return static_cast<double>(part) / static_cast<double>(whole);
}

Value ofMesh(const CaseResult& result, double value) {
  return result.hasMesh && std::isfinite(value) ? Value(value) : std::nullopt;
}

Value ofAny(const Distribution& values, double Distribution::*value) {
  return values.count > 0 ? Value(values.*value) : std::nullopt;
}

Value ofRing(const CaseResult& result, std::size_t ring) {
  const geometry::VertexCount& count = result.measures.irregular.rings[ring];
  return share(count.irregular, count.all);
}

/// Of the angles of triangles and of quadrilaterals; `pick` is std::min or std::max.
template <class Pick>
Value ofAngles(const CaseResult& result, double Distribution::*value, Pick pick) {
  const Distribution& quads = result.measures.quadAngles;
  const Distribution& triangles = result.measures.triangleAngles;
  if (quads.count == 0) return ofMesh(result, triangles.*value);
  if (triangles.count == 0) return ofMesh(result, quads.*value);
  return ofMesh(result, pick(quads.*value, triangles.*value));
}

using Case = const CaseResult&;
constexpr ComparedMeasure kMeasures[] = {
    {"failed", "faces that could not be meshed", Better::Lower,
     [](Case c) { return Value(static_cast<double>(c.failedFaces)); }},
    {"stuck", "faces with a front that got stuck, also if it was closed afterwards", Better::Lower,
     [](Case c) { return Value(static_cast<double>(c.stuckFaces)); }},
    {"without_rule", "elements that no rule made, over all elements", Better::Lower,
     [](Case c) { return share(c.withoutRule, c.measures.elements()); }},
    {"elements", "number of elements", Better::Neither,
     [](Case c) { return ofMesh(c, static_cast<double>(c.measures.elements())); }},
    {"quad_share", "share of quadrilaterals", Better::Higher,
     [](Case c) { return ofMesh(c, c.measures.quadShare()); }},
    {"inverted", "number of inverted elements", Better::Lower,
     [](Case c) { return ofMesh(c, static_cast<double>(c.measures.inverted)); }},
    {"sj_min", "smallest scaled Jacobian", Better::Higher,
     [](Case c) { return ofMesh(c, c.measures.jacobian.min); }},
    {"sj_p1", "1st percentile of the scaled Jacobian", Better::Higher,
     [](Case c) { return ofMesh(c, c.measures.jacobian.p1); }},
    {"sj_mean", "mean of the scaled Jacobian", Better::Higher,
     [](Case c) { return ofMesh(c, c.measures.jacobian.mean); }},
    {"quality_min", "smallest quality", Better::Higher,
     [](Case c) { return ofMesh(c, c.measures.quality.min); }},
    {"quality_mean", "mean quality", Better::Higher,
     [](Case c) { return ofMesh(c, c.measures.quality.mean); }},
    {"angle_min", "smallest angle, degrees", Better::Higher,
     [](Case c) {
       return ofAngles(c, &Distribution::min, [](double a, double b) { return std::min(a, b); });
     }},
    {"angle_max", "largest angle, degrees", Better::Lower,
     [](Case c) {
       return ofAngles(c, &Distribution::max, [](double a, double b) { return std::max(a, b); });
     }},
    {"aspect_p95", "95th percentile of the aspect ratio", Better::Lower,
     [](Case c) { return ofMesh(c, c.measures.aspect.p95); }},
    {"length_mean", "mean of edge length / target size", Better::Neither,
     [](Case c) { return ofMesh(c, c.measures.lengths.mean); }},
    {"length_min", "smallest edge length / target size", Better::Higher,
     [](Case c) { return ofMesh(c, c.measures.lengths.min); }},
    {"length_p5", "5th percentile of edge length / target size", Better::Neither,
     [](Case c) { return ofMesh(c, c.measures.lengths.p5); }},
    {"length_p95", "95th percentile of edge length / target size", Better::Neither,
     [](Case c) { return ofMesh(c, c.measures.lengths.p95); }},
    {"length_max", "largest edge length / target size", Better::Lower,
     [](Case c) { return ofMesh(c, c.measures.lengths.max); }},
    {"length_spread", "95th minus 5th percentile of edge length / target size", Better::Lower,
     [](Case c) { return ofMesh(c, c.measures.lengths.p95 - c.measures.lengths.p5); }},
    {"irregular", "share of irregular vertices inside faces", Better::Lower,
     [](Case c) {
       return share(c.measures.irregular.inner.irregular, c.measures.irregular.inner.all);
     }},
    {"irregular_excess", "share of irregular vertices inside faces beyond the least number",
     Better::Lower,
     [](Case c) {
       const auto& [inner, boundary, rings, least] = c.measures.irregular;
       return share(inner.irregular - std::min(inner.irregular, least), inner.all);
     }},
    {"irregular_boundary", "share of irregular vertices on boundaries", Better::Lower,
     [](Case c) { return ofRing(c, 0); }},
    {"irregular_ring1", "share of irregular vertices one edge from the boundary", Better::Lower,
     [](Case c) { return ofRing(c, 1); }},
    {"irregular_ring2", "share of irregular vertices two edges from the boundary", Better::Lower,
     [](Case c) { return ofRing(c, 2); }},
    {"irregular_ring3", "share of irregular vertices three edges from the boundary", Better::Lower,
     [](Case c) { return ofRing(c, 3); }},
    {"irregular_far", "share of irregular vertices farther from the boundary", Better::Lower,
     [](Case c) { return ofRing(c, 4); }},
    {"meeting", "share of elements where fronts meet", Better::Neither,
     [](Case c) { return share(c.measures.meeting.jacobian.count, c.measures.elements()); }},
    {"meeting_sj_p1", "1st percentile of the scaled Jacobian where fronts meet", Better::Higher,
     [](Case c) { return ofAny(c.measures.meeting.jacobian, &Distribution::p1); }},
    {"meeting_sj_mean", "mean of the scaled Jacobian where fronts meet", Better::Higher,
     [](Case c) { return ofAny(c.measures.meeting.jacobian, &Distribution::mean); }},
    {"meeting_irregular", "share of irregular vertices where fronts meet", Better::Lower,
     [](Case c) {
       const geometry::VertexCount& there = c.measures.meeting.irregular;
       return share(there.irregular, there.all);
     }},
    {"elsewhere_sj_p1", "1st percentile of the scaled Jacobian elsewhere", Better::Higher,
     [](Case c) { return ofAny(c.measures.meeting.jacobianElsewhere, &Distribution::p1); }},
    {"elsewhere_sj_mean", "mean of the scaled Jacobian elsewhere", Better::Higher,
     [](Case c) { return ofAny(c.measures.meeting.jacobianElsewhere, &Distribution::mean); }},
    {"elsewhere_irregular", "share of irregular vertices inside faces elsewhere", Better::Lower,
     [](Case c) {
       const geometry::VertexCount& elsewhere = c.measures.meeting.irregularElsewhere;
       return share(elsewhere.irregular, elsewhere.all);
     }},
    {"spokes_mean", "mean deviation of spokes, degrees", Better::Lower,
     [](Case c) { return ofAny(c.measures.spokes, &Distribution::mean); }},
    {"spokes_p95", "95th percentile of the deviation of spokes, degrees", Better::Lower,
     [](Case c) { return ofAny(c.measures.spokes, &Distribution::p95); }},
    {"time", "microseconds for each element, only with --time", Better::Lower,
     [](Case c) {
       return ofMesh(c, 1e6 * c.seconds /
                            static_cast<double>(std::max<std::size_t>(c.measures.elements(), 1)));
     },
     true},
};

double meanOf(std::span<const double> values) {
  if (values.empty()) return 0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Verdict verdictOf(const MeasureComparison& row, Better better) {
  if (row.pairs < kFewestPairs) return Verdict::TooFew;
  if (row.low <= 0 && row.high >= 0) return Verdict::NoDifference;
  if (better == Better::Neither) return Verdict::Different;
  return (row.low > 0) == (better == Better::Higher) ? Verdict::Better : Verdict::Worse;
}

MeasureComparison compareMeasure(const SuiteResult& result, const ComparedMeasure& measure,
                                 std::size_t stage) {
  std::vector<double> first, second, pairedFirst, pairedSecond, differences;
  for (const CasePair& one : result.cases) {
    const Value a = measure.of(one[stage][kFirstSet]), b = measure.of(one[stage][kSecondSet]);
    if (a) first.push_back(*a);
    if (b) second.push_back(*b);
    if (!a || !b) continue;
    pairedFirst.push_back(*a);
    pairedSecond.push_back(*b);
    differences.push_back(*b - *a);
  }
  MeasureComparison row;
  row.name = measure.name;
  row.stage = kMeshStages[stage];
  row.pairs = differences.size();
  row.first = meanOf(row.pairs > 0 ? pairedFirst : first);
  row.second = meanOf(row.pairs > 0 ? pairedSecond : second);
  row.firstCount = first.size();
  row.secondCount = second.size();
  const MeanInterval interval = bootstrapMean(differences);
  row.difference = interval.mean;
  row.low = interval.low;
  row.high = interval.high;
  row.verdict = verdictOf(row, measure.better);
  return row;
}

}  // namespace

std::span<const ComparedMeasure> comparedMeasures() { return kMeasures; }

const char* toString(Verdict verdict) {
  switch (verdict) {
    case Verdict::Better:
      return "better";
    case Verdict::Worse:
      return "worse";
    case Verdict::Different:
      return "different";
    case Verdict::NoDifference:
      return "no difference";
    case Verdict::TooFew:
      return "too few models";
  }
  return "";
}

MeanInterval bootstrapMean(std::span<const double> differences) {
  constexpr std::size_t kResamples = 4000;
  constexpr std::uint64_t kSeed = 1;
  if (differences.empty()) return {};
  dsl::RandomNumbers random(kSeed);
  const auto count = static_cast<double>(differences.size());
  std::vector<double> means(kResamples);
  for (double& mean : means) {
    for (std::size_t i = 0; i < differences.size(); ++i)
      mean += differences[static_cast<std::size_t>(random.unit() * count)];
    mean /= count;
  }
  std::ranges::sort(means);
  return {meanOf(differences), means[kResamples / 40], means[kResamples - 1 - kResamples / 40]};
}

std::vector<MeasureComparison> compare(const SuiteResult& result, bool withTime) {
  std::vector<MeasureComparison> rows;
  for (std::size_t stage = 0; stage < kMeshStages.size(); ++stage)
    for (const ComparedMeasure& measure : kMeasures)
      if (withTime || !measure.isTime) rows.push_back(compareMeasure(result, measure, stage));
  return rows;
}

}  // namespace af2::cli
