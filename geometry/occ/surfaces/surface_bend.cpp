#include "geometry/occ/surfaces/surface_bend.h"

#include <algorithm>
#include <vector>

namespace af2::geometry {
namespace {

constexpr int kSteps = 8;

double between(double low, double high, double share) { return low + share * (high - low); }

/// Points along a parameter line across the face.
std::vector<SurfacePoint> alongU(const GeneralSurface& surface, const SplineSurface::Box& box,
                                 double share) {
  std::vector<SurfacePoint> points;
  for (int i = 0; i <= kSteps; ++i)
    points.push_back(surface.pointAt(between(box.u1, box.u2, static_cast<double>(i) / kSteps),
                                     between(box.v1, box.v2, share)));
  return points;
}
std::vector<SurfacePoint> alongV(const GeneralSurface& surface, const SplineSurface::Box& box,
                                 double share) {
  std::vector<SurfacePoint> points;
  for (int i = 0; i <= kSteps; ++i)
    points.push_back(surface.pointAt(between(box.u1, box.u2, share),
                                     between(box.v1, box.v2, static_cast<double>(i) / kSteps)));
  return points;
}

/// Whether the normals turn by more than about 100 degrees along a line.
bool isBent(const std::vector<SurfacePoint>& line) {
  constexpr double kBent = 1.7;
  double turn = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    turn += distance(line[i - 1].normal, line[i].normal);
  return turn > kBent;
}

/// Whether most turns of the normals along a line undo others.
bool turnsBack(const std::vector<SurfacePoint>& line) {
  constexpr double kLeft = 0.5;  // of all turns
  Point3 sum{};
  double all = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point3 turn = cross(line[i - 1].normal, line[i].normal);
    sum = sum + turn;
    all += length(turn);
  }
  return length(sum) < kLeft * all;
}

double lengthOf(const std::vector<SurfacePoint>& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    sum += distance(line[i - 1].position, line[i].position);
  return sum;
}

struct SharpestTurn {
  double radius;
  Point3 place;
};

/// Where the normals turn most between two points of a line.
SharpestTurn sharpestTurnOn(const std::vector<SurfacePoint>& line, const GeneralSurface& surface) {
  constexpr int kHalvings = 16;
  constexpr double kTurn = 0.5;  // with less between two points, the radius is known
  const auto turn = [](const SurfacePoint& a, const SurfacePoint& b) {
    return distance(a.normal, b.normal);
  };
  SurfacePoint from = line[0], to = line[1];
  for (std::size_t i = 2; i < line.size(); ++i)
    if (turn(line[i - 1], line[i]) > turn(from, to)) from = line[i - 1], to = line[i];
  for (int i = 0; i < kHalvings && turn(from, to) > kTurn; ++i) {
    const SurfacePoint middle = surface.pointAt((from.u + to.u) / 2, (from.v + to.v) / 2);
    (turn(from, middle) > turn(middle, to) ? to : from) = middle;
  }
  return {distance(from.position, to.position) / turn(from, to), from.position};
}

/// The least radius of a crease that runs across lines side by side; at a tip they all turn in the
/// same place.
double creaseRadius(const std::vector<SharpestTurn>& turns, double extent) {
  constexpr double kFarApart = 0.05;  // of the extent
  double least = std::numeric_limits<double>::infinity();
  for (const SharpestTurn& a : turns)
    for (const SharpestTurn& b : turns)
      if (distance(a.place, b.place) > kFarApart * extent)
        least = std::min(least, std::max(a.radius, b.radius));
  return least;
}

double extentOf(const std::vector<SurfacePoint>& points) {
  double extent = 0;
  for (const SurfacePoint& p : points)
    for (const SurfacePoint& q : points)
      extent = std::max(extent, distance(p.position, q.position));
  return extent;
}

}  // namespace

void SurfaceBend::add(const SurfaceBend& part) {
  inU = inU || part.inU;
  inV = inV || part.inV;
  extent = std::max(extent, part.extent);
  breadth = std::min(breadth, part.breadth);
  girth = std::min(girth, part.girth);
  creaseRadius = std::min(creaseRadius, part.creaseRadius);
  isWavy = isWavy || part.isWavy;
}

SurfaceBend bendOf(const GeneralSurface& surface, const SplineSurface::Box& box) {
  SurfaceBend bend;
  std::vector<SharpestTurn> turnsInU, turnsInV;
  double longestInU = 0, longestInV = 0;  // of those that are bent
  const auto look = [&](const std::vector<SurfacePoint>& line, std::vector<SharpestTurn>& turns,
                        double& longest) {
    bend.extent = std::max(bend.extent, extentOf(line));
    if (!isBent(line)) return;
    bend.breadth = std::min(bend.breadth, lengthOf(line));
    longest = std::max(longest, lengthOf(line));
    bend.isWavy = bend.isWavy || turnsBack(line);
    turns.push_back(sharpestTurnOn(line, surface));
  };
  for (const double share : {0.02, 0.5, 0.98}) {
    look(alongU(surface, box, share), turnsInU, longestInU);
    look(alongV(surface, box, share), turnsInV, longestInV);
  }
  bend.inU = !turnsInU.empty();
  bend.inV = !turnsInV.empty();
  if (bend.inU) bend.girth = longestInU;
  if (bend.inV) bend.girth = std::min(bend.girth, longestInV);
  bend.creaseRadius =
      std::min(creaseRadius(turnsInU, bend.extent), creaseRadius(turnsInV, bend.extent));
  return bend;
}

}  // namespace af2::geometry
