#include "cli/playground/sample_domains.h"

#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>

namespace af2::playground {
namespace {

using geometry::PlanarDomain;

constexpr int kTurn = 48;  ///< corners of the polygon that stands for a circle

PlanarDomain::Segment segmentBetween(int from, int to, int edge) {
  PlanarDomain::Segment segment;
  segment.from = from;
  segment.to = to;
  segment.edge = edge;
  return segment;
}

/// A polygon, counter-clockwise, each side an edge.
void addPolygon(PlanarDomain& domain, std::initializer_list<Point2> corners) {
  const int first = static_cast<int>(domain.points.size());
  const int count = static_cast<int>(corners.size());
  domain.points.insert(domain.points.end(), corners.begin(), corners.end());
  for (int i = 0; i < count; ++i) {
    const int edge = static_cast<int>(domain.segments.size()) + 1;
    domain.segments.push_back(segmentBetween(first + i, first + (i + 1) % count, edge));
  }
}

Point2 onCircle(Point2 centre, double radius, double turn) {
  const double angle = 2 * std::numbers::pi * turn;
  return {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
}

/// One curved edge.
void addCircle(PlanarDomain& domain, Point2 centre, double radius) {
  const int first = static_cast<int>(domain.points.size());
  const int edge = static_cast<int>(domain.segments.size()) + 1;
  for (int i = 0; i < kTurn; ++i) {
    domain.points.push_back(onCircle(centre, radius, static_cast<double>(i) / kTurn));
    PlanarDomain::Segment segment = segmentBetween(first + i, first + (i + 1) % kTurn, edge);
    segment.fromParameter = static_cast<double>(i) / kTurn;
    segment.toParameter = static_cast<double>(i + 1) / kTurn;
    domain.segments.push_back(segment);
  }
  domain.curves[edge] = [centre, radius](double turn) { return onCircle(centre, radius, turn); };
}

PlanarDomain plate() {
  PlanarDomain domain;
  addPolygon(domain, {{0, 0}, {10, 0}, {10, 6}, {0, 6}});
  addCircle(domain, {3, 3}, 1.5);
  domain.holes = {{3, 3}};
  return domain;
}

PlanarDomain square() {
  PlanarDomain domain;
  addPolygon(domain, {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  return domain;
}

PlanarDomain disc() {
  PlanarDomain domain;
  addCircle(domain, {5, 5}, 5);
  return domain;
}

PlanarDomain lShape() {
  PlanarDomain domain;
  addPolygon(domain, {{0, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 10}, {0, 10}});
  return domain;
}

/// Corners of 20 degrees and more.
PlanarDomain star() {
  PlanarDomain domain;
  addPolygon(domain, {{5, 0},
                      {5.9, 3.6},
                      {10, 2.4},
                      {7.3, 5.3},
                      {9.4, 9.6},
                      {5.4, 6.9},
                      {1.5, 9.4},
                      {3.2, 5.6},
                      {0, 3.1},
                      {4, 3.6}});
  return domain;
}

/// Walls and gaps of one unit and less.
PlanarDomain comb() {
  PlanarDomain domain;
  addPolygon(domain, {{0, 0},   {10, 0},  {10, 6},  {9, 6},   {9, 2},   {7.5, 2},   {7.5, 6},
                      {6.7, 6}, {6.7, 2}, {5.2, 2}, {5.2, 6}, {4.7, 6}, {4.7, 1.5}, {3, 1.5},
                      {3, 6},   {2.7, 6}, {2.7, 1}, {1, 1},   {1, 6},   {0, 6}});
  return domain;
}

constexpr std::array kDomains{
    SampleDomain{"plate", "plate with a hole", &plate},
    SampleDomain{"square", "square", &square},
    SampleDomain{"disc", "disc", &disc},
    SampleDomain{"l", "L shape", &lShape},
    SampleDomain{"star", "star", &star},
    SampleDomain{"comb", "comb", &comb},
};

constexpr std::array kSizes{
    SampleSize{"coarse", "coarse (1)", 1},
    SampleSize{"medium", "medium (0.5)", 0.5},
    SampleSize{"fine", "fine (0.25)", 0.25},
    SampleSize{"finest", "very fine (0.12)", 0.12},
};

}  // namespace

std::span<const SampleDomain> sampleDomains() { return kDomains; }
std::span<const SampleSize> sampleSizes() { return kSizes; }

}  // namespace af2::playground
