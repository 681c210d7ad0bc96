#include "geometry/mesh/quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <ranges>
#include <utility>

#include "engine/base/elementary.h"
#include "engine/base/parallel.h"
#include "geometry/mesh/mesh_sides.h"
#include "geometry/spool/samples.h"
#include "geometry/spool/spooled_mesh.h"

namespace af2::geometry {
namespace {

/// Where numbers of all elements are kept: where these are themselves.
std::shared_ptr<SpoolFile> spoolOf(const ModelMesh& mesh) {
  return mesh.spooled ? mesh.spooled->file() : nullptr;
}

/// Elements that are looked at together.
constexpr std::size_t kAtOnce = 1 << 15;
using Numbers = std::ranges::iota_view<std::size_t, std::size_t>;

double squared(const Point3& p) { return dot(p, p); }

double triangleQuality(const Point3& a, const Point3& b, const Point3& c) {
  const double edges = squared(b - a) + squared(c - b) + squared(a - c);
  return edges > 0 ? 2 * std::sqrt(3.0) * length(cross(b - a, c - a)) / edges : 0;
}

/// Quality of the corner between the edges `p` and `q` of a quadrilateral with normal `normal`.
double cornerQuality(const Point3& p, const Point3& q, const Point3& normal) {
  const double edges = squared(p) + squared(q);
  if (edges == 0) return 0;
  const Point3 turn = cross(p, q);
  return std::copysign(2 * length(turn) / edges, dot(turn, normal));
}

double quadQuality(const std::array<Point3, 4>& corner) {
  const Point3 normal = cross(corner[2] - corner[0], corner[3] - corner[1]);
  double least = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point3 toNext = corner[(i + 1) % 4] - corner[i];
    const Point3 toLast = corner[(i + 3) % 4] - corner[i];
    least = std::min(least, cornerQuality(toNext, toLast, normal));
  }
  return least;
}

/// The angle at a corner of an element. Angles are compared without being computed.
struct Corner {
  double sine = 0, cosine = 1;  ///< times the lengths of both sides

  Corner(const Point3& p, const Point3& q) : sine(length(cross(p, q))), cosine(dot(p, q)) {}
  double degrees() const { return angleOf({cosine, sine}) * 180 / std::numbers::pi; }
  bool isSharperThan(const Corner& other) const {
    const double turn = other.sine * cosine - sine * other.cosine;
    return turn > 0 || (turn == 0 && cosine > 0 && other.cosine < 0);  // 0 and 180 degrees
  }
};

class Angles {
 public:
  Angles() = default;
  Angles(const MeshSlice& slice, Numbers elements) {
    for (const std::size_t e : elements) {
      const Element& element = slice.elements[e];
      const std::size_t size = element.vertices().size();
      const auto at = [&](std::size_t i) { return slice.position(element.corners[i % size]); };
      for (std::size_t i = 0; i < size; ++i)
        add(Corner(at(i + 1) - at(i), at(i + size - 1) - at(i)));
    }
  }
  void add(const MeshSlice& slice, int threads) {
    const Ranges ranges(slice.elements.size(), kAtOnce);
    takeInOrder(
        ranges.count(), threads, [&](std::size_t i) { return Angles(slice, ranges[i]); },
        [&](const Angles& some) {
          for (const auto& corner : {some.sharpest_, some.bluntest_})
            if (corner) add(*corner);
        });
  }
  void tell(MeshQuality& result) const {
    result.minAngle = sharpest_->degrees();
    result.maxAngle = bluntest_->degrees();
  }

 private:
  void add(const Corner& corner) {
    if (!sharpest_ || corner.isSharperThan(*sharpest_)) sharpest_ = corner;
    if (!bluntest_ || bluntest_->isSharperThan(corner)) bluntest_ = corner;
  }

  std::optional<Corner> sharpest_, bluntest_;
};

class Shapes {
 public:
  explicit Shapes(const ModelMesh& mesh) : values_(spoolOf(mesh)) {
    values_.reserve(elementCount(mesh));
  }

  void add(const MeshSlice& slice, int threads) {
    const Ranges ranges(slice.elements.size(), kAtOnce);
    takeInOrder(
        ranges.count(), threads,
        [&](std::size_t range) {
          std::vector<double> values;
          for (const std::size_t i : ranges[range])
            values.push_back(shapeQuality(slice, slice.elements[i]));
          return values;
        },
        [&, i = std::size_t{0}](const std::vector<double>& values) mutable {
          for (const double value : values) add(slice, i++, value);
        });
  }
  void tell(MeshQuality& result) {
    result.min = worst_.min;
    result.worstFace = worst_.worstFace;
    result.worstPlace = worst_.worstPlace;
    result.mean = values_.mean();
    result.p1 = values_.percentile(0.01);
  }

