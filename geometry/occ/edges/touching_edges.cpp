#include "geometry/occ/edges/touching_edges.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "geometry/base/box_tree.h"
#include "geometry/base/constants.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/edges/edge_line.h"

namespace af2::geometry {

namespace {

/// Tolerances count up to this share of the wanted size.
constexpr double kMax = 1e-3;

/// A stop must be this many times farther from the ends of the edge than the allowed distance from
/// the edge.
constexpr double kFromEnds = 10;

class StopFinder {
 public:
  StopFinder(const ModelShape& model, const std::vector<Ends>& ends,
             const std::vector<EdgeSamples>& samples, const std::vector<Point3>& points,
             const std::vector<bool>& mayBeSplit)
      : model_(model),
        ends_(ends),
        samples_(samples),
        points_(points),
        mayBeSplit_(mayBeSplit),
        stops_(samples.size()) {}

  std::vector<std::vector<Stop>> find() {
    for (int id = 1; id <= model_.faces.Extent(); ++id) lookAt(id);
    for (std::size_t edge = 0; edge < stops_.size(); ++edge) putInOrder(edge);
    return std::move(stops_);
  }

 private:
  /// An edge of the face, from one of its ends on.
  struct Beginning {
    std::size_t edge;
    std::uint32_t otherEnd;
  };

  void lookAt(int face) {
    std::vector<std::size_t> edges;
    std::set<std::uint32_t> vertices;
    for (const EdgeUse& use : model_.edgesOfFaces[static_cast<std::size_t>(face) - 1]) {
      const auto edge = static_cast<std::size_t>(use.id) - 1;
      if (!samples_[edge].pieces.empty())
        edges.push_back(edge);
      else if (use.id > model_.edgesOfFile)
        vertices.insert(ends_[edge].first);  // of a crease that is a point
    }
    std::ranges::sort(edges);
    edges.erase(std::ranges::unique(edges).begin(), edges.end());
    beginnings_.clear();
    std::vector<Box3> boxes;
    for (const std::size_t edge : edges) {
      const auto [first, last] = ends_[edge];
      vertices.insert({first, last});
      beginnings_[first].push_back({edge, last});
      beginnings_[last].push_back({edge, first});
      boxes.push_back(boxOf(samples_[edge]));
    }
    const BoxTree tree(boxes);
    for (const std::uint32_t vertex : vertices) {
      Box3 here;
      here.add(points_[vertex]);
      tree.forEachIn(here, [&](std::uint32_t k) { tryStop(edges[k], vertex); });
    }
  }

  static Box3 boxOf(const EdgeSamples& samples) {
    Box3 box;
    double longest = 0;
    for (const EdgePiece& piece : samples.pieces)
      for (std::size_t i = 0; i < piece.positions.size(); ++i) {
        box.add(piece.positions[i]);
        if (i > 0)
          longest = std::max(longest, distance(piece.positions[i - 1], piece.positions[i]));
      }
    const double margin = EdgeLine::kSag * longest + kMaxBetweenTouching * samples.wanted;
    const Point3 around{margin, margin, margin};
    return {box.low - around, box.high + around};
  }

  void tryStop(std::size_t edge, std::uint32_t vertex) {
    if (!mayBeSplit_[edge] || vertex == ends_[edge].first || vertex == ends_[edge].last) return;
    std::vector<Stop>& stops = stops_[edge];
    if (std::ranges::count(stops, vertex, &Stop::point) > 0) return;
    const double wanted = samples_[edge].wanted;
    const double reach =
        reachOfEdge(model_, static_cast<int>(edge) + 1, toleranceOf(vertex), wanted);
    const EdgeLine line(model_, edge, samples_[edge]);
    const Point3& place = points_[vertex];
    const std::optional<Foot> foot =
        line.footOf(place, std::max(reach, kMaxBetweenTouching * wanted));
    if (!foot) return;
    const double fromEnds = std::min(distance(foot->position, points_[ends_[edge].first]),
                                     distance(foot->position, points_[ends_[edge].last]));
    const bool isOnEdge = foot->distance <= reach
                              ? fromEnds > kFromEnds * reach
                              : fromEnds > foot->distance && isWedge(line, edge, vertex, reach);
    if (isOnEdge && isBetweenEnds(samples_[edge], foot->parameter))
      stops.push_back({atKink(samples_[edge], *foot, std::max(reach, foot->distance)), vertex});
  }

