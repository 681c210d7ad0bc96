#include "geometry/occ/edge_division.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "engine/error.h"
#include "geometry/occ/edge_samples.h"
#include "geometry/occ/given_points.h"
#include "geometry/occ/open_ends.h"
#include "geometry/occ/parallel.h"
#include "geometry/occ/points.h"
#include "geometry/occ/sizing.h"
#include "geometry/occ/twin_edges.h"

namespace af2::geometry {

namespace {

/// An edge that is shorter than this share of the wanted size, and than the tolerances of its
/// vertices, is taken for one point.
constexpr double kPointLike = 1e-3;
/// So is one that is shorter than this share of the model, where coordinates blur, or than nothing
/// can be seen, whatever the tolerances say.
constexpr double kBlur = 1e-10;

/// Vertices with tolerances beyond this share of the model are damaged.
constexpr double kMostTolerance = 0.01;

/// Which points were found to be the same.
class Merging {
 public:
  explicit Merging(const std::vector<Point3>& points) : parent_(points.size()) {
    std::iota(parent_.begin(), parent_.end(), 0u);
    for (const Point3& point : points) boxes_.push_back({point, point});
  }
  std::uint32_t find(std::uint32_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }
  void merge(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    const auto [low, high] = std::minmax(a, b);
    boxes_[low] = around(boxes_[low], boxes_[high]);
    parent_[high] = low;
  }
  /// How far apart the points are that would be one if these two were.
  double extent(std::uint32_t a, std::uint32_t b) const {
    const Box box = around(boxes_[find(a)], boxes_[find(b)]);
    return distance(box.low, box.high);
  }

 private:
  struct Box {
    Point3 low, high;
  };
  static Box around(const Box& a, const Box& b) {
    return {
        {std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)},
        {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)}};
  }

  std::vector<std::uint32_t> parent_;
  std::vector<Box> boxes_;  // by root
};

class Division {
 public:
  Division(const ModelShape& model, const ModelSizes& sizes, int threads, std::stop_token stop,
           const EdgePoints& given)
      : model_(model),
        sizes_(sizes),
        given_(given),
        samples_(static_cast<std::size_t>(model.edges.Extent())) {
    sampleAll(threads, stop);
    findEnds();
    mergePoints();
    gradeAll();
  }

  DividedEdges result() {
    const std::vector<std::size_t> least = leastSegments();
    twins_ = twinsOf(model_, ends_, samples_);
    for (std::size_t i = 0; i < samples_.size(); ++i) divideEdge(i, least[i]);
    return std::move(result_);
  }

 private:
  void sampleAll(int threads, const std::stop_token& stop) {
    TopTools_IndexedDataMapOfShapeListOfShape faces;
    TopExp::MapShapesAndUniqueAncestors(model_.shape, TopAbs_EDGE, TopAbs_FACE, faces);
    forEachInParallel(samples_.size(), threads, [&](std::size_t i) {
      if (!stop.stop_requested())
        samples_[i] = sampleEdge(model_, static_cast<int>(i) + 1, faces, sizes_);
    });
  }