 private:
  void add(const MeshSlice& slice, std::size_t i, double value) {
    values_.add(value);
    if (hasWorst_ && !(value < worst_.min)) return;
    hasWorst_ = true;
    worst_.min = value;
    worst_.worstFace = slice.face(i);
    worst_.worstPlace = {};
    const auto corners = slice.elements[i].vertices();
    for (const VertexId v : corners)
      worst_.worstPlace =
          worst_.worstPlace + 1.0 / static_cast<double>(corners.size()) * slice.position(v);
  }

  Samples values_;
  bool hasWorst_ = false;
  MeshQuality worst_;  ///< of the first of the worst elements
};

/// An edge of a mesh.
struct MeshEdge {
  VertexId from, to;
  double length = 0, wanted = 0;
  std::size_t uses = 0;
  bool isOfLayer = false;  ///< of no other elements
};

/// Statistics of some edges.
struct EdgeMeasures {
  LengthRatio lengths{.leastWanted = std::numeric_limits<double>::infinity(),
                      .leastLength = std::numeric_limits<double>::infinity()};
  std::vector<double> ratios;     ///< in the order of the edges
  std::vector<MeshEdge> between;  ///< edges of which other faces may have elements, not counted yet
  std::size_t free = 0;

  void add(const MeshEdge& edge, bool hasSizes) {
    free += edge.uses == 1;
    if (!hasSizes || edge.isOfLayer) return;
    lengths.leastLength = std::min(lengths.leastLength, edge.length);
    lengths.mostLength = std::max(lengths.mostLength, edge.length);
    lengths.leastWanted = std::min(lengths.leastWanted, edge.wanted);
    lengths.mostWanted = std::max(lengths.mostWanted, edge.wanted);
    const double ratio = edge.length / edge.wanted;
    ratios.push_back(ratio);
    const auto bin = std::ranges::upper_bound(LengthRatio::kBounds, ratio);
    ++lengths.histogram[static_cast<std::size_t>(bin - LengthRatio::kBounds.begin())];
  }
};

/// Counts edges and measures their lengths.
class Edges {
 public:
  explicit Edges(const ModelMesh& mesh)
      : mesh_(mesh),
        hasLayers_(!mesh.ruleNames.empty() && mesh.ruleNames.back() == kLayerName),
        hasSizes_(!mesh.wantedSizes.empty()),
        ratios_(spoolOf(mesh)) {
    // Each element has half of its sides.
    if (hasSizes_)
      ratios_.reserve((3 * elementCount(mesh) + quadCount(mesh)) / 2 + mesh.segments.size());
  }

  /// The whole mesh.
  void addAll(const MeshSlice& slice, int threads) {
    takeBlocks(slice.vertices.size(), slice.elements, threads,
               [&](VertexId from, std::span<const MeshSide> used, EdgeMeasures& edges) {
                 edges.add(edgeOf(from, VertexId(used.front().to), used, slice), hasSizes_);
               });
  }

  /// A face of a mesh on disk. Edges between shared vertices may be those of other faces, too.
  void add(const MeshSlice& slice, int threads) {
    std::vector<std::uint32_t> shared;
    for (const Element& element : slice.elements)
      for (const VertexId v : element.vertices())
        if (v.value < slice.firstVertex) shared.push_back(v.value);
    std::ranges::sort(shared);
    shared.erase(std::ranges::unique(shared).begin(), shared.end());
    const std::size_t count = shared.size();
    std::vector<Element> elements(slice.elements.begin(), slice.elements.end());
    for (Element& element : elements)
      for (VertexId& v : element.corners)
        if (!v.isNone())
          v = v.value < slice.firstVertex
                  ? VertexId(static_cast<std::size_t>(std::ranges::lower_bound(shared, v.value) -
                                                      shared.begin()))
                  : VertexId(count + v.value - slice.firstVertex);
    const auto inMesh = [&](std::uint32_t v) {
      return VertexId(v < count ? shared[v] : v - count + slice.firstVertex);
    };
    takeBlocks(count + slice.vertices.size(), elements, threads,
               [&](VertexId from, std::span<const MeshSide> used, EdgeMeasures& edges) {
                 const VertexId to(used.front().to);
                 const MeshEdge edge = edgeOf(inMesh(from.value), inMesh(to.value), used, slice);
                 if (to.value < count)
                   edges.between.push_back(edge);
                 else
                   edges.add(edge, hasSizes_);
               });
  }

  void tell(MeshQuality& result) {
    addBetween();
    result.freeEdges = all_.free;
    if (ratios_.count() == 0) return;
    all_.lengths.mean = ratios_.mean();
    all_.lengths.p5 = ratios_.percentile(0.05);
    all_.lengths.p95 = ratios_.percentile(0.95);
    result.edges = all_.lengths;
  }

 private:
  MeshEdge edgeOf(VertexId from, VertexId to, std::span<const MeshSide> used,
                  const MeshSlice& slice) const {
    MeshEdge edge{from, to, distance(slice.position(from), slice.position(to))};
    if (hasSizes_) edge.wanted = (slice.wantedSize(from) + slice.wantedSize(to)) / 2;
    edge.uses = used.size();
    edge.isOfLayer = hasLayers_ && std::ranges::all_of(used, [&](const MeshSide& side) {
                       return isOfLayer(slice, side.element());
                     });
    return edge;
  }