  /// A stop at a kink of the edge is right there: there is a vertex anyway.
  static double atKink(const EdgeSamples& samples, const Foot& foot, double reach) {
    for (std::size_t i = 0; i + 1 < samples.pieces.size(); ++i)
      if (distance(samples.pieces[i].positions.back(), foot.position) <= reach)
        return samples.pieces[i].parameters.back();
    return foot.parameter;
  }

  static bool isBetweenEnds(const EdgeSamples& samples, double parameter) {
    return parameter > samples.pieces.front().parameters.front() &&
           parameter < samples.pieces.back().parameters.back();
  }

  double toleranceOf(std::uint32_t vertex) const {
    const auto count = static_cast<std::uint32_t>(model_.vertices.Extent());
    return vertex < count ? BRep_Tool::Tolerance(model_.vertex(static_cast<int>(vertex) + 1)) : 0;
  }

  /// Whether another edge of the face comes to the vertex from an end of this one, near to it all
  /// the way.
  bool isWedge(const EdgeLine& line, std::size_t edge, std::uint32_t vertex, double reach) const {
    const double wanted = samples_[edge].wanted;
    return std::ranges::any_of(beginnings_.at(vertex), [&](const Beginning& other) {
      const bool isFromEnd =
          other.otherEnd == ends_[edge].first || other.otherEnd == ends_[edge].last;
      if (other.edge == edge || !isFromEnd) return false;
      const Point3& tip = points_[other.otherEnd];
      return std::ranges::all_of(samples_[other.edge].pieces, [&](const EdgePiece& piece) {
        return std::ranges::all_of(piece.positions, [&](const Point3& place) {
          const double most = reachInWedge(reach, wanted, distance(tip, place));
          return line.footOf(place, most).has_value();
        });
      });
    });
  }

  /// Of several stops at nearly the same place of the edge the first one stays.
  void putInOrder(std::size_t edge) {
    std::vector<Stop>& stops = stops_[edge];
    if (stops.size() < 2) return;
    std::ranges::sort(stops, {}, [](const Stop& s) { return std::pair(s.parameter, s.point); });
    const int id = static_cast<int>(edge) + 1;
    const double apart = kFromEnds * reachOfEdge(model_, id, 0, samples_[edge].wanted);
    const BRepAdaptor_Curve curve(model_.edge(id));
    const auto isNear = [&](const Stop& a, const Stop& b) {
      return curve.Value(a.parameter).Distance(curve.Value(b.parameter)) <= apart;
    };
    stops.erase(std::unique(stops.begin(), stops.end(), isNear), stops.end());
  }

  const ModelShape& model_;
  const std::vector<Ends>& ends_;
  const std::vector<EdgeSamples>& samples_;
  const std::vector<Point3>& points_;
  const std::vector<bool>& mayBeSplit_;
  std::map<std::uint32_t, std::vector<Beginning>> beginnings_;  // by point, of one face
  std::vector<std::vector<Stop>> stops_;
};

}  // namespace

double reachOfEdge(const ModelShape& model, int edge, double tolerance, double wanted) {
  constexpr double kBlur = 1e-9;  // of the model
  return std::min(BRep_Tool::Tolerance(model.edge(edge)) + tolerance, kMax * wanted) +
         std::max(kBlur * model.diagonal, kUnseen * wanted);
}

double reachInWedge(double reach, double wanted, double fromVertex) {
  constexpr double kSharp = 0.0087;  // tangent of half a degree
  return std::max(reach, std::min(kMaxBetweenTouching * wanted, kSharp * fromVertex));
}

std::vector<std::vector<Stop>> stopsOf(const ModelShape& model, const std::vector<Ends>& ends,
                                       const std::vector<EdgeSamples>& samples,
                                       const std::vector<Point3>& points,
                                       const std::vector<bool>& mayBeSplit) {
  return StopFinder(model, ends, samples, points, mayBeSplit).find();
}

std::vector<EdgePart> partsBetween(std::size_t edge, EdgeSamples samples, const Ends& ends,
                                   const std::vector<Stop>& stops) {
  std::vector<double> parameters;
  for (const Stop& stop : stops) parameters.push_back(stop.parameter);
  std::vector<EdgeSamples> pieces = split(std::move(samples), parameters);
  std::vector<EdgePart> parts;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    EdgePart& part =
        parts.emplace_back(EdgePart{edge, std::move(pieces[k]), ends, k == 0, k == stops.size()});
    if (!part.isFirst) part.ends.first = stops[k - 1].point;
    if (!part.isLast) part.ends.last = stops[k].point;
  }
  return parts;
}

}  // namespace af2::geometry