  void findEnds() {
    for (int id = 1; id <= model_.vertices.Extent(); ++id)
      result_.points.push_back(toPoint(BRep_Tool::Pnt(model_.vertex(id))));
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const TopoDS_Edge edge =
          TopoDS::Edge(model_.edge(static_cast<int>(i) + 1).Oriented(TopAbs_FORWARD));
      ends_.push_back(endsOf(edge, samples_[i]));
    }
  }

  /// An edge may lack vertices, e.g. a full circle; it then gets points of its own.
  Ends endsOf(const TopoDS_Edge& edge, const EdgeSamples& samples) {
    const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
    Ends ends;
    ends.first = first.IsNull() ? addPoint(samples.start) : indexOf(first);
    const bool closed = distance(samples.start, samples.end) <= 1e-9 * model_.diagonal;
    if (!last.IsNull())
      ends.last = indexOf(last);
    else
      ends.last = closed ? ends.first : addPoint(samples.end);
    return ends;
  }

  std::uint32_t indexOf(const TopoDS_Vertex& vertex) const {
    return static_cast<std::uint32_t>(model_.vertices.FindIndex(vertex) - 1);
  }
  std::uint32_t addPoint(const Point3& point) {
    result_.points.push_back(point);
    return static_cast<std::uint32_t>(result_.points.size() - 1);
  }

  /// How long an edge may be to be taken for a point.
  double pointLength(std::size_t i) const {
    const EdgeSamples& samples = samples_[i];
    const double unseen = std::max(kBlur * model_.diagonal, kUnseen * samples.wanted);
    const TopoDS_Edge edge = model_.edge(static_cast<int>(i) + 1);
    const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
    if (first.IsNull() || last.IsNull()) return unseen;
    const double tolerance = std::max(BRep_Tool::Tolerance(first), BRep_Tool::Tolerance(last));
    return std::max(unseen, std::min(tolerance, kPointLike * samples.wanted));
  }

  /// What is given from outside is taken as it is.
  bool mayBePoint(std::size_t i) const {
    return samples_[i].length <= pointLength(i) && !given_.contains(static_cast<int>(i) + 1);
  }

  /// The shortest first. Many short edges one after the other may make a long one, which is none.
  void mergeAlongShortEdges(Merging& merging) {
    std::vector<std::size_t> edges;
    for (std::size_t i = 0; i < samples_.size(); ++i)
      if (samples_[i].problem.empty() && (samples_[i].pieces.empty() || mayBePoint(i)))
        edges.push_back(i);
    std::ranges::stable_sort(edges, {}, [&](std::size_t i) { return samples_[i].length; });
    for (const std::size_t i : edges) {
      const Ends ends = ends_[i];
      const bool isPoint =
          samples_[i].pieces.empty() || merging.find(ends.first) == merging.find(ends.last);
      if (!isPoint && merging.extent(ends.first, ends.last) > 2 * pointLength(i)) continue;
      samples_[i].pieces.clear();
      merging.merge(ends.first, ends.last);
    }
  }

  void mergePoints() {
    Merging merging(result_.points);
    mergeAlongShortEdges(merging);
    apply(merging);
    for (const auto& [end, start] : gaps()) merging.merge(end, start);
    apply(merging);
  }

  void apply(const Merging& merging) {
    for (Ends& ends : ends_) ends = {merging.find(ends.first), merging.find(ends.last)};
  }

  std::vector<std::pair<std::uint32_t, std::uint32_t>> gaps() const {
    const double blur = std::min(kBlur * model_.diagonal, kPointLike * sizes_.size);
    std::vector<double> tolerance(result_.points.size(), blur);
    for (int id = 1; id <= model_.vertices.Extent(); ++id)
      tolerance[static_cast<std::size_t>(id) - 1] +=
          std::min(BRep_Tool::Tolerance(model_.vertex(id)), kMostTolerance * model_.diagonal);
    std::vector<bool> isUsed;
    for (const EdgeSamples& samples : samples_) isUsed.push_back(!samples.pieces.empty());
    return gapsInWires(model_, ends_, isUsed, result_.points, tolerance);
  }

  /// Sizes at shared ends agree, and grow from there no faster than wanted.
  void gradeAll() {
    constexpr int kRounds = 3;  // a short edge passes a small size on to the edges beyond it
    std::vector<double> atPoint(result_.points.size(), 1e300);
    for (const auto& [edge, points] : given_) limitBesideGiven(edge, points, atPoint);
    for (int round = 0; round < kRounds; ++round) {
      for (std::size_t i = 0; i < samples_.size(); ++i) {
        if (samples_[i].pieces.empty() || given_.contains(static_cast<int>(i) + 1)) continue;
        double &first = atPoint[ends_[i].first], &last = atPoint[ends_[i].last];
        gradeSizes(samples_[i], first, last, sizes_.growth);
        first = std::min(first, samples_[i].pieces.front().sizes.front());
        last = std::min(last, samples_[i].pieces.back().sizes.back());
      }
    }
  }

  /// The edges beyond the ends of a given one are to go on from its segments there.
  void limitBesideGiven(int edge, const std::vector<Point3>& points,
                        std::vector<double>& atPoint) const {
    const Ends ends = ends_[static_cast<std::size_t>(edge) - 1];
    for (const std::uint32_t end : {ends.first, ends.last}) {
      if (points.empty()) continue;
      const Point3& place = result_.points[end];
      const double segment =
          std::min(distance(place, points.front()), distance(place, points.back()));
      atPoint[end] = std::min(atPoint[end], bounded(sizes_, segment));
    }
  }

  std::vector<std::size_t> leastSegments() const {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> sameEnds;
    const auto key = [&](std::size_t i) { return std::minmax(ends_[i].first, ends_[i].last); };
    for (std::size_t i = 0; i < samples_.size(); ++i)
      if (!samples_[i].pieces.empty()) ++sameEnds[key(i)];
    std::vector<std::size_t> least;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (ends_[i].first == ends_[i].last)
        least.push_back(3);
      else
        least.push_back(sameEnds[key(i)] > 1 ? 2 : 1);
    }
    return least;
  }

  /// Takes the points that are given for an edge, in its own direction.
  DividedEdge takeGiven(std::size_t i, std::size_t least, const std::vector<Point3>& points) {
    const int id = static_cast<int>(i) + 1;
    GivenPoints given = placeOnEdge(model_, id, points, samples_[i].length);
    if (given.points.size() + 1 < least)
      throw InputError("the points given for edge " + std::to_string(id) + " make " +
                       std::to_string(given.points.size() + 1) + " segments; it needs at least " +
                       std::to_string(least) + ", or it would share a segment");
    DividedEdge edge;
    edge.parameters = std::move(given.parameters);
    edge.points.push_back(ends_[i].first);
    for (const Point3& point : given.points) edge.points.push_back(addPoint(point));
    edge.points.push_back(ends_[i].last);
    return edge;
  }

  /// The vertices between the ends of an edge that runs along an earlier one are those of that one.
  bool takeFromTwin(std::size_t i, std::size_t twin) {
    const DividedEdge& other = result_.edges[twin];
    std::vector<std::uint32_t> inner(other.points.begin() + 1, other.points.end() - 1);
    std::vector<Point3> positions;
    for (const std::uint32_t p : inner) positions.push_back(result_.points[p]);
    DividedEdge edge;
    try {
      GivenPoints placed =
          placeOnEdge(model_, static_cast<int>(i) + 1, positions, samples_[i].length);
      if (!(placed.points == positions)) std::ranges::reverse(inner);
      edge.parameters = std::move(placed.parameters);
    } catch (const InputError&) {
      return false;  // they part somewhere
    }
    edge.points.push_back(ends_[i].first);
    edge.points.insert(edge.points.end(), inner.begin(), inner.end());
    edge.points.push_back(ends_[i].last);
    addEdge(i, std::move(edge));
    return true;
  }

  void divideEdge(std::size_t i, std::size_t least) {
    const auto given = given_.find(static_cast<int>(i) + 1);
    if (given != given_.end() && !samples_[i].pieces.empty()) {
      addEdge(i, takeGiven(i, least, given->second));
      return;
    }
    if (twins_[i] && takeFromTwin(i, *twins_[i])) return;
    DividedEdge edge;
    edge.problem = samples_[i].problem;
    if (!samples_[i].pieces.empty()) {
      edge.parameters = divide(samples_[i], least);
      const BRepAdaptor_Curve curve(model_.edge(static_cast<int>(i) + 1));
      edge.points.push_back(ends_[i].first);
      for (std::size_t k = 1; k + 1 < edge.parameters.size(); ++k)
        edge.points.push_back(addPoint(toPoint(curve.Value(edge.parameters[k]))));
      edge.points.push_back(ends_[i].last);
    }
    addEdge(i, std::move(edge));
  }

  void addEdge(std::size_t i, DividedEdge edge) {
    edge.unseen = kUnseen * samples_[i].wanted;
    result_.edges.push_back(std::move(edge));
  }

  const ModelShape& model_;
  const ModelSizes& sizes_;
  const EdgePoints& given_;
  std::vector<EdgeSamples> samples_;
  std::vector<Ends> ends_;
  std::vector<std::optional<std::size_t>> twins_;
  DividedEdges result_;
};

}  // namespace

std::size_t DividedEdges::segmentCount() const {
  std::size_t count = 0;
  for (const DividedEdge& edge : edges)
    if (!edge.points.empty()) count += edge.points.size() - 1;
  return count;
}

DividedEdges divideEdges(const ModelShape& model, const ModelSizes& sizes, int threads,
                         std::stop_token stop, const EdgePoints& given) {
  return Division(model, sizes, threads, std::move(stop), given).result();
}

}  // namespace af2::geometry