  /// Layers have the heights that were asked for, not the sizes.
  bool isOfLayer(const MeshSlice& slice, std::size_t element) const {
    return element < slice.origins.size() &&
           slice.origins[element].rule + std::size_t{1} == mesh_.ruleNames.size();
  }

  /// measure(from, sides, edges) adds an edge of the elements to `edges`.
  template <class Measure>
  void takeBlocks(std::size_t vertices, std::span<const Element> elements, int threads,
                  const Measure& measure) {
    const VertexBlocks blocks(vertices, elements, threads);
    takeInOrder(
        blocks.count(), threads,
        [&](std::size_t block) {
          std::vector<std::size_t> some;
          blocks.forEachElementAt(block, [&](std::size_t i) { some.push_back(i); });
          const MeshSides sides(blocks[block], elements, some,
                                [](std::uint32_t, std::uint32_t) { return true; });
          EdgeMeasures edges;
          sides.forEachEdge(
              [&](VertexId from, std::span<const MeshSide> used) { measure(from, used, edges); });
          return edges;
        },
        [&](const EdgeMeasures& edges) { take(edges); });
  }

  void take(const EdgeMeasures& some) {
    for (const double ratio : some.ratios) ratios_.add(ratio);
    between_.insert(between_.end(), some.between.begin(), some.between.end());
    all_.free += some.free;
    LengthRatio& all = all_.lengths;
    all.leastLength = std::min(all.leastLength, some.lengths.leastLength);
    all.mostLength = std::max(all.mostLength, some.lengths.mostLength);
    all.leastWanted = std::min(all.leastWanted, some.lengths.leastWanted);
    all.mostWanted = std::max(all.mostWanted, some.lengths.mostWanted);
    for (std::size_t i = 0; i < all.histogram.size(); ++i)
      all.histogram[i] += some.lengths.histogram[i];
  }

  void addBetween() {
    const auto ends = [](const MeshEdge& edge) { return std::pair(edge.from, edge.to); };
    std::ranges::stable_sort(between_, {}, ends);
    EdgeMeasures merged;
    for (std::size_t i = 0, next = 0; i < between_.size(); i = next) {
      MeshEdge edge = between_[i];
      for (next = i + 1; next < between_.size() && ends(between_[next]) == ends(edge); ++next) {
        edge.uses += between_[next].uses;
        edge.isOfLayer = edge.isOfLayer && between_[next].isOfLayer;
      }
      merged.add(edge, hasSizes_);
    }
    take(merged);
    between_.clear();
  }

  const ModelMesh& mesh_;
  bool hasLayers_, hasSizes_;
  Samples ratios_;                 ///< nothing else is kept for each edge: there are millions
  EdgeMeasures all_;               ///< without their ratios and what is between faces
  std::vector<MeshEdge> between_;  ///< between shared vertices, of one face each
};

void measureInMemory(const ModelMesh& mesh, int threads, MeshQuality& result) {
  forEachSlice(mesh, [&](const MeshSlice& whole) {
    forEachInParallel(3, threads, [&](std::size_t part) {
      if (part == 0) {
        Edges edges(mesh);
        edges.addAll(whole, threads);
        edges.tell(result);
      }
      if (part == 1) {
        Shapes shapes(mesh);
        shapes.add(whole, threads);
        shapes.tell(result);
      }
      if (part == 2) {
        Angles angles;
        angles.add(whole, threads);
        angles.tell(result);
      }
    });
  });
}

void measureOnDisk(const ModelMesh& mesh, int threads, MeshQuality& result) {
  Edges edges(mesh);
  Shapes shapes(mesh);
  Angles angles;
  forEachSlice(mesh, [&](const MeshSlice& slice) {
    edges.add(slice, threads);
    shapes.add(slice, threads);
    angles.add(slice, threads);
  });
  edges.tell(result);
  shapes.tell(result);
  angles.tell(result);
}

/// The quality of a triangle or quadrilateral by its corners.
template <class At>
double qualityOf(const Element& element, const At& at) {
  const auto& [a, b, c, d] = element.corners;
  if (!element.isQuad()) return triangleQuality(at(a), at(b), at(c));
  return quadQuality({at(a), at(b), at(c), at(d)});
}

}  // namespace

double shapeQuality(const std::vector<Point3>& vertices, const Element& element) {
  return qualityOf(element, [&](VertexId v) { return vertices[v.value]; });
}

double shapeQuality(const MeshSlice& slice, const Element& element) {
  return qualityOf(element, [&](VertexId v) { return slice.position(v); });
}

MeshQuality measureQuality(const ModelMesh& mesh, int threads) {
  MeshQuality result;
  if (elementCount(mesh) == 0) return result;
  if (mesh.spooled)
    measureOnDisk(mesh, threads, result);
  else
    measureInMemory(mesh, threads, result);
  return result;
}

double percentile(std::span<double> values, double part) { return percentileOf(values, part); }

}  // namespace af2::geometry
