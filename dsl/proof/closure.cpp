#include "dsl/proof/closure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "dsl/match/match_sampler.h"
#include "dsl/proof/test_text.h"
#include "engine/base/elementary.h"
#include "engine/run/algorithm.h"
#include "engine/step/single_step.h"
#include "engine/surface/plane_chart.h"

namespace af2::dsl {
namespace {

/// Free angles at which a vertex wants 1 to 4 elements, in degrees.
constexpr std::array kAngles{90.0, 180.0, 270.0, 335.0};

Point2 along(double degrees, double length) {
  const double angle = degrees * std::numbers::pi / 180;
  return length * af2::directionAt(angle);
}

/// d -> a -> b -> c
FrontPiece pieceWith(double angleA, double angleB) {
  // Two reversals: edges beside the base that do not cross below it.
  const double length = angleA > 300 && angleB > 300 ? 0.45 : 1;
  FrontPiece piece;
  piece.vertices = {
      along(angleA, length), {0, 0}, {1, 0}, Point2{1, 0} + along(180 - angleB, length)};
  piece.chains = {{0, 1, 2, 3}};
  piece.base = {1, 2};
  return piece;
}

std::vector<CountGap> gapsOf(const RuleSet& rules) {
  SingleStepper stepper(rules);
  std::vector<CountGap> gaps;
  for (std::size_t a = 0; a < kAngles.size(); ++a)
    for (std::size_t b = 0; b < kAngles.size(); ++b) {
      const FrontPiece piece = pieceWith(kAngles[a], kAngles[b]);
      if (!stepper.chosenRule(piece))
        gaps.push_back({static_cast<int>(a) + 1, static_cast<int>(b) + 1, piece});
    }
  return gaps;
}

/// Star-shaped around the origin, counter-clockwise, with edges of about length 1.
std::vector<Point2> randomLoop(int edges, RandomNumbers& random) {
  const double step = 360.0 / edges;
  const double radius = 0.5 / af2::sine(std::numbers::pi / edges);
  std::vector<Point2> loop;
  for (int i = 0; i < edges; ++i)
    loop.push_back(
        along(step * (i + random.between(-0.25, 0.25)), radius * random.between(0.75, 1.25)));
  return loop;
}

bool closes(const AF2Algorithm& algorithm, const std::vector<Point2>& loop) {
  FrontInput input;
  input.vertexCount = loop.size();
  input.loops.emplace_back();
  for (std::size_t i = 0; i < loop.size(); ++i)
    input.loops[0].push_back(
        {VertexId(i), {{loop[i].x, loop[i].y, 0}, {0, 0, 1}, loop[i].x, loop[i].y}});
  FrontOptions options;
  options.stallSteps = 20;
  options.stallCandidates = 20000;
  const PlaneChartMaker maker;
  return algorithm.execute(maker, input, UniformSize(1), options).outcome == Outcome::Complete;
}

SampledFinding findingOf(const CountGap& gap, std::size_t more) {
  SampledFinding finding(Code::UncoveredCounts);
  finding.message =
      fmt::format("no rule takes a base edge at level 1 whose ends want {} and {} elements",
                  gap.countA, gap.countB);
  if (more > 0) finding.message += fmt::format(", nor {} other pairs of counts", more);
  finding.help = "add a rule with `require count(a) == ..., count(b) == ...`, or loosen one";
  const auto& v = gap.piece.vertices;
  finding.test = fmt::format(
      "test \"a rule takes counts {} and {}\" {{\n  front d ({}, {}) -> a (0, 0) -> b (1, 0) -> c "
      "({}, {});\n  base a -> b;\n  expect not stuck;\n}}\n",
      gap.countA, gap.countB, shortest(v[0].x), shortest(v[0].y), shortest(v[3].x),
      shortest(v[3].y));
  return finding;
}

}  // namespace

std::optional<Closure> measureClosure(const RuleSet& rules) {
  constexpr int kOfEachSize = 60;
  if (rules.definition().parity != Parity::Even) return std::nullopt;
  Closure closure;
  closure.gaps = gapsOf(rules);
  const AF2Algorithm algorithm(std::make_shared<RuleSet>(rules));
  RandomNumbers random(1);
  for (const int edges : {4, 6, 8})
    for (int i = 0; i < kOfEachSize; ++i) {
      const std::vector<Point2> loop = randomLoop(edges, random);
      const bool isClosed = closes(algorithm, loop);
      ++closure.tried;
      closure.closed += isClosed;
      if (!isClosed && closure.open.empty()) closure.open = loop;
    }
  return closure;
}

std::vector<SampledFinding> findingsOf(const Closure& closure) {
  std::vector<SampledFinding> findings;
  if (!closure.gaps.empty())
    findings.push_back(findingOf(closure.gaps.front(), closure.gaps.size() - 1));
  if (closure.closed == closure.tried) return findings;
  SampledFinding finding(Code::UnclosedLoops);
  finding.message =
      fmt::format("the rules close {} of {} small even loops; one with {} edges stays open",
                  closure.closed, closure.tried, closure.open.size());
  std::string corners;
  for (const Point2 p : closure.open)
    corners += fmt::format("{}({:.2f}, {:.2f})", corners.empty() ? "" : ", ", p.x, p.y);
  finding.help =
      "its corners are " + corners +
      "; add rules that close loops of 4 and 6 edges, accept poorer elements at the last "
      "levels, or add a `path`";
  findings.push_back(std::move(finding));
  return findings;
}

}  // namespace af2::dsl
